// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A VGA monitor: finds the picture and the mode that a display would see at the pins of the board's
// scan-out. It knows only the pins, and reports signals that no display could lock to.
#pragma once

#include <cstdint>
#include <vector>

#include "host/board/frame_meter.h"

namespace dynrt::host {

class VgaMonitor {
 public:
  VgaMonitor(bool positive_hsync, bool positive_vsync) : meter_(positive_hsync, positive_vsync) {}

  /// The pins after an edge of the board's clock. The monitor looks at them when the pixel clock
  /// rises.
  void sample(bool clock, bool hsync, bool vsync, bool visible, std::uint32_t colour);

  /// Those that were seen whole.
  const std::vector<DisplayFrame>& frames() const { return meter_.frames(); }

 private:
  bool clock_ = true;    ///< as last seen
  unsigned clocks_ = 0;  ///< since it last rose
  FrameMeter meter_;
};

}  // namespace dynrt::host
