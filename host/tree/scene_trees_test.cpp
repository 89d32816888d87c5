// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/scene_trees.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "host/tree/test_meshes.h"
#include "host/tree/test_trees.h"

namespace dynrt::host {
namespace {

TreeSize size_of(const SceneTrees& trees) {
  TreeSize size = trees.instances.size();
  for (const Tree& tree : trees.objects) {
    size.nodes += tree.size().nodes;
    size.items += tree.size().items;
  }
  return size;
}

TEST(SceneTrees, AreCutUntilTheyFitAndSaySo) {
  const Scene scene = testing::scene_of(testing::soup(1, 2000, 0.4));
  const SceneTrees whole = build_scene_trees(scene);
  EXPECT_TRUE(whole.notes.empty());
  EXPECT_FALSE(whole.objects[0].cut);

  TreeSize limits = kMemoryForTrees;
  limits.nodes = size_of(whole).nodes / 3;
  const SceneTrees few_nodes = build_scene_trees(scene, {}, limits);
  testing::expect_sound(few_nodes.objects[0]);
  EXPECT_TRUE(few_nodes.objects[0].cut);
  EXPECT_LE(size_of(few_nodes).nodes, limits.nodes);
  EXPECT_GT(size_of(few_nodes).nodes, limits.nodes / 2);
  ASSERT_EQ(few_nodes.notes.size(), 1u);
  EXPECT_THAT(
      few_nodes.notes[0],
      ::testing::MatchesRegex(
          "object 'soup': its tree has only depth [0-9]+, to fit the board's [0-9]+ tree nodes and "
          "524288 list entries; a ray across the object probably makes [1-9]\\.[0-9] times the "
          "work of the whole tree; the whole tree fits if the triangles are fewer or smaller"));

  limits = kMemoryForTrees;
  limits.items = size_of(whole).items / 2;
  const SceneTrees few_items = build_scene_trees(scene, {}, limits);
  testing::expect_sound(few_items.objects[0]);
  EXPECT_LE(size_of(few_items).items, limits.items);
  EXPECT_GT(size_of(few_items).items, limits.items / 2);
}

TEST(SceneTrees, OnlyTheLargestObjectsAreCut) {
  Scene scene = testing::scene_of(testing::soup(1, 2000, 0.4));
  scene.objects.push_back(testing::soup(2, 100, 0.4));
  scene.instances.push_back({"two", 1, glm::dmat4(1.0)});
  const SceneTrees whole = build_scene_trees(scene);
  TreeSize limits = kMemoryForTrees;
  limits.items = size_of(whole).items / 2;
  const SceneTrees cut = build_scene_trees(scene, {}, limits);
  EXPECT_TRUE(cut.objects[0].cut);
  EXPECT_FALSE(cut.objects[1].cut);
  testing::expect_same(cut.objects[1], whole.objects[1]);
  EXPECT_LE(size_of(cut).items, limits.items);
}

TEST(SceneTrees, AreGivenUpBeforeTheyAreFarTooLarge) {
  const Scene scene = testing::scene_of(testing::soup(1, 1000, 2.0));
  TreeOptions options;
  options.give_up_items = 5000;
  const Tree tree = build_triangle_tree(scene.objects[0], options);
  EXPECT_TRUE(tree.given_up);
  EXPECT_TRUE(tree.nodes.empty());
  TreeSize limits = kMemoryForTrees;
  limits.items = 3000;
  const SceneTrees trees = build_scene_trees(scene, {}, limits);
  testing::expect_sound(trees.objects[0]);
  EXPECT_LE(size_of(trees).items, limits.items);
  ASSERT_EQ(trees.notes.size(), 1u);
  EXPECT_THAT(trees.notes[0],
              ::testing::ContainsRegex(
                  "; a ray across the object probably meets [0-9]+ nodes and [0-9]+ triangles; "));
}

TEST(SceneTrees, EndWithALeafEachWhereNothingFits) {
  const Scene scene = testing::scene_of(testing::soup(1, 200, 0.4));
  TreeSize limits = kMemoryForTrees;
  limits.items = 10;
  const SceneTrees trees = build_scene_trees(scene, {}, limits);
  EXPECT_EQ(trees.objects[0].size().items, 200u);
  EXPECT_EQ(trees.objects[0].size().nodes, 7u);
}

TEST(SceneTrees, DoNotDependOnTheNumberOfThreads) {
  const Scene scene = testing::scene_of(testing::soup(3, 5000, 0.3));
  TreeSize limits = kMemoryForTrees;
  limits.items = 12000;
  const SceneTrees many = build_scene_trees(scene, {}, limits);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const SceneTrees single = build_scene_trees(scene, {}, limits);
  EXPECT_TRUE(single.objects[0].cut);
  testing::expect_same(many.objects[0], single.objects[0]);
}

}  // namespace
}  // namespace dynrt::host
