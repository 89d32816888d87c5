// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/frame_image.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "host/layout/test_scene.h"
#include "host/tree/scene_trees.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host {
namespace {

using testing::expect_near;
using testing::Laid;
using testing::scene_of;
using testing::test_core;
using testing::two_objects;

/// Compares a tree with what lies at an address, node by node and entry by entry.
void expect_tree(const SceneMemory& memory, const Tree& tree, std::uint32_t index,
                 std::uint32_t address, std::uint32_t first_matrix) {
  if (index == kNullNode) {
    EXPECT_EQ(address, 0u);
    return;
  }
  const TreeNode& expected = tree.nodes[index];
  const MemoryNode node = memory.node(address);
  ASSERT_EQ(static_cast<std::uint8_t>(node.kind), expected.axis);
  if (expected.is_leaf()) {
    for (std::uint32_t i = 0; i < expected.right; ++i) {
      const ListEntry entry = memory.entry(node.left + i);
      ASSERT_EQ(entry.matrix.to_u64(), first_matrix + tree.items[expected.left + i]);
      ASSERT_EQ(entry.last, i + 1 == expected.right);
    }
    return;
  }
  ASSERT_EQ(node.split, expected.split);
  expect_tree(memory, tree, expected.left, node.left, first_matrix);
  expect_tree(memory, tree, expected.right, node.right, first_matrix);
}

class ImageIn : public ::testing::TestWithParam<const MemoryFormat*> {};

TEST_P(ImageIn, TreesAndMatricesComeBackFromTheBanks) {
  const MemoryFormat& format = *GetParam();
  const double step = std::ldexp(1.0, -static_cast<int>(format.mantissa_bits));
  const Laid laid(two_objects(), testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}), format);
  std::uint32_t first_matrix = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Tree& tree = laid.trees.objects[k];
    const ObjectImage::Object& object = laid.objects.objects[k];
    EXPECT_EQ(object.first_matrix, first_matrix);
    expect_tree(laid.memory, tree, tree.clipped_root, object.clipped_root, first_matrix);
    expect_tree(laid.memory, tree, tree.root, object.root, first_matrix);
    const Mesh& mesh = laid.scene.objects[k];
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const MatrixColumns columns = laid.memory.matrix(first_matrix + i);
      ASSERT_EQ(extra_bits(columns), k == 0 ? 0x808080u : 0x0080ffu);
      // The corners go to the unit triangle's, the normal to (0, 0, 1).
      const glm::dmat4x3 m = from_columns(columns);
      const glm::uvec3& t = mesh.triangles[i];
      const glm::dvec3 a = mesh.vertices[t.x], b = mesh.vertices[t.y], c = mesh.vertices[t.z];
      const glm::dvec3 normal = glm::normalize(glm::cross(a - c, b - c));
      const double shortest =
          glm::length(glm::cross(a - c, b - c)) / std::max(glm::length(a - c), glm::length(b - c));
      const double tolerance = 8 * step / shortest;
      ASSERT_LT(glm::length(m * glm::dvec4(a, 1) - glm::dvec3(1, 0, 0)), tolerance);
      ASSERT_LT(glm::length(m * glm::dvec4(b, 1) - glm::dvec3(0, 1, 0)), tolerance);
      ASSERT_LT(glm::length(m * glm::dvec4(c, 1)), tolerance);
      ASSERT_NEAR((m * glm::dvec4(normal, 0)).z, 1.0, 8 * step);
    }
    first_matrix += static_cast<std::uint32_t>(mesh.triangles.size());
  }
  EXPECT_EQ(laid.frame.first_instance, first_matrix);
  expect_tree(laid.memory, laid.trees.instances, laid.trees.instances.clipped_root,
              laid.frame.start_node, first_matrix);
  for (std::uint32_t i = 0; i < laid.scene.instances.size(); ++i) {
    const MatrixColumns columns = laid.memory.matrix(first_matrix + i);
    expect_near(from_columns(columns),
                glm::dmat4x3(glm::inverse(laid.scene.instances[i].transform)), format);
    EXPECT_EQ(extra_bits(columns), laid.objects.objects[i % 2].clipped_root);
  }
  EXPECT_EQ(laid.frame.camera_matrix, first_matrix + 5);
  const MemoryUse use = memory_use(laid.frame);
  EXPECT_EQ(use.matrices, first_matrix + 6);
  EXPECT_EQ(use.nodes, laid.trees.objects[0].nodes.size() + laid.trees.objects[1].nodes.size() +
                           laid.trees.instances.nodes.size() - 2);
  EXPECT_DOUBLE_EQ(use.matrix_megabytes(),
                   1.5e-6 * format.word_bits * static_cast<double>(use.matrices));
}

INSTANTIATE_TEST_SUITE_P(Formats, ImageIn,
                         ::testing::Values(&kShippedFormat, &kMemoryFormatOf<hls::Float<5, 8>>,
                                           &kMemoryFormatOf<hls::Float<6, 12>>,
                                           &kMemoryFormatOf<hls::Float<8, 23>>),
                         [](const auto& info) {
                           return fmt::format("E{}M{}", info.param->exponent_bits,
                                              info.param->mantissa_bits);
                         });

TEST(Image, OfWideWordsOnlyWholeOnesAreWrittenAgain) {
  const MemoryFormat& wide = kMemoryFormatOf<hls::Float<8, 23>>;
  MemoryPart part;
  part.format = &wide;
  part.first_column = 8;
  part.columns = {{{1, 2, 3}, 7}, {{4, 5, 6}, 8}, {{7, 8, 9}, 9}};
  const std::vector<MemoryRun> before = part.runs();
  part.columns[1].value[2] = 60;
  const std::vector<MemoryRun> changes = changed_runs(before, part.runs(), wide.bus_words());
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].bank, 2u);
  EXPECT_EQ(changes[0].address, kColumnBase + 9);
  EXPECT_EQ(changes[0].words.size(), 2u);
}

TEST(Image, MirrorsAndLightsHaveMatricesOfTheirOwn) {
  Scene scene = two_objects();
  scene.materials[1].mirror = 0.5;
  scene.lights.push_back({"lamp", {1, 2, 3}, {2, 4, 1}});
  const Laid laid(scene, testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}));
  const std::uint32_t plain = laid.objects.objects[1].first_matrix;
  const Mesh& ball = laid.scene.objects[1];
  ASSERT_EQ(laid.frame.first_instance, plain + 2 * ball.triangles.size());
  ASSERT_FALSE(ball.triangles.empty());
  for (std::uint32_t i = 0; i < ball.triangles.size(); ++i) {
    const MatrixColumns matrix = laid.memory.matrix(plain + 2 * i);
    EXPECT_EQ(matrix[1].spare, 128u) << "it reflects half of the light";
    // A reflection leaves its plane where it is, and what is before it comes to lie behind it.
    const glm::dmat4x3 mirror = from_columns(laid.memory.matrix(plain + 2 * i + 1));
    const glm::dmat4x3 triangle = from_columns(matrix);
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const glm::dvec3 v = ball.vertices[ball.triangles[i][static_cast<int>(corner)]];
      EXPECT_NEAR(glm::length(mirror * glm::dvec4(v, 1) - v), 0, 1e-3);
    }
    const glm::dvec3 point(0.3, -2.1, 1.7);
    const glm::dvec3 image = mirror * glm::dvec4(point, 1);
    EXPECT_NEAR((triangle * glm::dvec4(image, 1)).z, -(triangle * glm::dvec4(point, 1)).z, 1e-3);
  }
  for (std::uint32_t i = 0; i < 5; ++i) {
    const std::uint32_t into = laid.frame.first_instance + 2 * i;
    const glm::dmat4 there(from_columns(laid.memory.matrix(into)));
    const glm::dmat4 back(from_columns(laid.memory.matrix(into + 1)));
    const glm::dvec4 point(0.4, 1.1, -0.7, 1);
    EXPECT_NEAR(glm::length(back * (there * point) - point), 0, 1e-2);
  }
  EXPECT_EQ(laid.frame.camera_matrix, laid.frame.first_instance + 10);
  EXPECT_EQ(laid.frame.light_matrix, laid.frame.camera_matrix + 1);
  const MatrixColumns light = laid.memory.matrix(laid.frame.light_matrix);
  EXPECT_EQ(from_columns(light)[2], glm::dvec3(1, 2, 3));
  EXPECT_EQ(from_columns(light)[3], glm::dvec3(1, 2, 3));
  EXPECT_EQ(from_columns(light)[0].x, 4);
  EXPECT_EQ(extra_bits(light), 128u | 255u << 8 | 64u << 16);
}

/// The corners of every instance lie in its box, seen from the eye, and the boxes are not wide.
TEST(Image, BoxesInTheWorldFollowTheLights) {
  Scene scene = two_objects();
  scene.lights.push_back({"lamp", {1, 2, 3}, {2, 4, 1}});
  CoreInfo core = test_core();
  core.origins = Origins::kCommon;
  const glm::dvec3 eye(0.1, 0.2, 20);
  const Camera camera = testing::camera_at(eye, {0, 0, -1});
  const SceneTrees trees = build_scene_trees(scene);
  const ObjectImage objects(scene, trees.objects, core);
  const FrameImage frame(scene, objects, trees.instances, camera, 320, 240);
  ASSERT_EQ(frame.box_column + frame.first_instance, 4 * (frame.light_matrix + 1));
  SceneMemory memory(*core.format);
  memory.write(frame.memory.runs());
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const MemoryColumn column = memory.column(frame.box_column + frame.first_instance + i);
    glm::dvec3 low(1e9), high(-1e9);
    for (const glm::dvec3& v : scene.objects[instance.object].vertices) {
      const glm::dvec3 seen = glm::dvec3(instance.transform * glm::dvec4(v, 1)) - eye;
      low = glm::min(low, seen);
      high = glm::max(high, seen);
    }
    // A bound is the upper 16 bits of a number.
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t bits = core.format->bits(column.value[static_cast<unsigned>(axis)]) |
                                 static_cast<std::uint32_t>(column.spare >> (8 * axis) & 255) << 24;
      const double from = core.format->number((bits & 0xffff) << 8);
      const double to = core.format->number(bits >> 16 << 8);
      EXPECT_LT(from, low[axis]) << i;
      EXPECT_GT(to, high[axis]) << i;
      const double box = high[axis] - low[axis];
      EXPECT_LT(to - from, 2.5 * box + 0.3) << i;
    }
  }
  EXPECT_EQ(memory_use(frame).matrices, frame.light_matrix + 3) << "five boxes in two matrices";
  core.lights = 1;
  const FrameImage lit(scene, ObjectImage(scene, trees.objects, core), trees.instances, camera, 320,
                       240);
  EXPECT_EQ(lit.box_column, frame.box_column);
  EXPECT_EQ(lit.boxes_apart, scene.instances.size());
  EXPECT_EQ(memory_use(lit).matrices, lit.light_matrix + 4) << "ten boxes in three";
  const FrameImage from_light(scene, objects, trees.instances,
                              testing::camera_at(scene.lights[0].position, {0, 0, -1}), 320, 240);
  SceneMemory lit_memory(*core.format), from_memory(*core.format);
  lit_memory.write(lit.memory.runs());
  from_memory.write(from_light.memory.runs());
  for (std::uint32_t i = lit.first_instance; i < lit.first_instance + lit.boxes_apart; ++i) {
    const MemoryColumn column = lit_memory.column(lit.box_column + lit.boxes_apart + i);
    const MemoryColumn expected = from_memory.column(from_light.box_column + i);
    EXPECT_EQ(column.value, expected.value) << "as it lies from an eye in the light's place";
    EXPECT_EQ(column.spare, expected.spare);
  }
  core.lights = 0;
  core.origins = Origins::kEach;
  const ObjectImage without(scene, trees.objects, core);
  const FrameImage plain(scene, without, trees.instances, camera, 320, 240);
  EXPECT_EQ(plain.memory.end_column(), 4 * (plain.light_matrix + 1));
  EXPECT_EQ(plain.first_instance, frame.first_instance) << "hits keep their numbers";
}

TEST(Image, ABoxInTheWorldTakesThePlaceOfTheNodesUnlessItIsLoose) {
  Scene scene = two_objects();
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const glm::dmat4 moved =
        glm::translate(glm::dmat4(1), glm::dvec3(4.0 * static_cast<double>(i), 0, 0));
    scene.instances[i].transform =
        i % 2 == 0 ? moved : glm::rotate(moved, 0.7, glm::dvec3(0, 1, 0));
  }
  const SceneTrees trees = build_scene_trees(scene);
  for (const Origins origins : {Origins::kEach, Origins::kCommon}) {
    CoreInfo core = test_core();
    core.origins = origins;
    const ObjectImage objects(scene, trees.objects, core);
    const Camera camera = testing::camera_at({0.1, 30, 20}, {0, 0, -1});
    const FrameImage frame(scene, objects, trees.instances, camera, 320, 240);
    SceneMemory memory(*core.format);
    memory.write(frame.memory.runs());
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      const ObjectImage::Object& object = objects.objects[scene.instances[i].object];
      const bool without = origins == Origins::kCommon && i % 2 == 0;
      EXPECT_EQ(extra_bits(memory.matrix(frame.first_instance + i)),
                without ? object.root : object.clipped_root)
          << i;
    }
  }
}

TEST(Image, NodeZeroIsNeverUsed) {
  const Laid laid(two_objects(), testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}));
  EXPECT_EQ(laid.objects.memory.first_node, 1u);
  EXPECT_EQ(laid.frame.memory.first_node, laid.objects.memory.end_node());
}

TEST(Image, ACameraInsideABoxStartsAtTheRealRoot) {
  const Laid inside(two_objects(), testing::camera_at({0.1, 0.2, 0.1}, {0, 0, -1}));
  const Tree& top = inside.trees.instances;
  EXPECT_EQ(inside.frame.start_node, inside.frame.memory.first_node + top.root - 1);
  EXPECT_EQ(extra_bits(inside.memory.matrix(inside.frame.first_instance)),
            inside.objects.objects[0].root);
  EXPECT_EQ(extra_bits(inside.memory.matrix(inside.frame.first_instance + 1)),
            inside.objects.objects[1].clipped_root);
}

TEST(Image, RaysStartInTheMainObjectsLeaf) {
  const Scene scene = two_objects();
  std::vector<Aabb> boxes{{glm::dvec3(-100), glm::dvec3(100)}, {glm::dvec3(-1), glm::dvec3(1)}};
  CoreInfo core = testing::test_core();
  core.datapath = Datapath::kFast;
  SceneTrees trees = build_scene_trees(scene, {.leaves = Leaves::kPointers});
  trees.instances =
      build_instance_tree(scene, boxes, {.leaves = Leaves::kPointers, .main_first = true});
  const ObjectImage objects(scene, trees.objects, core);
  const FrameImage frame(scene, objects, trees.instances,
                         testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}), 64, 48);
  SceneMemory memory;
  memory.write(frame.memory.runs());
  constexpr std::uint32_t kMark = 1u << (kAddressBits - 1);
  ASSERT_GE(frame.start_node, kMark);
  const ListEntry main = memory.entry((frame.start_node - kMark) * kListStep);
  EXPECT_TRUE(main.last);
  const std::uint32_t item =
      trees.instances.items[trees.instances.nodes[trees.instances.main_leaf].left];
  EXPECT_EQ(main.matrix.to_u64(), frame.first_instance + item);
  EXPECT_EQ(frame.others_node, frame.memory.first_node + trees.instances.entry({0.1, 0.2, 20}) - 1);
}

TEST(Image, TheCameraMatrixSamplesPixelCentres) {
  const Camera camera = testing::camera_at({1, 2, 3}, {0.3, -0.2, -1});
  const glm::dmat4x3 m = camera_matrix(camera, 512, 384);
  EXPECT_EQ(m * glm::dvec4(0, 0, 0, 1), camera.position);
  // The top left pixel's centre is half a pixel right of and below the picture's corner.
  const glm::dvec3 expected =
      (0.5 / 512 - 0.5) * camera.right + (0.5 - 0.5 / 384) * camera.up + camera.forward;
  EXPECT_LT(glm::length(m * glm::dvec4(0, 0, 1, 0) - expected), 1e-12);
  const glm::dvec3 last =
      (0.5 - 0.5 / 512) * camera.right + (0.5 / 384 - 0.5) * camera.up + camera.forward;
  EXPECT_LT(glm::length(m * glm::dvec4(511, 383, 1, 0) - last), 1e-12);
}

TEST(Image, OnlyWhatChangedIsWrittenAgain) {
  Laid laid(two_objects(), testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}));
  const std::vector<MemoryRun> before = laid.frame.memory.runs();
  EXPECT_TRUE(changed_runs(before, before).empty());
  laid.scene.instances[3].transform[3] += glm::dvec4(0.5, 0.25, 0, 0);
  const Tree top = build_instance_tree(laid.scene, laid.objects.boxes());
  const FrameImage moved(laid.scene, laid.objects, top,
                         testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}), 512, 384);
  const std::vector<MemoryRun> after = moved.memory.runs();
  const std::vector<MemoryRun> changes = changed_runs(before, after);
  std::size_t changed = 0, all = 0;
  for (const MemoryRun& run : changes) changed += run.words.size();
  for (const MemoryRun& run : after) all += run.words.size();
  EXPECT_GT(changed, 0u);
  EXPECT_LT(changed, all / 2);
  laid.memory.write(changes);
  expect_tree(laid.memory, top, top.clipped_root, moved.start_node, moved.first_instance);
  expect_near(from_columns(laid.memory.matrix(moved.first_instance + 3)),
              glm::dmat4x3(glm::inverse(laid.scene.instances[3].transform)));
}

TEST(Image, TheTopLevelHasWhatTheObjectsLeave) {
  const Laid laid(two_objects(), testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}));
  const TreeSize room = laid.objects.room_left();
  EXPECT_EQ(laid.frame.memory.first_node + room.nodes, kMaxNodes);
  EXPECT_EQ(laid.frame.memory.first_entry + room.items, kMaxListEntries);
}

TEST(Image, SmallElementsBecomeTheSmallestMagnitude) {
  Scene scene = scene_of(testing::soup(3, 20, 0.1));
  const Laid laid(scene, testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}));
  const glm::dmat4x3 identity = from_columns(laid.memory.matrix(laid.frame.first_instance));
  EXPECT_EQ(identity[0][0], 1.0);
  EXPECT_EQ(std::abs(identity[1][0]), std::ldexp(1.0, -63));
}

}  // namespace
}  // namespace dynrt::host
