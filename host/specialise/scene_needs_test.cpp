// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/scene_needs.h"

#include <gtest/gtest.h>

#include "host/memory/matrix_numbers.h"
#include "host/specialise/test_needs.h"

namespace dynrt::host {
namespace {

using testing::add_instance;
using testing::needs_of;
using testing::one_triangle;
using testing::room;
using testing::scene_of;

TEST(SceneNeeds, OneObjectThatStandsWhereItIsNeedsOneLevel) {
  Scene scene = scene_of(one_triangle("sail"));
  EXPECT_TRUE(needs_of(scene).one_level);
  scene.instances.front().transform[3][0] = 1e-9;
  EXPECT_FALSE(needs_of(scene).one_level);
}

TEST(SceneNeeds, TwoInstancesNeedTwoLevels) {
  Scene scene = scene_of(one_triangle("sail"));
  add_instance(scene, 3);
  const SceneNeeds needs = needs_of(scene);
  EXPECT_FALSE(needs.one_level);
  EXPECT_EQ(needs.instances, 2u);
}

TEST(SceneNeeds, TheDeepestTreeOfAnObjectIsNamed) {
  Scene scene = scene_of(one_triangle("sail"));
  EXPECT_EQ(needs_of(scene).object_stack.pushes, 0);
  scene.objects.push_back(room(1, 6, 6));
  scene.instances.push_back({"second", 1});
  const SceneNeeds needs = needs_of(scene);
  EXPECT_EQ(needs.object_stack.tree, "room");
  EXPECT_GT(needs.object_stack.pushes, 5);
  EXPECT_GT(needs.primitive_repeats.repeated, 0u);
}

TEST(SceneNeeds, TheTopLevelGrowsWithTheInstances) {
  Scene scene = scene_of(one_triangle("sail"));
  const int one = needs_of(scene).top_stack.pushes;
  for (int i = 1; i < 64; ++i) add_instance(scene, 3.0 * i);
  const SceneNeeds many = needs_of(scene);
  EXPECT_GT(many.top_stack.pushes, one + 3);
  EXPECT_EQ(many.instance_repeats.repeated, 0u);
}

TEST(SceneNeeds, PrimitivesInThreeColumnsHaveNumbersOfTheirOwn) {
  const Scene scene = scene_of(room(1, 2, 4));
  const SceneNeeds three = needs_of(scene, TriangleMatrix::kMemoryEfficient);
  // More numbers than the matrices that they take.
  EXPECT_EQ(three.places.matrices, scene.objects.front().triangles.size());
  EXPECT_EQ(needs_of(scene).places.matrices, scene.objects.front().triangles.size() + 2);
}

TEST(SceneNeeds, ColoursAreThoseOfSurfacesThatThereAre) {
  Scene scene = scene_of(one_triangle("sail"));
  scene.materials.push_back({"unused", {1, 0, 0}});
  EXPECT_EQ(needs_of(scene).colours.size(), 1u);
  scene.objects.front().ellipsoids.push_back({glm::dmat4(1.0), 1});
  EXPECT_EQ(needs_of(scene).colours.size(), 2u);
}

TEST(SceneNeeds, AMirrorIsNamed) {
  Scene scene = scene_of(one_triangle("sail"));
  EXPECT_EQ(needs_of(scene).mirror, "");
  scene.materials.front().mirror = 0.5;
  EXPECT_EQ(needs_of(scene).mirror, "grey");
}

TEST(SceneNeeds, FramesTogetherNeedWhatOneOfThemDoes) {
  Scene few = scene_of(one_triangle("sail"));
  Scene many = few;
  for (int i = 1; i < 32; ++i) add_instance(many, 3.0 * i);
  many.lights.resize(2);
  SceneNeeds both = needs_of(few);
  both.include(needs_of(many));
  EXPECT_EQ(both.frames, 2u);
  EXPECT_FALSE(both.one_level);
  EXPECT_EQ(both.lights, 2u);
  EXPECT_EQ(both.top_stack.pushes, needs_of(many).top_stack.pushes);
  EXPECT_EQ(both.places.nodes, needs_of(many).places.nodes);
}

/// A light whose rays the core does not trace has no boxes.
TEST(SceneNeeds, BoxesTakeThePlacesThatTheCoreGivesThem) {
  Scene scene = scene_of(one_triangle("sail"));
  for (int i = 1; i < 32; ++i) add_instance(scene, 3.0 * i);
  scene.lights.resize(2);
  const SceneTrees trees = build_scene_trees(scene);
  const auto matrices = [&](std::size_t boxes) {
    return scene_needs(scene, trees, TriangleMatrix::kNormalConsistent, boxes).places.matrices;
  };
  const std::size_t more = matrices_of_boxes(scene);
  ASSERT_GT(more, 0u);
  EXPECT_EQ(matrices(1), matrices(0) + more);
  EXPECT_EQ(matrices(3), matrices(0) + 3 * more);
}

}  // namespace
}  // namespace dynrt::host
