// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Makes a Tree of the nodes of the recursion: adds the clipping nodes, numbers the nodes depth
// first, joins leaves with the same items and counts the figures.
#pragma once

#include <span>
#include <vector>

#include "host/tree/sweep.h"
#include "host/tree/tree.h"

namespace dynrt::host {

/// Nodes in any order, splits as codes; node 0 is the null node.
struct RawTree {
  struct Node {
    int axis = kLeafAxis;
    Code split = 0;
    std::uint32_t left = 0;   ///< leaf: its first item
    std::uint32_t right = 0;  ///< leaf: how many items
  };
  std::vector<Node> nodes = std::vector<Node>(1);
  std::vector<std::uint32_t> items;

  TreeSize size() const { return {nodes.size() - 1, items.size()}; }
  /// Forgets the nodes that were added since.
  void cut_back(const TreeSize& to) {
    nodes.resize(to.nodes + 1);
    items.resize(to.items);
  }

  std::uint32_t add_inner(int axis, Code split);
  std::uint32_t add_leaf(std::span<const ItemRef> leaf_items);
  /// Takes over another tree's nodes; returns the new index of its node `root`.
  std::uint32_t append(const RawTree& other, std::uint32_t root);
};

/// `cell` is the box that the clipping nodes cut out.
Tree assemble(const Grid& grid, const RawTree& raw, std::uint32_t root, const GridBox& cell);

}  // namespace dynrt::host
