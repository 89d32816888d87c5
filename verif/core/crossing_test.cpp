// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Packets of reflected rays that cross (thesis 3.1.3), on the model. The truth is the same core
// over trees of one leaf: where nothing is split there is no order of children to get wrong.
#include <gtest/gtest.h>

#include <vector>

#include "core/scenes.h"
#include "host/board/configurations.h"
#include "host/render/render.h"

namespace dynrt::host {
namespace {

/// Rays that cross where the order matters are rare: one pixel in a thousand.
constexpr unsigned kWidth = 64, kHeight = 48;

MemoryImage rings_and_mirrors() { return laid_out("lamps", kWidth, kHeight); }

void make_trees_of_one_leaf(MemoryImage& scene) {
  TreeOptions options;
  options.depth_factor = 0;
  options.depth_extra = 0;
  scene.trees = build_scene_trees(scene.scene, options);
  for (const Tree& tree : scene.trees.objects) ASSERT_EQ(tree.stats.leaves, 1u);
  scene.objects = ObjectImage(scene.scene, scene.trees.objects);
  scene.trees.instances = build_instance_tree(scene.scene, scene.objects.boxes(),
                                              {.depth_factor = 0, .depth_extra = 0});
  scene.frame = FrameImage(scene.scene, scene.objects, scene.trees.instances, scene.view.camera,
                           kWidth, kHeight);
  ASSERT_EQ(scene.trees.instances.stats.leaves, 1u);
}

std::vector<std::uint32_t> pixels(const char* configuration, const MemoryImage& scene) {
  const auto board = make_board(configurations(), {"model", configuration, ""});
  FrameOptions options;
  options.width = kWidth;
  options.height = kHeight;
  return render(*board, options, scene).pixels;
}

std::size_t differing(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  EXPECT_EQ(a.size(), std::size_t{kWidth} * kHeight);
  EXPECT_EQ(a.size(), b.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) count += a[i] != b[i];
  return count;
}

class Crossing : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    MemoryImage scene = rings_and_mirrors();
    split_scene_ = scene;
    make_trees_of_one_leaf(scene);
    truth_ = pixels("whitted", scene);
  }
  static inline MemoryImage split_scene_;
  static inline std::vector<std::uint32_t> truth_;
};

TEST_F(Crossing, TheFirstRaysOrderMissesCloserHits) {
  EXPECT_GT(differing(pixels("whitted_naive", split_scene_), truth_), 0u);
}
TEST_F(Crossing, RememberingTheOtherChildMissesNone) {
  EXPECT_EQ(differing(pixels("whitted", split_scene_), truth_), 0u);
}
TEST_F(Crossing, SplittingPacketsByDirectionMissesNone) {
  EXPECT_EQ(differing(pixels("whitted_split", split_scene_), truth_), 0u);
}

}  // namespace
}  // namespace dynrt::host
