// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The functions that dynrt needs of OpenImageIO. That library loads 250 others, which takes a third
// of a second at the start. So our own library (openimageio.cpp) contains all calls to it, and the
// program loads it when it writes or reads the first picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "host/picture/picture_view.h"

namespace dynrt::host {

struct PictureSize {
  unsigned width = 0;
  unsigned height = 0;
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// Between two pictures, of their levels as numbers 0 to 1.
struct PictureDifference {
  double mean = 0.0;
  double rms = 0.0;
  double psnr = 0.0;  ///< infinite where nothing differs
  double largest = 0.0;
  std::uint64_t beyond = 0;  ///< pixels that differ by more than the limit
};

/// Red, green and blue as amounts of light, 0 to 1 unless the file's numbers are above 1; or the
/// reason why there are none.
struct MeanColour {
  std::array<double, 3> linear{};
  std::string error;
};

/// All throw UserError when a file cannot be written; `path` is its name in the message.
class ImageLibrary {
 public:
  /// The file's extension gives its format.
  virtual void write(const std::string& file, const std::string& path,
                     const PictureView& picture) const = 0;

  /// Throws UserError, too, when one of the pictures cannot be read.
  virtual void write_gif(const std::string& file, const std::string& path,
                         std::span<const std::string> pictures, float per_second) const = 0;

  /// Nothing when the file is no picture of three channels that can be read to its end.
  virtual std::optional<PictureSize> size_of(const std::string& file) const = 0;

  /// Both of the same size.
  virtual PictureDifference difference(const PictureView& expected, const PictureView& found,
                                       float beyond) const = 0;

  /// Of the content of an image file of any format. Levels that are integers follow the sRGB curve.
  virtual MeanColour mean_colour(std::span<const std::uint8_t> content) const = 0;

 protected:
  ~ImageLibrary() = default;
};

/// Throws UserError if the file is missing or no such library.
const ImageLibrary& load_image_library(const std::string& path);

/// Loads it at the first call; throws UserError if it cannot be loaded. Looks for it in the
/// program's folder, in ../lib/dynrt from there, and in the build.
const ImageLibrary& image_library();

/// The name of the function, without parameters, by which the library hands out its ImageLibrary.
inline constexpr char kImageLibraryFunction[] = "dynrt_image_library";

}  // namespace dynrt::host
