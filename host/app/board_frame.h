// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A prepared scene on a board of this build, with progress on the terminal.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "host/app/prepare.h"
#include "host/app/progress.h"
#include "host/render/render.h"

namespace dynrt::host {

/// A request without a configuration gets the default one, or that which the board holds. Throws
/// UserError if this build or the board's configuration lacks a part that the frame needs.
std::unique_ptr<Board> open_board(const BoardRequest& request, const FrameOptions& options);

/// A progress line for a frame on a board, and for the transfers on the board's line.
class BoardProgress {
 public:
  BoardProgress(Board& board, std::string what, std::uint64_t pixels);
  ~BoardProgress() { board_.report_transfers({}); }
  BoardProgress(const BoardProgress&) = delete;
  BoardProgress& operator=(const BoardProgress&) = delete;
  PixelProgress pixels();

 private:
  Board& board_;
  Progress progress_;
};

/// With progress on the terminal.
Frame render_on(Board& board, const FrameOptions& options, const MemoryImage& image);

/// The image's file: the one that the user names, or the scene's name with .png in this folder.
std::string image_name(const std::string& out, const std::string& scene);

}  // namespace dynrt::host
