// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Joins pictures to a GIF that repeats for ever, and checks whether a picture of an earlier run can
// be used.
#pragma once

#include <span>
#include <string>

namespace dynrt::host {

/// Joins image files of the same size. A GIF counts time in hundredths of a second, and two of them
/// are the least that viewers keep to. Throws UserError if a picture cannot be read or the GIF
/// cannot be written.
void write_gif(const std::string& path, std::span<const std::string> pictures,
               double pictures_per_second);

/// Whether the file is a PNG picture of this size that can be read to its end.
bool is_whole_picture(const std::string& path, unsigned width, unsigned height);

}  // namespace dynrt::host
