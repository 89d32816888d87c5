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

  limits = {};
  limits.items = full.objects[0].items.size() / 2;
  const SceneTrees few_items = build_scene_trees(scene, {}, limits);
  EXPECT_LE(few_items.objects[0].items.size() + few_items.instances.items.size(), limits.items);
}

TEST(SceneTrees, EndWithTheShallowestWhereNothingFits) {
  const Scene scene = testing::scene_of(testing::soup(1, 200, 0.4));
  TreeLimits limits;
  limits.items = 10;
  EXPECT_GT(build_scene_trees(scene, {}, limits).objects[0].items.size(), limits.items);
}

}  // namespace
}  // namespace dynrt::host
