// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board's scan-out with a monitor at its pins. It shows pictures in bank 3 while the core
// works. Two buffers: while one is shown the core renders into the other (frame_base of
// FrameConfig); show() it, wait until it is shown(), and the first one is free.
#pragma once

#include "host/board/rtl_board.h"
#include "host/board/vga_monitor.h"
#include "units/scan_out.h"

namespace dynrt::host {

/// Throws UserError if a picture of this core does not fit a display of 640x480.
void check_display_size(const CoreInfo& core, unsigned width, unsigned height);

class Display {
 public:
  /// The smallest and largest number of board clocks for a pixel.
  static constexpr unsigned kLeastClocks = 2;
  static constexpr unsigned kMostClocks = 255;

  /// Switches the scan-out on. The picture begins at word `base` of bank 3 and lies in the middle
  /// of the display. Throws UserError if the board has no scan-out or the picture does not fit.
  Display(RtlBoard& board, const DisplayMode& mode, unsigned clocks_per_pixel, std::uint32_t base,
          unsigned width, unsigned height);
  /// Switches it off.
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// Shows the picture at `base` from the next vertical blank on.
  void show(std::uint32_t base);
  /// The picture that was taken in the last vertical blank.
  std::uint32_t shown();

  /// The complete pictures that the monitor has seen since the display is on.
  const std::vector<DisplayFrame>& frames() const { return monitor_.frames(); }
  /// Clocks the board until the monitor has seen `count` more of them.
  const DisplayFrame& wait(unsigned count);

 private:
  RtlBoard& board_;
  VgaMonitor monitor_;
  std::uint64_t clocks_;  ///< of a frame
};

/// Writes the SCAN registers.
void write_scan(RtlBoard& board, const ScanConfig& scan);

/// The registers of a mode with a picture in its middle.
ScanConfig scan_config(const DisplayMode& mode, std::uint32_t base, unsigned width,
                       unsigned height);

}  // namespace dynrt::host
