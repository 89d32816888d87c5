// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/picture/gif.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "host/picture/image_library.h"
#include "host/picture/output_file.h"
#include "host/picture/write_image.h"

namespace dynrt::host {

namespace {

constexpr double kHundredths = 100;  // of a second
constexpr double kShortest = 2;      // of them, that a picture is shown

constexpr std::string_view kGifEnd = std::string_view("\0;", 2);

}  // namespace

void write_gif(const std::string& path, std::span<const std::string> pictures,
               double pictures_per_second) {
  // OpenImageIO drops fractions of a hundredth: adding half of one makes it round.
  const double hundredths = std::max(kShortest, std::round(kHundredths / pictures_per_second));
  const auto rate = static_cast<float>(kHundredths / (hundredths + 0.5));
  write_whole(path, [&](const std::string& temporary) {
    image_library().write_gif(temporary, path, pictures, rate);
    check_end(temporary, kGifEnd, path);
  });
}

bool is_whole_picture(const std::string& path, unsigned width, unsigned height) {
  // libpng would complain on the terminal about one that is cut off.
  return ends_with(path, kPngEnd) && image_library().size_of(path) == PictureSize{width, height};
}

}  // namespace dynrt::host
