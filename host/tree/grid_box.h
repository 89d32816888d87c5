// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Boxes whose faces are numbers of the grid.
#pragma once

#include <algorithm>
#include <array>

#include "host/tree/aabb.h"
#include "host/tree/grid.h"

namespace dynrt::host {

/// Closed: an item's box, or a cell.
struct GridBox {
  std::array<Code, 3> low;
  std::array<Code, 3> high;
};

/// A tree's box is grown by this many numbers of the grid, so that rounding in the traversal loses
/// no ray at its faces.
inline constexpr int kBoxGrowth = 2;

/// A box rounded outward to the grid and grown by `codes` more.
inline GridBox grid_box(const Grid& grid, const Aabb& box, int codes = 0) {
  GridBox rounded;
  for (int axis = 0; axis < 3; ++axis) {
    rounded.low[axis] = std::max(grid.floor(box.low[axis]) - codes, grid.min_code());
    rounded.high[axis] = std::min(grid.ceil(box.high[axis]) + codes, grid.max_code());
  }
  return rounded;
}

inline Aabb real_box(const Grid& grid, const GridBox& box) {
  Aabb real;
  for (int axis = 0; axis < 3; ++axis) {
    real.low[axis] = grid.value(box.low[axis]);
    real.high[axis] = grid.value(box.high[axis]);
  }
  return real;
}

}  // namespace dynrt::host
