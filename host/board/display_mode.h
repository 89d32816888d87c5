// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The modes of a display: the one table for VGA pins and for a DVI link.
#pragma once

#include <string_view>

namespace dynrt::host {

/// In pixels and lines, as in an X11 mode line.
struct DisplayMode {
  unsigned hdisplay = 0, hsync_start = 0, hsync_end = 0, htotal = 0;
  unsigned vdisplay = 0, vsync_start = 0, vsync_end = 0, vtotal = 0;
  bool positive_hsync = false, positive_vsync = false;
  friend bool operator==(const DisplayMode&, const DisplayMode&) = default;
};

/// A mode of the industry's.
struct StandardMode {
  std::string_view name;
  DisplayMode mode;
  double pixel_mhz;  ///< as the standard has it, for 60 Hz
  /// As a DVI link has it, by whole dividers from a clock of 25 MHz (rtl/ecp5/ecp5_dvi_clock.v).
  /// 25 for 25.175 gives 59.5 Hz.
  unsigned link_mhz;
};

inline constexpr StandardMode kStandardModes[] = {
    {"640x480", {640, 656, 752, 800, 480, 490, 492, 525, false, false}, 25.175, 25},
    {"800x600", {800, 840, 968, 1056, 600, 601, 605, 628, true, true}, 40, 40},
};
/// The mode of a link whose pixels have this clock; null if there is none.
constexpr const DisplayMode* mode_of_link(unsigned mhz) {
  for (const StandardMode& standard : kStandardModes) {
    if (standard.link_mhz == mhz) return &standard.mode;
  }
  return nullptr;
}
inline constexpr const StandardMode& k640x480 = kStandardModes[0];
inline constexpr const StandardMode& k800x600 = kStandardModes[1];

}  // namespace dynrt::host
