// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/gif.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "host/error.h"
#include "host/render/messages.h"
#include "host/render/output_file.h"
#include "host/render/write_image.h"

namespace dynrt::host {

namespace {

constexpr int kChannels = 3;
constexpr double kHundredths = 100;  // of a second
constexpr double kShortest = 2;      // of them, that a picture is shown

struct Picture {
  OIIO::ImageSpec spec;
  std::vector<std::uint8_t> bytes;
};

constexpr std::string_view kGifEnd = std::string_view("\0;", 2);

/// False where there is none or it ends too early.
bool read(const std::string& path, Picture& picture) {
  std::error_code missing;
  if (!std::filesystem::is_regular_file(path, missing)) return false;
  const auto input = OIIO::ImageInput::open(path);
  if (!input) {
    OIIO::geterror();  // else it is printed at the program's end
    return false;
  }
  picture.spec = input->spec();
  if (picture.spec.nchannels != kChannels) return false;
  picture.bytes.resize(picture.spec.image_pixels() * kChannels);
  const bool whole =
      input->read_image(0, 0, 0, kChannels, OIIO::TypeDesc::UINT8, picture.bytes.data());
  input->geterror();
  return whole;
}

}  // namespace

void write_gif(const std::string& path, std::span<const std::string> pictures,
               double pictures_per_second) {
  // OpenImageIO cuts off what is left of a hundredth: half of one keeps it from cutting too much.
  const double hundredths = std::max(kShortest, std::round(kHundredths / pictures_per_second));
  const auto rate = static_cast<float>(kHundredths / (hundredths + 0.5));
  write_whole(path, [&](const std::string& temporary) {
    const auto output = OIIO::ImageOutput::create(temporary);
    if (!output) cannot_write(path, OIIO::geterror());
    Picture picture;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      if (!read(pictures[i], picture)) refuse(messages::kNotAPicture, pictures[i]);
      OIIO::ImageSpec spec(picture.spec.width, picture.spec.height, kChannels,
                           OIIO::TypeDesc::UINT8);
      spec.attribute("FramesPerSecond", rate);
      const auto mode = i == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage;
      if (!output->open(temporary, spec, mode) ||
          !output->write_image(OIIO::TypeDesc::UINT8, picture.bytes.data())) {
        cannot_write(path, output->geterror());
      }
    }
    if (!output->close()) cannot_write(path, output->geterror());
    check_end(temporary, kGifEnd, path);
  });
}

bool is_whole_picture(const std::string& path, unsigned width, unsigned height) {
  Picture picture;
  // libpng would complain on the terminal about one that is cut off.
  return ends_with(path, kPngEnd) && read(path, picture) &&
         picture.spec.width == static_cast<int>(width) &&
         picture.spec.height == static_cast<int>(height);
}

}  // namespace dynrt::host
