// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The recursion that both trees share: from items with boxes on the grid to a Tree. Triangles and
// instances differ only in the way an item is cut at a plane, which the caller provides.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "host/tree/box_tree.h"
#include "host/tree/sweep.h"
#include "host/tree/tree.h"

namespace dynrt::host {

struct Mesh;
struct TreeOptions;
/// The parameters of an object's tree.
using MakeTree = std::function<Tree(const Mesh& object, const TreeOptions& options)>;

struct TreeOptions {
  Grid grid{};                     ///< that the splits lie on
  Leaves leaves = Leaves::kNodes;  ///< as the memory has them
  TreeCosts costs{};
  double object_cost = BoxTreeOptions{}.item;  ///< for the tree of instances
  bool main_first = false;                     ///< the same
  /// The tree's depth is at most depth_factor * log2(items) + depth_extra, and max_depth.
  double depth_factor = 1;
  double depth_extra = 10;
  int max_depth = kMaxTreeDepth;  ///< entries of the core's stacks: no deeper tree overflows them
  int max_top_depth = kMaxTreeDepth;  ///< the same, of the tree of instances
  /// Levels on a path that may be split although no single plane is worth its step. A node that is
  /// not worth it with the levels below becomes a leaf again.
  int patience = 4;
  /// The largest number of sample rays; there are no more than triangles. Without any, only the
  /// surface area guides the builder.
  unsigned sample_rays = 16384;
  /// The builder gives the tree up once its leaves list more items than this.
  std::size_t give_up_items = std::numeric_limits<std::size_t>::max();
  /// Triangles count as larger by this on all sides.
  double margin = 0;
  /// Called in place of build_triangle_tree, if there is one; from several threads.
  MakeTree make{};
  /// The memory that the tree may take, counted before leaves with the same items are joined. Each
  /// split divides the free memory between its sides by their expected work.
  TreeSize room{std::numeric_limits<std::size_t>::max(), std::numeric_limits<std::size_t>::max()};
};

/// The box of the item's part within `cell`, which lies within `item.box`; called from several
/// threads.
using CutItem = std::function<GridBox(const ItemRef& item, const GridBox& cell)>;

/// Builds the tree over the content's items (at least one). Its cell holds them all and is the box
/// that the clipping nodes cut out. The codes are those of options.grid. The result does not depend
/// on the number of threads.
Tree build_tree(const CellContent& content, const TreeOptions& options, const CutItem& cut);

}  // namespace dynrt::host
