// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Pictures as image files. PNG holds the core's bytes as they are; EXR holds the same colours as
// numbers 0 to 1.
#pragma once

#include <string>
#include <string_view>

#include "host/picture/picture_view.h"

namespace dynrt::host {

/// The chunk that ends a PNG file.
inline constexpr std::string_view kPngEnd = "IEND\xae\x42\x60\x82";

/// Throws UserError if the file cannot be written.
void write_image(const std::string& path, const PictureView& picture);

}  // namespace dynrt::host
