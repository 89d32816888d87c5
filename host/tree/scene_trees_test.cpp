// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/scene_trees.h"

#include <gtest/gtest.h>

#include "host/tree/test_meshes.h"

namespace dynrt::host {
namespace {

std::size_t nodes_of(const SceneTrees& trees) {
  return trees.objects[0].nodes.size() + trees.instances.nodes.size() - 2;
}

TEST(SceneTrees, AreMadeShallowerUntilTheyFit) {
  const Scene scene = testing::scene_of(testing::soup(1, 2000, 0.4));
  const SceneTrees full = build_scene_trees(scene);
  TreeLimits limits;
  limits.nodes = nodes_of(full) / 3;
  const SceneTrees few_nodes = build_scene_trees(scene, {}, limits);
  EXPECT_LE(nodes_of(few_nodes), limits.nodes);
  EXPECT_GT(nodes_of(few_nodes), limits.nodes / 8);

  EXPECT_FALSE(few_nodes.objects[0].cut_short);

  limits = {};
  limits.items = full.objects[0].items.size() / 2;
  const SceneTrees few_items = build_scene_trees(scene, {}, limits);
  EXPECT_LE(few_items.objects[0].items.size() + few_items.instances.items.size(), limits.items);
}

TEST(SceneTrees, AreGivenUpBeforeTheyAreFarTooLarge) {
  const Scene scene = testing::scene_of(testing::soup(1, 1000, 2.0));
  TreeOptions options;
  options.most_items = 5000;
  const Tree tree = build_triangle_tree(scene.objects[0], options);
  EXPECT_TRUE(tree.cut_short);
  EXPECT_LT(tree.items.size(), 50000u);
  TreeLimits limits;
  limits.items = 3000;
  const SceneTrees trees = build_scene_trees(scene, {}, limits);
  EXPECT_FALSE(trees.objects[0].cut_short);
  EXPECT_LE(trees.objects[0].items.size(), limits.items);
}

TEST(SceneTrees, EndWithTheShallowestWhereNothingFits) {
  const Scene scene = testing::scene_of(testing::soup(1, 200, 0.4));
  TreeLimits limits;
  limits.items = 10;
  EXPECT_GT(build_scene_trees(scene, {}, limits).objects[0].items.size(), limits.items);
}

}  // namespace
}  // namespace dynrt::host
