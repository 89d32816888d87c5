// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A frame on the board's VGA display: the image that a monitor sees at the pins, and its figures.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/board/board.h"
#include "host/render/frame.h"

namespace dynrt::host {

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

}  // namespace dynrt::host
