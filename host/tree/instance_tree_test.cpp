// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/instance_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "host/test_error.h"
#include "host/tree/test_meshes.h"
#include "host/tree/test_trees.h"

namespace dynrt::host {
namespace {

TEST(InstanceTree, ATransformedBoxHoldsTheTransformedCorners) {
  const Aabb box{{-1, 2, 3}, {4, 5, 7}};
  glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(1, 2, 3));
  m = glm::rotate(m, 1.1, glm::dvec3(1, 2, -0.5));
  m = glm::scale(m, glm::dvec3(2, -0.5, 1.5));
  Aabb expected;
  for (unsigned k = 0; k < 8; ++k) {
    const glm::dvec3 corner{k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y,
                            k & 4 ? box.high.z : box.low.z};
    expected.include(glm::dvec3(m * glm::dvec4(corner, 1)));
  }
  const Aabb got = transformed_box(box, m);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(got.low[axis], expected.low[axis], 1e-12);
    EXPECT_NEAR(got.high[axis], expected.high[axis], 1e-12);
  }
}

std::string error_of(const Scene& scene) {
  const std::vector<Aabb> boxes{{{0, 0, 0}, {1, 1, 1}}};
  return user_error([&] { build_instance_tree(scene, boxes); });
}

TEST(InstanceTree, TheMainInstanceIsMetBeforeTheTree) {
  Scene scene = testing::scene_of(testing::soup(1, 10, 0.1));
  const std::vector<Aabb> boxes{{glm::dvec3(-1), glm::dvec3(1)}};
  const auto add = [&](double size, double x) {
    const glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(x, 0, 0));
    scene.instances.push_back({"i", 0, glm::scale(m, glm::dvec3(size))});
  };
  scene.instances.clear();
  add(1, 5);
  add(10, 0);
  add(1, -5);
  BoxTreeOptions options{.leaves = Leaves::kPointers, .main_first = true};
  const Tree tree = build_instance_tree(scene, boxes, options);
  const TreeNode& main = tree.nodes[tree.main_leaf];
  EXPECT_EQ(main.right, 1u);
  EXPECT_EQ(tree.items[main.left], 1u);
  std::vector<std::uint32_t> others(tree.items.begin(), tree.items.begin() + main.left);
  std::ranges::sort(others);
  EXPECT_EQ(others, (std::vector<std::uint32_t>{0, 2}));
  scene.instances[1].transform = glm::dmat4(1);
  EXPECT_EQ(build_instance_tree(scene, boxes, options).main_leaf, kNullNode) << "none is so large";
  options.main_first = false;
  add(10, 0);
  EXPECT_EQ(build_instance_tree(scene, boxes, options).main_leaf, kNullNode);
}

TEST(InstanceTree, KeepsToTheTopLevelsPlace) {
  Scene scene = testing::scene_of(testing::soup(1, 10, 0.1));
  const std::vector<Aabb> boxes{{glm::dvec3(-1), glm::dvec3(1)}};
  for (const double apart : {0.01, 0.3, 1.0, 3.0, 30.0}) {
    scene.instances.clear();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> at(-10 * apart, 10 * apart);
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 place(at(random), at(random), at(random));
      scene.instances.push_back({"i", 0, glm::translate(glm::dmat4(1.0), place)});
    }
    const Tree tree = build_instance_tree(scene, boxes);
    const TreeSize room = top_level_room(1000);
    EXPECT_LE(tree.size().nodes, room.nodes) << apart;
    EXPECT_LE(tree.size().items, room.items) << apart;
    testing::expect_sound(tree);
    if (apart == 0.3) EXPECT_TRUE(tree.cut) << "where many lie in one another";
    if (apart >= 3) EXPECT_FALSE(tree.cut) << apart;
  }
}

TEST(InstanceTree, RefusesASceneWithoutInstances) {
  Scene scene = testing::scene_of(testing::soup(1, 3, 0.1));
  scene.instances.clear();
  EXPECT_EQ(error_of(scene), "scene 'soup' has no instances; a scene must have at least one");
}

TEST(InstanceTree, RefusesAnInstanceBeyondTheCoresNumbers) {
  Scene scene = testing::scene_of(testing::soup(1, 3, 0.1));
  scene.instances[0].transform = glm::scale(glm::dmat4(1), glm::dvec3(1, 1e20, 1));
  EXPECT_EQ(error_of(scene),
            "instance 'one': its box reaches y = 1e+20, outside the core's numbers; coordinates "
            "must lie within -1.8447e+19 and 1.8447e+19");
}

}  // namespace
}  // namespace dynrt::host
