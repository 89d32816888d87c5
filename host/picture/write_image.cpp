// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/picture/write_image.h"

#include "host/picture/image_library.h"
#include "host/picture/output_file.h"

namespace dynrt::host {

void write_image(const std::string& path, const PictureView& picture) {
  write_whole(path, [&](const std::string& temporary) {
    image_library().write(temporary, path, picture);
    if (temporary.ends_with(".png")) check_end(temporary, kPngEnd, path);
  });
}

}  // namespace dynrt::host
