// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/write_image.h"

#include <OpenImageIO/imageio.h>

#include <filesystem>

#include "host/error.h"
#include "host/render/messages.h"
#include "host/render/output_file.h"

namespace dynrt::host {

namespace {

constexpr int kChannels = 3;

std::vector<std::uint8_t> bytes_of(const Frame& frame) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(frame.pixels.size() * kChannels);
  for (const std::uint32_t pixel : frame.pixels) {
    for (int channel = 0; channel < kChannels; ++channel) {
      bytes.push_back(static_cast<std::uint8_t>(pixel >> (8 * channel)));
    }
  }
  return bytes;
}

}  // namespace

void check_image_path(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".png" && extension != ".exr") {
    refuse(messages::kExtension, path, extension);
  }
  check_output_path(path);
}

void write_image(const std::string& path, const Frame& frame) {
  check_image_path(path);
  write_whole(path, [&](const std::string& temporary) {
    const auto output = OIIO::ImageOutput::create(temporary);
    const bool exr = temporary.ends_with(".exr");
    OIIO::ImageSpec spec(static_cast<int>(frame.width), static_cast<int>(frame.height), kChannels,
                         exr ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
    spec.attribute("Software", "dynrt");
    const std::vector<std::uint8_t> bytes = bytes_of(frame);
    if (!output || !output->open(temporary, spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) || !output->close()) {
      cannot_write(path, output ? output->geterror() : OIIO::geterror());
    }
    if (!exr) check_end(temporary, kPngEnd, path);
  });
}

}  // namespace dynrt::host
