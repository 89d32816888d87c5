// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A prepared scene on a board of this build: rendered, with progress on the terminal, and shown on
// the board's VGA display.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "host/app/prepare.h"
#include "host/app/progress.h"
#include "host/app/specialised.h"
#include "host/render/render.h"

namespace dynrt::host {

/// A request without a configuration gets the default one, or that which the board holds. Throws
/// UserError if this build or the board's configuration lacks a part that the frame needs.
std::unique_ptr<Board> open_board(const BoardRequest& request, const FrameOptions& options);

/// A board, and a scene in its memory.
struct OnBoard {
  std::unique_ptr<Board> board;
  Prepared prepared;
};

/// Opens the board of the request and lays the scene out for it.
OnBoard on_board(const BoardRequest& request, const FrameOptions& options, SceneFile& scene,
                 const TreeOptions& trees = {});
/// The same with the chosen configuration, or the general one if the scene exceeds it and the flags
/// allow that.
OnBoard prepare_on(const SpecialiseFlags& flags, const ChosenCore& core, BoardRequest request,
                   const FrameOptions& options, SceneFile& scene, const TreeOptions& trees = {});

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

/// A frame on the display, as a monitor sees it at the pins.
struct Shown {
  std::string image;  ///< the file that was written
  DisplayMode mode;   ///< as measured
  unsigned clocks_per_pixel = 0;
  double displays_per_second = 0;
  std::size_t differ = 0;  ///< pixels that differ between display and frame

  std::string text() const;
  nlohmann::ordered_json json() const;
};

/// Shows the frame that the board has just rendered, at the pixel clock that comes closest to the
/// mode's, and writes the whole display to `file`.
Shown show(Board& board, const Frame& frame, double clock_mhz, const std::string& file);

/// The image's file: the one that the user names, or the scene's name with .png in this folder.
std::string image_name(const std::string& out, const std::string& scene);

}  // namespace dynrt::host
