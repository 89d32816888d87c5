// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Scenes whose image the memory or the core's numbers cannot hold, and the sentences about them.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "host/layout/lay_out.h"
#include "host/layout/test_scene.h"
#include "host/test_error.h"
#include "host/tree/scene_trees.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host {
namespace {

using testing::add_triangle;
using testing::Laid;
using testing::scene_of;
using testing::test_core;

std::string error_of(const Scene& scene) {
  return user_error([&] { Laid(scene, testing::camera_at({0.1, 0.2, 20}, {0, 0, -1})); });
}

TEST(Image, RefusesMoreMatricesThanThereArePlaces) {
  Scene scene = scene_of(testing::soup(2, 10, 0.1));
  scene.instances.resize(kMaxMatrices, scene.instances[0]);
  EXPECT_EQ(
      user_error([&] { lay_out(scene, {}, test_core()); }),
      "scene 'soup' needs 131083 matrices (triangles, instances, lights and the camera), 11 more "
      "than the 131072 that the board's memory holds; use fewer or smaller objects");
}

/// A tree of one leaf with so many items.
Tree long_leaf(std::size_t items) {
  Tree tree;
  tree.nodes = {{}, {kLeafAxis, 0, 0, static_cast<std::uint32_t>(items)}};
  tree.items.resize(items);
  tree.root = tree.clipped_root = 1;
  return tree;
}

TEST(Image, RefusesMoreListEntriesThanThereArePlaces) {
  const Scene scene = scene_of(testing::soup(2, 10, 0.1));
  const std::vector<Tree> trees{long_leaf(kMaxListEntries + 3)};
  EXPECT_EQ(
      user_error([&] { ObjectImage(scene, trees, test_core()); }),
      "scene 'soup' needs 524291 list entries, 3 more than the 524288 that the board's memory "
      "holds; use fewer or smaller objects");
}

TEST(Image, RefusesMoreNodesThanThereArePlaces) {
  const Scene scene = scene_of(testing::soup(2, 10, 0.1));
  std::vector<Tree> trees{long_leaf(1)};
  trees[0].nodes.resize(kMaxNodes + 7, trees[0].nodes[1]);
  EXPECT_EQ(user_error([&] { ObjectImage(scene, trees, test_core()); }),
            "scene 'soup' needs 524294 tree nodes, 7 more than the 524287 that the board's memory "
            "holds; use fewer or smaller objects");
}

TEST(Image, RefusesWhatTheFramePartAddsBeyondTheLimit) {
  const Scene scene = scene_of(testing::soup(2, 10, 0.1));
  ObjectImage objects(scene, build_scene_trees(scene).objects, test_core());
  objects.memory.first_node += kMaxNodes - 3 - objects.memory.end_node();
  EXPECT_EQ(user_error([&] {
              FrameImage(scene, objects, build_instance_tree(scene, objects.boxes()),
                         testing::camera_at({0, 0, 9}, {0, 0, -1}), 64, 64);
            }),
            "scene 'soup' needs 524291 tree nodes, 4 more than the 524287 that the board's memory "
            "holds; use fewer or smaller objects");
}

TEST(Image, RefusesTrianglesThatTheNumbersCannotHold) {
  Scene scene = scene_of(testing::soup(3, 2, 0.1));
  add_triangle(scene.objects[0], {0, 0, 0}, {1, 0, 0}, {0, 1e-21, 0});
  EXPECT_EQ(error_of(scene),
            "object 'soup', triangle 2: its matrix has the element -1e+21, outside the core's "
            "numbers (-3.6893e+19 to 3.6893e+19); make the triangle thicker or larger");
  Scene flat = scene_of(testing::soup(3, 2, 0.1));
  add_triangle(flat.objects[0], {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(error_of(flat),
            "object 'soup', triangle 2 has no area; its corners must not lie on one line");
}

TEST(Image, RefusesTransformsThatCannotBeInverted) {
  Scene scene = scene_of(testing::soup(3, 20, 0.1));
  scene.instances[0].transform = glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 1));
  EXPECT_EQ(error_of(scene),
            "instance 'one' has a transform without an inverse; the transform must not flatten its "
            "object");
  scene.instances[0].transform = glm::scale(glm::dmat4(1), glm::dvec3(1, 1e-30, 1));
  EXPECT_EQ(
      error_of(scene),
      "instance 'one': the inverse of its transform has the element 1e+30, outside the core's "
      "numbers (-3.6893e+19 to 3.6893e+19); let the transform flatten or shrink its object less");
}

TEST(Image, RefusesACameraBeyondTheNumbers) {
  const Scene scene = scene_of(testing::soup(3, 20, 0.1));
  EXPECT_EQ(user_error([&] { Laid(scene, testing::camera_at({0, 1e30, 0}, {0, 0, -1})); }),
            "the camera's matrix has the element 1e+30, outside the core's numbers (-3.6893e+19 to "
            "3.6893e+19); move the camera closer to the scene");
}

TEST(Image, RefusesALightBeyondTheNumbers) {
  Scene scene = scene_of(testing::soup(3, 20, 0.1));
  scene.lights.push_back({"star", {0, -1e30, 0}});
  EXPECT_EQ(error_of(scene),
            "light 'star' stands at y = -1e+30, outside the core's numbers (-3.6893e+19 to "
            "3.6893e+19); move it closer to the scene");
}

}  // namespace
}  // namespace dynrt::host
