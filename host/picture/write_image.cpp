// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/picture/write_image.h"

#include <filesystem>

#include "host/error.h"
#include "host/picture/image_library.h"
#include "host/picture/output_file.h"

namespace dynrt::host {

void check_image_path(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".png" && extension != ".exr") {
    refuse("{}: dynrt does not write the image format '{}'; the name must end in .png or .exr",
           path, extension);
  }
  check_output_path(path);
}

void write_image(const std::string& path, const PictureView& picture) {
  check_image_path(path);
  write_whole(path, [&](const std::string& temporary) {
    image_library().write(temporary, path, picture);
    if (temporary.ends_with(".png")) check_end(temporary, kPngEnd, path);
  });
}

}  // namespace dynrt::host
