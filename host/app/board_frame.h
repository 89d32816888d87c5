// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A prepared scene on a board of this build, with progress on the terminal.
#pragma once

#include <memory>

#include "host/app/prepare.h"
#include "host/render/render.h"

namespace dynrt::host {

/// A request without a configuration gets the default one, or that which the board holds. Throws
/// UserError if this build or the board's configuration lacks a part that the frame needs.
std::unique_ptr<Board> open_board(const BoardRequest& request, const FrameOptions& options);

/// With progress on the terminal.
Frame render_on(Board& board, const FrameOptions& options, const MemoryImage& image);

/// The image's file: the one that the user names, or the scene's name with .png in this folder.
std::string image_name(const std::string& out, const std::string& scene);

}  // namespace dynrt::host
