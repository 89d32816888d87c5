// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/box_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "host/format/memory_format_of.h"
#include "host/tree/test_trees.h"

namespace dynrt::host {
namespace {

std::vector<Aabb> random_boxes(int count, double size, double scale) {
  std::mt19937 random(static_cast<unsigned>(count));
  std::uniform_real_distribution<double> at(-1, 1), extent(0, size);
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 low{at(random), at(random), at(random)};
    const glm::dvec3 side{extent(random), extent(random), extent(random)};
    boxes.push_back({low * scale, (low + side) * scale});
  }
  return boxes;
}

/// The box's corners and random points of it lie in leaves that list it.
void expect_good(const std::vector<Aabb>& boxes, const Grid& grid = {}) {
  const Tree tree = build_box_tree(boxes, {.grid = grid});
  testing::expect_sound(tree, grid);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (unsigned k = 0; k < 24; ++k) {
      glm::dvec3 f{unit(random), unit(random), unit(random)};
      if (k < 8) f = {k & 1, k >> 1 & 1, k >> 2};
      const glm::dvec3 p =
          glm::min(boxes[i].low + f * (boxes[i].high - boxes[i].low), boxes[i].high);
      ASSERT_TRUE(testing::found(tree, tree.clipped_root, p, i)) << "box " << i;
    }
  }
}

TEST(BoxTree, EveryBoxIsInEveryLeafThatItTouches) {
  expect_good(random_boxes(2000, 0.05, 1));
  expect_good(random_boxes(500, 0.5, 1));
  expect_good(random_boxes(9, 0.5, 1));
  expect_good(random_boxes(1, 0.5, 1));
}

TEST(BoxTree, HugeTinyAndFlatBoxes) {
  expect_good(random_boxes(300, 0.2, 1e17));
  expect_good(random_boxes(300, 0.2, 1e-15));
  expect_good(random_boxes(300, 0.0, 1));
  std::vector<Aabb> flat = random_boxes(300, 0.2, 1);
  for (Aabb& box : flat) box.low.y = box.high.y = 0;
  expect_good(flat);
}

TEST(BoxTree, TheSameBoxManyTimes) {
  expect_good(std::vector<Aabb>(100, Aabb{{0, 0, 0}, {1, 2, 3}}));
  expect_good(std::vector<Aabb>(100, Aabb{{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}}));
}

TEST(BoxTree, OnCoarseGrids) {
  for (const MemoryFormat* format :
       {&kMemoryFormatOf<hls::Float<5, 8>>, &kMemoryFormatOf<hls::Float<6, 12>>}) {
    const Grid grid(*format);
    expect_good(random_boxes(500, 0.05, 1), grid);
    expect_good(random_boxes(500, 0.05, 1000), grid);
    expect_good(random_boxes(9, 1e-6, 1e-4), grid);
  }
}

TEST(BoxTree, BoxesApartAreApart) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 64; ++i) {
    const int row = i / 8;
    const glm::dvec3 low{3.0 * (i % 8), 3.0 * row, 0};
    boxes.push_back({low, low + 1.0});
  }
  const Tree tree = build_box_tree(boxes);
  EXPECT_EQ(tree.stats.longest_list, 1u);
  EXPECT_EQ(tree.stats.items, 64u);
}

TEST(BoxTree, HugeBoxesAreToldApartAsWell) {
  for (const double scale : {1e-17, 1.0, 8e18}) {
    EXPECT_LT(build_box_tree(random_boxes(300, 0.02, scale)).stats.longest_list, 4u) << scale;
  }
}

TEST(BoxTree, KeepsToItsRoom) {
  const std::vector<Aabb> boxes = random_boxes(500, 0.6, 1);
  const TreeSize whole = build_box_tree(boxes).size();
  ASSERT_GT(whole.items, 2000u);
  EXPECT_FALSE(build_box_tree(boxes, {.room = whole}).cut);
  for (const TreeSize& room :
       {TreeSize{whole.nodes / 2, whole.items}, TreeSize{whole.nodes, whole.items / 2},
        TreeSize{whole.nodes - 1, whole.items}, TreeSize{7, 500}}) {
    const Tree tree = build_box_tree(boxes, {.room = room});
    testing::expect_sound(tree);
    EXPECT_TRUE(tree.cut);
    EXPECT_LE(tree.size().nodes, room.nodes);
    EXPECT_LE(tree.size().items, room.items);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      ASSERT_TRUE(testing::found(tree, tree.clipped_root, boxes[i].low, i)) << "box " << i;
    }
  }
}

TEST(BoxTree, IsTheSameTwice) {
  const std::vector<Aabb> boxes = random_boxes(5000, 0.05, 1);
  testing::expect_same(build_box_tree(boxes), build_box_tree(boxes));
}

}  // namespace
}  // namespace dynrt::host
