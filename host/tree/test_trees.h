// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The properties of every tree, made by any builder.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "host/tree/grid.h"
#include "host/tree/tree.h"

namespace dynrt::host::testing {

/// Whether a leaf whose closed cell holds the point, as far as doubles can tell, lists the item.
inline bool found(const Tree& tree, std::uint32_t index, const glm::dvec3& p, std::uint32_t item) {
  if (index == kNullNode) return false;
  const TreeNode& node = tree.nodes[index];
  if (node.is_leaf()) {
    const auto first = tree.items.begin() + node.left;
    return std::find(first, first + node.right, item) != first + node.right;
  }
  const double slack = 1e-14 * std::abs(node.split);
  return (p[node.axis] <= node.split + slack && found(tree, node.left, p, item)) ||
         (p[node.axis] >= node.split - slack && found(tree, node.right, p, item));
}

/// Splits on the grid and within their cell, leaves not empty, figures true.
inline void expect_sound(const Tree& tree, const Grid& grid = {}) {
  struct Visit {
    std::uint32_t index;
    Aabb cell;
    int depth;
  };
  std::vector<Visit> open{{tree.root, tree.box, 0}};
  int depth = 0;
  std::size_t inner = 0, links = 0, empty = 0;
  std::set<std::uint32_t> leaves;
  while (!open.empty()) {
    const Visit v = open.back();
    open.pop_back();
    if (v.index == kNullNode) {
      ++empty;
      continue;
    }
    ASSERT_LT(v.index, tree.nodes.size());
    const TreeNode& node = tree.nodes[v.index];
    depth = std::max(depth, v.depth);
    if (node.is_leaf()) {
      ASSERT_GE(node.right, 1u);
      ASSERT_LE(node.left + node.right, tree.items.size());
      leaves.insert(v.index);
      ++links;
      continue;
    }
    ++inner;
    ASSERT_EQ(grid.value(grid.floor(node.split)), node.split);
    ASSERT_GT(node.split, v.cell.low[node.axis]);
    ASSERT_LT(node.split, v.cell.high[node.axis]);
    Visit left{node.left, v.cell, v.depth + 1};
    Visit right{node.right, v.cell, v.depth + 1};
    left.cell.high[node.axis] = right.cell.low[node.axis] = node.split;
    open.push_back(left);
    open.push_back(right);
  }
  EXPECT_EQ(tree.stats.depth, depth);
  EXPECT_LE(depth, kMaxTreeDepth);
  EXPECT_EQ(tree.stats.inner_nodes, inner);
  EXPECT_EQ(tree.stats.leaf_links, links);
  EXPECT_EQ(tree.stats.leaves, leaves.size());
  EXPECT_EQ(tree.stats.empty_children, empty);
  EXPECT_EQ(tree.stats.items, tree.items.size());
  EXPECT_EQ(tree.nodes.size(), 1 + 6 + inner + leaves.size());
}

inline void expect_same(const Tree& a, const Tree& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  EXPECT_EQ(a.items, b.items);
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    ASSERT_EQ(a.nodes[i].axis, b.nodes[i].axis);
    ASSERT_EQ(a.nodes[i].split, b.nodes[i].split);
    ASSERT_EQ(a.nodes[i].left, b.nodes[i].left);
    ASSERT_EQ(a.nodes[i].right, b.nodes[i].right);
  }
}

}  // namespace dynrt::host::testing
