// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The levels of image files, which follow the sRGB curve, as amounts of light, which can be added.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dynrt::host {

/// IEC 61966-2-1, of a level 0 to 1.
inline double linear_of(double level) {
  return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4);
}

/// Of every level of eight bits.
inline const std::array<double, 256>& linear_levels() {
  static const std::array<double, 256> levels = [] {
    std::array<double, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = linear_of(static_cast<double>(i) / 255);
    return made;
  }();
  return levels;
}

}  // namespace dynrt::host
