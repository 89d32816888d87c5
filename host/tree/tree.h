// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A k-D tree (thesis 3.1.1) as both builders make it and the memory image packs it. Its splits lie
// on the core's number grid (grid.h). A leaf is a list of items (triangles of an object, or
// instances of a scene); leaves with the same items are one node, so the tree is a graph without
// cycles. Six clipping nodes (4.2) with one empty child each stand above the real root.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/tree/aabb.h"
#include "units/memory_format.h"
#include "units/options.h"

namespace dynrt::host {

inline constexpr std::uint32_t kNullNode = 0;  ///< an empty child; node 0 of a tree is not used
inline constexpr std::uint8_t kLeafAxis = 3;
inline constexpr int kClippingNodes = 6;
inline constexpr int kMaxTreeDepth = 31;  ///< default limit; a core's stacks must hold it

struct TreeNode {
  std::uint8_t axis = kLeafAxis;  ///< 0, 1, 2 or kLeafAxis
  double split = 0;               ///< exactly a number of the grid
  std::uint32_t left = 0;         ///< child; leaf: its first item
  std::uint32_t right = 0;        ///< child; leaf: how many items, at least one
  bool is_leaf() const { return axis == kLeafAxis; }
};

/// The part of the board's memory that trees take; the null node is not counted.
struct TreeSize {
  std::size_t nodes = 0;
  std::size_t items = 0;
};

/// The way a leaf of a tree is known in the memory (units/packet.h has the pointers).
enum class Leaves : std::uint8_t {
  kNodes,     ///< by a node of its own, which has the address of its list
  kPointers,  ///< by the pointer of the node above, which is to the list
};

struct TreeStats {
  std::size_t inner_nodes = 0;
  std::size_t leaves = 0;      ///< leaf nodes, those with the same list counted once
  std::size_t leaf_links = 0;  ///< children that are leaves
  std::size_t empty_children = 0;
  std::size_t items = 0;  ///< list entries
  std::size_t longest_list = 0;
  std::size_t list_places = 0;  ///< of the entries, where each list begins at an even one
  int depth = 0;                ///< of the real root's subtree, a leaf alone being 0
  double expected_steps = 0;    ///< by the surface area, for a ray that meets the box
  double expected_leaves = 0;
  double expected_items = 0;
};

struct Tree {
  std::vector<TreeNode>
      nodes;  ///< node 0 is the null node, then the clipping nodes, then depth first
  std::vector<std::uint32_t> items;
  std::uint32_t root = kNullNode;          ///< where a ray starts inside the box
  std::uint32_t clipped_root = kNullNode;  ///< where any ray starts
  std::uint32_t main_leaf = kNullNode;     ///< of an item that rays meet before they start there
  Aabb box;                                ///< box that the clipping nodes cut out, rounded outward
  bool cut = false;                ///< somewhere not split for want of room (TreeOptions::room)
  bool given_up = false;           ///< no nodes: it grew beyond TreeOptions::give_up_items
  Leaves leaves = Leaves::kNodes;  ///< as the memory has them
  TreeStats stats;

  TreeSize size() const {
    const std::size_t all = nodes.empty() ? 0 : nodes.size() - 1;
    if (leaves == Leaves::kNodes) return {all, items.size()};
    return {all - stats.leaves, stats.list_places};
  }
  /// The node where rays from this point start.
  std::uint32_t entry(const glm::dvec3& origin) const {
    return box.holds(origin) ? root : clipped_root;
  }
};

/// The entries that a list takes, where lists begin at every kListStep-th.
constexpr std::size_t list_places(std::size_t items) {
  return (items + kListStep - 1) / kListStep * kListStep;
}

/// Starts a tree: the null node, then the six clipping nodes around the box. The last of them leads
/// to the node that is added next.
inline void add_clipping_nodes(Tree& tree, const Aabb& box) {
  tree.nodes.resize(1);
  tree.box = box;
  tree.clipped_root = 1;
  for (std::uint8_t axis = 0; axis < 3; ++axis) {
    const auto next = static_cast<std::uint32_t>(tree.nodes.size()) + 1;
    tree.nodes.push_back({axis, box.low[axis], kNullNode, next});
    tree.nodes.push_back({axis, box.high[axis], next + 1, kNullNode});
  }
}

}  // namespace dynrt::host
