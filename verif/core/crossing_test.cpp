// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Packets of reflected rays that cross (thesis 3.1.3), on the model. The truth is the same core
// over trees of one leaf: where nothing is split there is no order of children to get wrong.
#include <gtest/gtest.h>

#include <vector>

#include "configs/whitted.h"
#include "core/specialised.h"
#include "host/board/configurations.h"
#include "host/render/render.h"

namespace dynrt::host {
namespace {

/// Rays that cross where the order matters are rare: one pixel in a thousand.
constexpr unsigned kWidth = 64, kHeight = 48;

/// Rings and mirrors.
constexpr char kScene[] = "lamps";

LayoutOptions trees_of_one_leaf() {
  LayoutOptions layout;
  layout.trees.depth_factor = layout.trees.depth_extra = 0;
  layout.instances = BoxTreeOptions{.depth_factor = 0, .depth_extra = 0};
  return layout;
}

void expect_one_leaf(const SceneTrees& trees) {
  for (const Tree& tree : trees.objects) ASSERT_EQ(tree.stats.leaves, 1u);
  ASSERT_EQ(trees.instances.stats.leaves, 1u);
}

std::vector<std::uint32_t> pixels(Board& board, const MemoryImage& scene) {
  FrameOptions options;
  options.width = kWidth;
  options.height = kHeight;
  return render(board, options, scene).pixels;
}
template <Crossing K>
struct Crosses : config::whitted {
  static constexpr Crossing kCrossing = K;
};
template <Crossing K>
std::vector<std::uint32_t> pixels() {
  const auto board = specialised::board_of<Crosses<K>>();
  return pixels(*board, laid_out(kScene, kWidth, kHeight, board->core()));
}

std::size_t differing(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  EXPECT_EQ(a.size(), std::size_t{kWidth} * kHeight);
  EXPECT_EQ(a.size(), b.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) count += a[i] != b[i];
  return count;
}

class CrossingRays : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto board = make_board(configurations(), {"model", "whitted", ""});
    const MemoryImage scene =
        laid_out(kScene, kWidth, kHeight, board->core(), {}, trees_of_one_leaf());
    expect_one_leaf(scene.trees);
    truth_ = pixels(*board, scene);
  }
  static inline std::vector<std::uint32_t> truth_;
};

TEST_F(CrossingRays, TheFirstRaysOrderMissesCloserHits) {
  EXPECT_GT(differing(pixels<Crossing::kNone>(), truth_), 0u);
}
TEST_F(CrossingRays, RememberingTheOtherChildMissesNone) {
  EXPECT_EQ(differing(pixels<Crossing::kRemember>(), truth_), 0u);
}
TEST_F(CrossingRays, SplittingPacketsByDirectionMissesNone) {
  EXPECT_EQ(differing(pixels<Crossing::kSplit>(), truth_), 0u);
}

}  // namespace
}  // namespace dynrt::host
