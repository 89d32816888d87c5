// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/write_image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

#include "host/error.h"
#include "host/render/messages.h"

namespace dynrt::host {

namespace {

namespace fs = std::filesystem;

constexpr int kChannels = 3;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A hidden name beside `path`, of this process, with the same extension.
fs::path temporary_for(const fs::path& path) {
  return folder_of(path) /
         fmt::format(".{}.{}{}", path.stem().string(), getpid(), path.extension().string());
}

[[noreturn]] void cannot_write(const fs::path& path, const std::string& reason) {
  refuse(messages::kCannotWrite, path.string(), reason);
}

/// Calls `write` with a name beside `path` and renames what it wrote; removes it on an error.
void write_whole(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const fs::path temporary = temporary_for(path);
  std::error_code ignored;
  try {
    write(temporary);
    fs::rename(temporary, path);
  } catch (const fs::filesystem_error& error) {
    fs::remove(temporary, ignored);
    cannot_write(path, error.code().message());
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
}

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

void check_output_path(const std::string& path) {
  const fs::path folder = folder_of(path);
  if (!fs::is_directory(folder)) {
    refuse(messages::kNoFolder, path, folder.string());
  }
  if (fs::is_directory(path)) cannot_write(path, std::strerror(EISDIR));
  // Only trying tells: a folder may be read-only for reasons that its permissions do not show.
  const fs::path probe = temporary_for(path);
  if (!std::ofstream(probe)) cannot_write(path, std::strerror(errno));
  fs::remove(probe);
}

void check_image_path(const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  if (extension != ".png" && extension != ".exr") {
    refuse(messages::kExtension, path, extension);
  }
  check_output_path(path);
}

void write_image(const std::string& path, const Frame& frame) {
  check_image_path(path);
  write_whole(path, [&](const fs::path& temporary) {
    const auto output = OIIO::ImageOutput::create(temporary.string());
    const bool exr = temporary.extension() == ".exr";
    OIIO::ImageSpec spec(static_cast<int>(frame.width), static_cast<int>(frame.height), kChannels,
                         exr ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
    spec.attribute("Software", "dynrt");
    const std::vector<std::uint8_t> bytes = bytes_of(frame);
    if (!output || !output->open(temporary.string(), spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) || !output->close()) {
      cannot_write(path, output ? output->geterror() : OIIO::geterror());
    }
  });
}

void write_text(const std::string& path, const std::string& text) {
  check_output_path(path);
  write_whole(path, [&](const fs::path& temporary) {
    std::ofstream file(temporary);
    file << text;
    file.close();
    if (!file) cannot_write(path, std::strerror(errno));
  });
}

}  // namespace dynrt::host
