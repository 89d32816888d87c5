// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// However overlapping objects are treated, the picture is the same; only the work differs.
#include "host/analysis/counts/overlap.h"

#include <gtest/gtest.h>

#include "host/tree/test_meshes.h"

namespace dynrt::host {
namespace {

constexpr unsigned kSide = 64;

/// A room with balls in it, the room being the third of its instances: the room problem.
Scene furnished_room() {
  Scene scene = testing::scene_of(testing::room(1, 8, 8));
  scene.objects.push_back({});
  testing::add_sphere(scene.objects.back(), {0, 0, 0}, 0.3, 8);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(0.5, 3);
  const Instance room = scene.instances[0];
  scene.instances.clear();
  for (int i = 0; i < 12; ++i) {
    if (i == 2) scene.instances.push_back(room);
    const glm::dvec3 place(at(random), 0.3 * at(random), at(random));
    scene.instances.push_back({"ball", 1, glm::translate(glm::dmat4(1), place)});
  }
  return scene;
}

class Overlap : public ::testing::Test {
 protected:
  Overlap() {
    for (const Tree& tree : trees_.objects) boxes_.push_back(tree.box);
  }
  TracedFrame trace(const TopLevel& top, unsigned slots) const {
    TraceOptions options;
    options.object_slots = slots;
    return trace_frame(scene_, trees_.objects, top, camera_, kSide, kSide, options);
  }
  static void expect_same_picture(const TracedFrame& left, const TracedFrame& right) {
    for (std::size_t i = 0; i < left.hits.size(); ++i) {
      EXPECT_EQ(left.hits[i].hit, right.hits[i].hit) << "pixel " << i;
      EXPECT_EQ(left.hits[i].t, right.hits[i].t) << "pixel " << i;
    }
  }

  const Scene scene_ = furnished_room();
  const SceneTrees trees_ = build_scene_trees(scene_);
  const Camera camera_ = testing::camera_at({2.013, 1.71, 4.02}, {-0.1, -0.2, -1});
  std::vector<Aabb> boxes_;
};

TEST_F(Overlap, AHierarchyEntersTheRoomOnce) {
  const TracedFrame plain = trace({trees_.instances, {}}, 0);
  const TopLevel hierarchy = hierarchical_top_level(trees_.instances);
  EXPECT_EQ(hierarchy.inner[hierarchy.tree.root], std::vector<std::uint32_t>{2});
  EXPECT_LT(hierarchy.tree.size().items, trees_.instances.size().items);
  const TracedFrame traced = trace(hierarchy, 0);
  expect_same_picture(plain, traced);
  EXPECT_EQ(traced.work.hits, kSide * kSide);
  EXPECT_LT(traced.work.objects, 0.8 * static_cast<double>(plain.work.objects));
}

TEST_F(Overlap, TheMainSceneIsEnteredFirstAndOnce) {
  const TracedFrame plain = trace({trees_.instances, {}}, 0);
  const TopLevel top = main_scene_first(scene_, boxes_);
  EXPECT_EQ(top.tree.items[top.tree.nodes[top.tree.main_leaf].left], 2u);
  EXPECT_EQ(std::ranges::count(top.tree.items, 2u), 1) << "no other leaf has it";
  EXPECT_EQ(std::ranges::max(top.tree.items), 12u);
  const TracedFrame traced = trace(top, 0);
  expect_same_picture(plain, traced);
  EXPECT_LT(traced.work.objects, plain.work.objects / 2);
  EXPECT_GE(traced.work.objects, traced.work.packets);
}

TEST_F(Overlap, TheSlotsOfAMailboxKeepTheFirstOrTheLast) {
  const TopLevel plain{trees_.instances, {}};
  TraceOptions options;
  options.object_slots = 1;
  options.single_rays = true;
  const auto objects = [&] {
    return trace_frame(scene_, trees_.objects, plain, camera_, kSide, kSide, options).work.objects;
  };
  const std::uint64_t first_met = objects();
  options.keeps_latest = true;
  const std::uint64_t keeps_latest = objects();
  options.object_slots = 1000;
  const std::uint64_t ever_met = objects();
  EXPECT_NE(first_met, keeps_latest);
  EXPECT_LT(ever_met, std::min(first_met, keeps_latest));
  EXPECT_GE(ever_met, std::uint64_t{kSide} * kSide);
}

TEST(OverlapOfOne, ASceneOfOneInstance) {
  const Scene scene = testing::scene_of(testing::room(1, 8, 8));
  const SceneTrees trees = build_scene_trees(scene);
  const Camera camera = testing::camera_at({2.013, 1.71, 4.02}, {-0.1, -0.2, -1});
  const Aabb boxes[] = {trees.objects[0].box};
  for (const TopLevel& top :
       {hierarchical_top_level(trees.instances), main_scene_first(scene, boxes)}) {
    const TracedFrame frame =
        trace_frame(scene, trees.objects, top, camera, kSide, kSide, TraceOptions{});
    EXPECT_EQ(frame.work.hits, kSide * kSide);
    EXPECT_EQ(frame.work.objects, frame.work.packets);
  }
}

}  // namespace
}  // namespace dynrt::host
