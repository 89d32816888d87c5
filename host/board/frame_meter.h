// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a display makes of a stream of pixels, from whatever link they came: it finds the frames and
// measures their mode, and reports signals that no display could lock to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/board/display_mode.h"

namespace dynrt::host {

/// From the beginning of a vertical sync pulse to that of the next.
struct DisplayFrame {
  DisplayMode mode;                   ///< as measured
  unsigned pixel_time = 0;            ///< at VGA pins clocks of the board, on a DVI link ps
  std::vector<std::uint32_t> pixels;  ///< 0x00BBGGRR, row by row from the top
  std::string fault;                  ///< the irregularity, which makes the rest invalid
};

class FrameMeter {
 public:
  struct Pixel {
    std::uint32_t colour = 0;
    bool hsync = false;
    bool vsync = false;
    bool visible = false;
    unsigned time = 0;  ///< since the pixel before it
  };

  FrameMeter(bool positive_hsync, bool positive_vsync)
      : positive_hsync_(positive_hsync), positive_vsync_(positive_vsync) {}

  /// The next pixel, with the syncs as the link has them.
  void take(Pixel pixel);
  /// A fault of the link in the frame under way; the first one is told.
  void report(const std::string& fault);
  /// Where the next pixel lies in the frame under way, in words: counted from the beginnings of the
  /// sync pulses.
  std::string place() const;

  /// Those that were seen whole.
  const std::vector<DisplayFrame>& frames() const { return frames_; }

 private:
  DisplayFrame frame_of_pixels() const;
  std::string measure_lines(DisplayFrame& frame) const;
  std::string measure_rows(DisplayFrame& frame) const;

  bool positive_hsync_;
  bool positive_vsync_;
  bool in_pulse_ = true;  ///< vertical sync of the previous pixel; unknown at first
  bool whole_ = false;    ///< a vertical sync pulse has begun
  unsigned lines_ = 0;    ///< horizontal pulses of this frame that have begun
  unsigned columns_ = 0;  ///< pixels since the last of them, or since the vertical pulse
  std::string fault_;
  std::vector<Pixel> pixels_;  ///< with syncs that are true in their pulses
  std::vector<DisplayFrame> frames_;
};

}  // namespace dynrt::host
