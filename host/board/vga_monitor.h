// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A VGA monitor: finds the picture and the mode that a display would see at the pins of the board's
// scan-out. It knows only the pins, and reports signals that no display could lock to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace dynrt::host {

/// A display's mode, in pixels and lines, as in an X11 mode line.
struct VgaMode {
  unsigned hdisplay = 0, hsync_start = 0, hsync_end = 0, htotal = 0;
  unsigned vdisplay = 0, vsync_start = 0, vsync_end = 0, vtotal = 0;
  bool positive_hsync = false, positive_vsync = false;
  friend bool operator==(const VgaMode&, const VgaMode&) = default;
};

/// The industry standard of 640x480 at 60 Hz, for a pixel clock of 25.175 MHz.
inline constexpr VgaMode kVga640x480 = {640, 656, 752, 800, 480, 490, 492, 525, false, false};

/// From the beginning of a vertical sync pulse to that of the next.
struct VgaFrame {
  VgaMode mode;                       ///< as measured
  unsigned clocks_per_pixel = 0;      ///< of the board
  std::vector<std::uint32_t> pixels;  ///< 0x00BBGGRR, row by row from the top
  std::string fault;                  ///< the irregularity, which makes the rest invalid
};

class VgaMonitor {
 public:
  VgaMonitor(bool positive_hsync, bool positive_vsync)
      : positive_hsync_(positive_hsync), positive_vsync_(positive_vsync) {}

  /// The pins after an edge of the board's clock. The monitor looks at them when the pixel clock
  /// rises.
  void sample(bool clock, bool hsync, bool vsync, bool visible, std::uint32_t colour);

  /// Those that were seen whole.
  const std::vector<VgaFrame>& frames() const { return frames_; }

 private:
  struct Pixel {
    std::uint32_t colour = 0;
    bool hsync = false;  ///< in its pulse
    bool vsync = false;
    bool visible = false;
    unsigned clocks = 0;  ///< since the pixel before it
  };
  VgaFrame frame_of_pixels() const;
  std::string measure_lines(VgaFrame& frame) const;
  std::string measure_rows(VgaFrame& frame) const;

  bool positive_hsync_;
  bool positive_vsync_;
  bool clock_ = true;     ///< as last seen
  unsigned clocks_ = 0;   ///< since it last rose
  bool in_pulse_ = true;  ///< vertical sync of the previous pixel; unknown at first
  bool whole_ = false;    ///< a vertical sync pulse has begun
  std::vector<Pixel> pixels_;
  std::vector<VgaFrame> frames_;
};

}  // namespace dynrt::host
