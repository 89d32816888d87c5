// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/tree_needs.h"

#include <gtest/gtest.h>

namespace dynrt::host {
namespace {

constexpr std::uint32_t kInner = 0;  // an axis

/// Nodes from index 1 on; the first is the root.
Tree tree_of(std::vector<TreeNode> nodes, std::vector<std::uint32_t> items) {
  Tree tree;
  tree.nodes.push_back({});
  tree.nodes.insert(tree.nodes.end(), nodes.begin(), nodes.end());
  tree.items = std::move(items);
  tree.root = tree.clipped_root = 1;
  return tree;
}
TreeNode inner(std::uint32_t left, std::uint32_t right) { return {kInner, 0.5, left, right}; }
TreeNode leaf(std::uint32_t first, std::uint32_t count) { return {kLeafAxis, 0, first, count}; }

TEST(TreeNeeds, ALeafAlonePushesNothing) {
  const TreeNeeds needs = tree_needs(tree_of({leaf(0, 3)}, {0, 1, 2}));
  EXPECT_EQ(needs.pushes, 0);
  EXPECT_EQ(needs.items, 3u);
  EXPECT_EQ(needs.repeated, 0u);
}

TEST(TreeNeeds, NodesWithTwoChildrenPushAndClippingNodesDoNot) {
  // Two clipping nodes, then a chain of three nodes with two children each.
  const Tree tree = tree_of({inner(kNullNode, 2), inner(3, kNullNode), inner(4, 7), inner(7, 5),
                             inner(6, 7), leaf(0, 1), leaf(1, 1)},
                            {0, 1});
  EXPECT_EQ(tree_needs(tree).pushes, 3);
}

TEST(TreeNeeds, TheDeepestPathCounts) {
  const Tree tree =
      tree_of({inner(2, 3), leaf(0, 1), inner(4, 5), leaf(1, 1), leaf(2, 1)}, {0, 1, 2});
  EXPECT_EQ(tree_needs(tree).pushes, 2);
}

TEST(TreeNeeds, AnItemOfTwoLeavesIsMetAgain) {
  const TreeNeeds needs = tree_needs(tree_of({inner(2, 3), leaf(0, 2), leaf(2, 2)}, {0, 1, 1, 2}));
  EXPECT_EQ(needs.items, 3u);
  EXPECT_EQ(needs.repeated, 1u);
}

TEST(TreeNeeds, ALeafThatTwoNodesShareIsMetAgain) {
  const TreeNeeds needs = tree_needs(
      tree_of({inner(2, 3), inner(4, 5), inner(5, kNullNode), leaf(0, 1), leaf(1, 2)}, {0, 1, 2}));
  EXPECT_EQ(needs.repeated, 2u);
}

}  // namespace
}  // namespace dynrt::host
