// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A k-D tree over boxes, built fast rather than perfectly, as the tree over a scene's instances is
// rebuilt for every frame. The surface-area heuristic counts the boxes of large sets in 16 bins an
// axis and tries every face of small ones.
#pragma once

#include <limits>
#include <span>

#include "host/tree/grid.h"
#include "host/tree/tree.h"

namespace dynrt::host {

/// The cost of entering a box: a ray that enters an instance is transformed and meets at least the
/// clipping nodes of its object.
struct BoxTreeOptions {
  Grid grid{};                     ///< that the splits lie on
  Leaves leaves = Leaves::kNodes;  ///< as the memory has them
  bool main_first = false;         ///< of instances: the main one is not in the tree
  double item = 8;                 ///< in traversal steps
  double empty_bonus = 0.2;        ///< part of a plane's cost forgiven where one side is empty
  double depth_factor = 0.6;       ///< depth at most depth_factor * log2(boxes) + depth_extra
  double depth_extra = 10;
  int max_depth = kMaxTreeDepth;  ///< as in TreeOptions (build.h)
  /// The memory that the tree may take. A tree that needs more is rebuilt, less deep. The room is
  /// at least that of the clipping nodes and one leaf of all boxes.
  TreeSize room{std::numeric_limits<std::size_t>::max(), std::numeric_limits<std::size_t>::max()};
};

/// Item i is boxes[i]; there is at least one, all within the core's numbers.
Tree build_box_tree(std::span<const Aabb> boxes, const BoxTreeOptions& options = {});

}  // namespace dynrt::host
