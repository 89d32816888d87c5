// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The forms that objects take in the memory of some configurations.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "host/layout/core_trees.h"
#include "host/layout/test_scene.h"

namespace dynrt::host {
namespace {

using testing::expect_near;
using testing::test_core;
using testing::two_objects;

/// What a core makes of a triangle stored in three columns, by the text of memory_format.h.
struct Expanded {
  glm::dmat4x3 matrix;
  std::uint32_t colour = 0, mirror = 0;
  double cosine_factor = 0;
};
Expanded expand(const SceneMemory& memory, std::uint32_t number) {
  const auto at = [&](std::uint32_t column) { return memory.column(3 * number + column); };
  const auto values = [](const MemoryColumn& c) {
    return glm::dvec3(c.value[0], c.value[1], c.value[2]);
  };
  const auto byte = [&](std::uint32_t column, unsigned number_of_byte) {
    return static_cast<std::uint32_t>(at(column).spare >> (8 * number_of_byte) & 255);
  };
  EXPECT_EQ(byte(0, 2), byte(1, 2));
  const int ones = static_cast<int>(byte(0, 2));
  Expanded e;
  e.matrix[ones] = glm::dvec3(1);
  e.matrix[ones == 0 ? 1 : 0] = values(at(0));
  e.matrix[ones == 2 ? 1 : 2] = values(at(1));
  e.matrix[3] = values(at(2));
  e.colour = byte(0, 0) | byte(0, 1) << 8 | byte(1, 1) << 16;
  e.mirror = byte(1, 0);
  e.cosine_factor = kShippedFormat.number(static_cast<std::uint32_t>(at(2).spare));
  return e;
}

CoreInfo three_columns() {
  CoreInfo core = test_core();
  core.triangle_matrix = TriangleMatrix::kMemoryEfficient;
  return core;
}

TEST(ObjectImage, TrianglesInThreeColumns) {
  Scene scene = two_objects();
  const SceneTrees trees = build_scene_trees(scene);
  const ObjectImage objects(scene, trees.objects, three_columns());
  const ObjectImage four(scene, trees.objects, test_core());
  EXPECT_EQ(objects.memory.columns.size() * 4, four.memory.columns.size() * 3);
  SceneMemory memory;
  memory.write(objects.memory.runs());
  std::uint32_t number = 0;
  std::array<int, 3> ones{};
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(objects.objects[k].first_matrix, number);
    const Mesh& mesh = scene.objects[k];
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i, ++number) {
      const Expanded e = expand(memory, number);
      ASSERT_EQ(e.colour, k == 0 ? 0x808080u : 0x0080ffu);
      ASSERT_EQ(e.mirror, 0u);
      const auto [a, b, c] = mesh.corners(i);
      const glm::dvec3 normal = glm::normalize(glm::cross(a - c, b - c));
      const double shortest =
          glm::length(glm::cross(a - c, b - c)) / std::max(glm::length(a - c), glm::length(b - c));
      const double tolerance = 1e-4 / shortest;
      ASSERT_LT(glm::length(e.matrix * glm::dvec4(a, 1) - glm::dvec3(1, 0, 0)), tolerance);
      ASSERT_LT(glm::length(e.matrix * glm::dvec4(b, 1) - glm::dvec3(0, 1, 0)), tolerance);
      ASSERT_LT(glm::length(e.matrix * glm::dvec4(c, 1)), tolerance);
      ASSERT_NEAR((e.matrix * glm::dvec4(normal, 0)).z * e.cosine_factor, 1.0, 1e-4);
      for (int axis = 0; axis < 3; ++axis) {
        if (e.matrix[axis] != glm::dvec3(1)) continue;
        ++ones[axis];
        ASSERT_GE(std::abs(normal[axis]), 0.577);
      }
    }
  }
  for (const int count : ones) EXPECT_GT(count, 20);
  const FrameImage frame(scene, objects, trees.instances,
                         testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}), 64, 64);
  EXPECT_EQ(frame.first_instance, (3 * number + 3) / 4);
  memory.write(frame.memory.runs());
  expect_near(from_columns(memory.matrix(frame.first_instance)),
              glm::dmat4x3(glm::inverse(scene.instances[0].transform)));
}

TEST(ObjectImage, TheThesissMatrixHasTheColumnOfOnes) {
  // The inverse has columns a - c, b - c, -(a - c) - (b - c) + e_n and the translation c (5.1.1).
  const std::array<glm::dvec3, 3> t{glm::dvec3(1, 2, 3), {2, -1, 0.5}, {0.5, 0.25, -1}};
  const UnitMatrix unit = efficient_matrix(*triangle_matrix(t));
  const glm::dvec3 a = t[0] - t[2], b = t[1] - t[2];
  glm::dvec3 q = -a - b;
  q[unit.ones] += 1;
  const glm::dmat4 inverse(glm::dvec4(a, 0), glm::dvec4(b, 0), glm::dvec4(q, 0),
                           glm::dvec4(t[2], 1));
  const glm::dmat4x3 expected(glm::inverse(inverse));
  for (int c = 0; c < 4; ++c) EXPECT_LT(glm::length(unit.matrix[c] - expected[c]), 1e-12) << c;
}

TEST(ObjectImage, MirrorsAndSpheresReachIntoTheNextNumbers) {
  Scene scene = two_objects();
  scene.materials.push_back({"mirror", {0, 0, 0}, 0.8});
  scene.objects[0].material[3] = 2;
  scene.objects[0].ellipsoids.push_back({glm::scale(glm::dmat4(1), glm::dvec3(2)), 1});
  const SceneTrees trees = build_scene_trees(scene);
  const ObjectImage objects(scene, trees.objects, three_columns());
  SceneMemory memory;
  memory.write(objects.memory.runs());
  const Mesh& mesh = scene.objects[0];
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  EXPECT_EQ(expand(memory, 3).mirror, 205u);
  const auto four = [&](std::uint32_t number) {
    return MatrixColumns{memory.column(3 * number), memory.column(3 * number + 1),
                         memory.column(3 * number + 2), memory.column(3 * number + 3)};
  };
  const glm::dmat4x3 reflection = from_columns(four(4));
  const auto corners = mesh.corners(3);
  EXPECT_LT(glm::length(reflection * glm::dvec4(corners[0], 1) - corners[0]), 1e-3);
  EXPECT_LT(glm::length(expand(memory, 6).matrix * glm::dvec4(mesh.corners(4)[2], 1)), 1e-2);
  const MatrixColumns sphere = four(count + 2);
  EXPECT_EQ(from_columns(sphere)[0].x, 0.5);
  EXPECT_EQ(extra_bits(sphere), 0x0080ffu);
  EXPECT_EQ(kShippedFormat.number(static_cast<std::uint32_t>(sphere[3].spare)), 2);
  EXPECT_EQ(objects.objects[1].first_matrix, count + 4);
  unsigned spheres = 0, triangles = 0;
  for (const ListEntry& entry : objects.memory.entries) {
    if (entry.primitive() == Primitive::kSphere) {
      ++spheres;
      EXPECT_EQ(entry.matrix.to_u64(), count + 2);
    }
    triangles += entry.primitive() == Primitive::kTriangle;
  }
  EXPECT_GT(spheres, 0u);
  EXPECT_EQ(spheres + triangles, objects.memory.entries.size());
}

/// Follows the pointers of a tree whose leaves have no nodes; returns the leaves that it found.
unsigned follow(const SceneMemory& memory, const Tree& tree, std::uint32_t index,
                std::uint32_t pointer, std::uint32_t first_matrix) {
  const TreeNode& expected = tree.nodes[index];
  constexpr std::uint32_t kMark = 1u << (kAddressBits - 1);
  EXPECT_EQ((pointer & kMark) != 0, expected.is_leaf()) << "node " << index;
  if (!expected.is_leaf()) {
    const MemoryNode node = memory.node(pointer);
    unsigned leaves = 0;
    for (const auto& [child, to] :
         {std::pair{expected.left, node.left}, {expected.right, node.right}}) {
      if (child == kNullNode) {
        EXPECT_EQ(to, 0u);
      } else {
        leaves += follow(memory, tree, child, to, first_matrix);
      }
    }
    return leaves;
  }
  std::uint32_t address = (pointer & ~kMark) * kListStep;
  for (std::uint32_t i = 0; i < expected.right; ++i) {
    const ListEntry entry = memory.entry(address++);
    EXPECT_EQ(entry.matrix.to_u64(), first_matrix + tree.items[expected.left + i]);
    EXPECT_EQ(entry.last, i + 1 == expected.right) << "node " << index << ", entry " << i;
  }
  return 1;
}

TEST(ObjectImage, NodesPointToTheListsOfLeaves) {
  const Scene scene = two_objects();
  CoreInfo core = test_core();
  core.datapath = Datapath::kFast;
  const SceneTrees trees = trees_for(scene, glm::dvec3(0, 0, 9), core);
  const ObjectImage objects(scene, trees.objects, core);
  SceneMemory memory;
  memory.write(objects.memory.runs());
  TreeSize sum{1, 0};
  for (std::size_t k = 0; k < trees.objects.size(); ++k) {
    const Tree& tree = trees.objects[k];
    const ObjectImage::Object& object = objects.objects[k];
    EXPECT_EQ(follow(memory, tree, tree.clipped_root, object.clipped_root, object.first_matrix),
              tree.stats.leaf_links);
    sum.nodes += tree.size().nodes;
    sum.items += tree.size().items;
  }
  EXPECT_EQ(objects.memory.end_node(), sum.nodes) << "leaves take no nodes";
  EXPECT_LE(objects.memory.end_entry(), sum.items);
}

}  // namespace
}  // namespace dynrt::host
