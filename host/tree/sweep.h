// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Finds the plane that splits a cell at the least expected cost by the surface-area heuristic. All
// positions are codes of the number grid. Candidates are the faces of the items' boxes and, on each
// axis, two planes a hair off the cell's own faces: they cut walls lying on a cell's face from the
// empty room before it, which no plane through an item's face does.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "host/tree/grid.h"

namespace dynrt::host {

/// What the heuristic weighs, in clocks of the unit that is busiest: see ARCHITECTURE.md.
struct TreeCosts {
  double step = 1;            ///< of an inner node
  double leaf = 0;            ///< of fetching a leaf that is not empty
  double item = 1;            ///< of an item in a leaf
  double empty_bonus = 0.2;   ///< part of a plane's cost forgiven where one side is empty
  double hair = 1.0 / 16384;  ///< of the cell's extent
  int hair_codes = 4;         ///< and at least so many numbers of the grid
};

/// A box on the grid, closed: an item's, or a cell.
struct GridBox {
  std::array<Code, 3> low;
  std::array<Code, 3> high;
};

/// An item and its part within a cell.
struct ItemRef {
  GridBox box;
  uint32_t item = 0;
};

struct Plane {
  double cost = std::numeric_limits<double>::infinity();
  int axis = -1;  ///< -1: there is none
  Code split = 0;
  bool flat_left = true;  ///< items that lie in the plane go to the left child
  std::size_t left = 0;   ///< items in each child
  std::size_t right = 0;
};

/// The same plane for the same items in any order: of planes of equal cost the one of the lowest
/// axis and split is returned. Holds the working memory of one thread.
class PlaneSearch {
 public:
  explicit PlaneSearch(const TreeCosts& costs) : costs_(costs) {}
  Plane best(std::span<const ItemRef> items, const GridBox& cell);

 private:
  /// More items than these are counted at kBins planes first, and then at the faces near the best.
  static constexpr std::size_t kSweepLimit = 1 << 16;
  static constexpr int kBins = 512;

  void gather(std::span<const ItemRef> items, int axis, Code from, Code to);
  void sweep(const GridBox& cell, int axis, Code from, Code to, Plane& best);
  void narrow(std::span<const ItemRef> items, const GridBox& cell, int axis, Code& from, Code& to);
  void consider(const GridBox& cell, int axis, Code split, std::size_t left, std::size_t right,
                std::size_t flat, Plane& best) const;

  TreeCosts costs_;
  std::vector<Code> lows_, highs_, flats_;
  std::size_t below_ = 0, above_ = 0;
};

}  // namespace dynrt::host
