// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The window as one file that opens from disk: the page with a frame, and all answers that the
// program would give about it. page/recorded.js takes the answers from the file.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "host/view/full_picture.h"
#include "host/view/loaded_scene.h"
#include "host/view/page_files.h"

namespace dynrt::host {

/// The largest file.
inline constexpr std::size_t kMostRecordedBytes = 20'000'000;

/// The most pixels that can fit into such a file; in many scenes fewer do.
inline constexpr std::size_t kMostRecordedPixels = 160'000;

/// Throws UserError for a picture that cannot fit.
void check_recorded_size(unsigned width, unsigned height);

/// The file's text. The frame must have been watched; `start` and `machine` are the answers to
/// these questions. Throws UserError if it would be too large.
std::string recorded_page(const std::map<std::string, PageFile>& files, const LoadedScene& loaded,
                          const FullPicture& picture, const Json& start, const Json& frame,
                          const Json& machine);

}  // namespace dynrt::host
