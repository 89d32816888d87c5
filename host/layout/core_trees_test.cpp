// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/core_trees.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "hls/random.h"
#include "host/layout/test_scene.h"

namespace dynrt::host {
namespace {

using testing::two_objects;

CoreInfo watertight() {
  CoreInfo core = testing::test_core();
  core.triangle_test = TriangleTest::kWatertight;
  return core;
}

TEST(CoreTrees, AreBuiltForTheCostsOfTheCore) {
  const Scene scene = two_objects();
  const auto nodes_of = [&scene](Datapath datapath) {
    CoreInfo core = testing::test_core();
    core.datapath = datapath;
    std::size_t nodes = 0;
    for (const Tree& tree : trees_for(scene, glm::dvec3(0, 0, 9), core).objects) {
      nodes += tree.nodes.size();
    }
    return nodes;
  };
  EXPECT_LT(nodes_of(Datapath::kThesis), nodes_of(Datapath::kFast))
      << "dearer items are parted by more nodes";
}

TEST(FormTrees, AWatertightTrianglesColumnsAreItsCornersAndItsNormal) {
  const Scene scene = two_objects();
  const SceneTrees trees = trees_for(scene, glm::dvec3(0, 0, 9), watertight());
  const ObjectImage objects(scene, trees.objects, watertight());
  SceneMemory memory;
  memory.write(objects.memory.runs());
  for (std::size_t k = 0; k < 2; ++k) {
    const Mesh& mesh = scene.objects[k];
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const std::uint32_t first = 4 * (objects.objects[k].first_matrix + i);
      const auto corners = mesh.corners(i);
      for (unsigned c = 0; c < 3; ++c) {
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_EQ(memory.column(first + c).value[axis], kShippedFormat.round(corners[c][axis]));
        }
      }
      const glm::dvec3 normal =
          glm::normalize(glm::cross(corners[0] - corners[2], corners[1] - corners[2]));
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(memory.column(first + 3).value[axis], normal[axis], 0x1p-16);
      }
    }
  }
}

TEST(FormTrees, CornersAreRoundedWhereverTheyAreShared) {
  Scene scene = two_objects();
  for (glm::dvec3& v : scene.objects[1].vertices) v += glm::dvec3(1000, 0, -7);
  const Scene rounded = with_rounded_corners(scene, kShippedFormat);
  for (std::size_t i = 0; i < scene.objects[1].vertices.size(); ++i) {
    const glm::dvec3 v = rounded.objects[1].vertices[i];
    ASSERT_EQ(v.x, kShippedFormat.round(v.x));
    ASSERT_LE(std::abs(v.x - scene.objects[1].vertices[i].x), 0x1p-8);
  }
}

TEST(FormTrees, MarginsGrowWithTheDistanceUpToALimitAndScaleWithTheScene) {
  Scene scene = two_objects();
  const auto margins = [&](double distance) {
    return rounding_margins(scene, glm::dvec3(0, 0, distance), kShippedFormat)[1];
  };
  const double near = margins(2);
  EXPECT_GT(near, 16 * 0x1p-17 * 2);
  EXPECT_GT(margins(50), 2 * near);
  EXPECT_EQ(margins(1e5), margins(1e6));
  EXPECT_NEAR(margins(1e6), kWidest * 2, 1e-3);
  const auto beyond = [&](double distance) {
    return beyond_margins(scene, glm::dvec3(0, 0, distance), kShippedFormat).size();
  };
  EXPECT_EQ(beyond(2), 0u);
  EXPECT_EQ(beyond(1e6), 2u);

  Scene larger = scene;
  for (Mesh& mesh : larger.objects) {
    for (glm::dvec3& v : mesh.vertices) v *= 1024.0;
  }
  for (Instance& instance : larger.instances) {
    for (int axis = 0; axis < 3; ++axis) instance.transform[3][axis] *= 1024.0;
  }
  const auto scaled = rounding_margins(larger, glm::dvec3(0, 0, 1024 * 2), kShippedFormat);
  EXPECT_EQ(scaled[1], 1024 * near);
}

TEST(FormTrees, MarginsHoldWhereverInstancesAndCameraGo) {
  Scene scene = two_objects();
  const glm::dvec3 eye(0, 0, 2);
  const double still = rounding_margins(scene, eye, kShippedFormat)[1];
  scene.camera = Camera{};
  scene.path = {{.time = 0, .position = eye, .look_at = {0, 0, 0}},
                {.time = 1, .position = {0, 0, 40}, .look_at = {0, 0, 0}}};
  EXPECT_GT(rounding_margins(scene, eye, kShippedFormat)[1], 2 * still);
}

/// The leaf of a point within the tree's box.
std::vector<std::uint32_t> items_at(const Tree& tree, const glm::dvec3& p) {
  std::uint32_t index = tree.root;
  while (index != kNullNode && !tree.nodes[index].is_leaf()) {
    const TreeNode& node = tree.nodes[index];
    index = p[node.axis] < node.split ? node.left : node.right;
  }
  if (index == kNullNode) return {};
  const auto first = tree.items.begin() + tree.nodes[index].left;
  return {first, first + tree.nodes[index].right};
}

TEST(FormTrees, ATriangleIsListedWhereARayMayPassBesideIt) {
  const Scene scene = two_objects();
  const glm::dvec3 eye(0, 3, 40);
  const SceneTrees trees = trees_for(scene, eye, watertight());
  const std::vector<double> margins = rounding_margins(scene, eye, kShippedFormat);
  hls::testing::Random random(6);
  const auto unit = [&random] { return static_cast<double>(random.below(1u << 20)) * 0x1p-20; };
  for (std::size_t k = 0; k < 2; ++k) {
    const Mesh mesh = with_rounded_corners(scene, kShippedFormat).objects[k];
    for (unsigned n = 0; n < 20'000; ++n) {
      const auto i = static_cast<std::uint32_t>(random.below(mesh.triangles.size()));
      const auto [a, b, c] = mesh.corners(i);
      const double u = unit(), v = (1 - u) * unit();
      glm::dvec3 p = u * a + v * b + (1 - u - v) * c;
      for (int axis = 0; axis < 3; ++axis) p[axis] += 0.999 * margins[k] * (2 * unit() - 1);
      const auto items = items_at(trees.objects[k], p);
      ASSERT_TRUE(std::ranges::find(items, i) != items.end())
          << "object " << k << ", triangle " << i;
      ASSERT_TRUE(trees.objects[k].box.holds(p));
    }
  }
}

}  // namespace
}  // namespace dynrt::host
