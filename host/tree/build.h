// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The recursion that both trees share: from items with boxes on the grid to a Tree. What differs
// between triangles and instances is how an item is cut at a plane, which is the caller's.
#pragma once

#include <functional>
#include <vector>

#include "host/tree/sweep.h"
#include "host/tree/tree.h"

namespace dynrt::host {

/// A tree's box is grown by so many numbers of the grid, so that rounding in the traversal loses no
/// ray at its faces.
inline constexpr int kBoxGrowth = 2;

struct TreeOptions {
  TreeCosts costs;
  /// The tree's depth is at most depth_factor * log2(items) + depth_extra, and kMaxTreeDepth.
  double depth_factor = 1;
  double depth_extra = 10;
  /// Levels on a path that may be split although no single plane is worth its step; what turns out
  /// not to be worth it with the levels below becomes a leaf again.
  int patience = 4;
};

/// The box of the item's part within `cell`, which lies within `item.box`; called from several
/// threads.
using CutItem = std::function<GridBox(const ItemRef& item, const GridBox& cell)>;

/// Builds the tree over items within a cell that holds them all; `items` is not empty. The cell is
/// what the clipping nodes cut out. The result does not depend on the number of threads.
Tree build_tree(std::vector<ItemRef> items, const GridBox& cell, const TreeOptions& options,
                const CutItem& cut);

/// A box rounded outward to the grid and grown by `codes` more.
GridBox grid_box(const Aabb& box, int codes = 0);
Aabb real_box(const GridBox& box);

}  // namespace dynrt::host
