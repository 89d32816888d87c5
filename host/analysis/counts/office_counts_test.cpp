// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The tree of the scene `office` is no worse than the yardstick: the figures per packet of 2x2
// primary rays at 512x384, with six clipping nodes, that a throw-away builder reached on such an
// office (its views were others).
#include <gtest/gtest.h>

#include "host/analysis/counts/counts.h"
#include "host/scene/camera.h"
#include "host/scene/load.h"

namespace dynrt::host {
namespace {

TEST(OfficeCounts, AreWithinTheYardstick) {
  constexpr unsigned kWidth = 512, kHeight = 384;
  const Scene scene = load_scene("office");
  const SceneTrees trees = build_scene_trees(scene);
  const Camera camera = choose_camera(scene, {}, kWidth, kHeight);
  TraceOptions options;
  options.scene_clipping = options.object_clipping = Clipping::kAlways;
  const TracedFrame frame = trace_frame(scene, trees, camera, kWidth, kHeight, options);
  const WorkCounts& work = frame.work;
  const auto per_packet = [&](std::uint64_t count) {
    return static_cast<double>(count) / static_cast<double>(work.packets);
  };
  EXPECT_EQ(work.hits, std::uint64_t{kWidth} * kHeight);  // a closed room
  EXPECT_EQ(per_packet(work.objects), 1.0);
  EXPECT_LT(per_packet(work.object_steps), 36.1);
  // The top level adds one leaf of one entry.
  EXPECT_LT(per_packet(work.leaf_fetches + work.empty_leaves) - 1, 7.3);
  EXPECT_LT(per_packet(work.triangles), 4.0);
  EXPECT_LT(per_packet(work.list_entries) - 1, 4.2);
  EXPECT_LT(work.deepest_stack, 23);
}

}  // namespace
}  // namespace dynrt::host
