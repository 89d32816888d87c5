// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/lay_out.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/layout/test_scene.h"

namespace dynrt::host {
namespace {

using testing::add_sphere;
using ::testing::HasSubstr;
using testing::room;
using testing::scene_of;
using ::testing::ThrowsMessage;
using testing::two_objects;

CoreInfo core() { return testing::test_core(); }

View view() {
  const Scene scene = two_objects();
  return {choose_camera(scene, {}, 64, 48), 64, 48};
}

TEST(LayOut, NeedsArePlacesInTheMemory) {
  Scene scene = scene_of(room(1, 6, 6));
  add_sphere(scene.objects.emplace_back(), {0, 0, 0}, 1, 6);
  scene.instances.push_back({"ball", 1});
  scene.lights.push_back({"lamp", {0, 3, 0}});
  scene.materials.front().mirror = 0.5;
  for (const auto form : {TriangleMatrix::kNormalConsistent, TriangleMatrix::kMemoryEfficient}) {
    CoreInfo of_form = core();
    of_form.triangle_matrix = form;
    const MemoryImage image = lay_out(scene, view(), of_form, {.fit = false});
    const SceneNeeds needs = image.needs();
    const MemoryUse use = memory_use(image.frame);
    EXPECT_EQ(needs.places.nodes, use.nodes);
    EXPECT_EQ(needs.places.entries, use.list_entries);
    EXPECT_GE(needs.places.matrices, use.matrices);
    if (form == TriangleMatrix::kNormalConsistent) EXPECT_EQ(needs.places.matrices, use.matrices);
  }
}

TEST(LayOut, AFittedSceneLiesAboutTheOrigin) {
  Scene far = two_objects();
  for (Instance& instance : far.instances) instance.transform[3] += glm::dvec4(1e4, 0, 0, 0);
  const View seen{choose_camera(far, {}, 64, 48), 64, 48};
  const MemoryImage image = lay_out(far, seen, core());
  EXPECT_GT(image.space.centre.x, 9e3);
  const MemoryImage as_it_is = lay_out(far, seen, core(), {.fit = false});
  EXPECT_EQ(as_it_is.space.unit, 1.0);
  EXPECT_EQ(as_it_is.view.camera.position, seen.camera.position);
}

TEST(LayOut, TreesSpareTheStacksUnlessToldNotTo) {
  CoreInfo shallow = core();
  shallow.stack_depth = 2;
  const auto pushes = [&](bool spare) {
    return lay_out(two_objects(), view(), shallow, {.spare_stacks = spare})
        .needs()
        .object_stack.pushes;
  };
  EXPECT_LE(pushes(true), 2);
  EXPECT_GT(pushes(false), 2);
}

TEST(LayOut, TheNextFrameTakesTheSamePlace) {
  MemoryImage image = lay_out(two_objects(), view(), core());
  image.scene.instances[3].transform[3] += glm::dvec4(0.1, 0, 0, 0);
  const FrameImage next = frame_of(image, instances_of(image), image.view.camera);
  EXPECT_EQ(next.memory.first_node, image.frame.memory.first_node);
  EXPECT_EQ(next.first_instance, image.frame.first_instance);
  EXPECT_FALSE(changed_runs(image.frame.memory.runs(), next.memory.runs()).empty());
}

TEST(LayOut, WhatACoreLacksIsRefusedByItsName) {
  CoreInfo balls = core();
  balls.primitives = {.sphere = true};
  EXPECT_THAT([&] { lay_out(two_objects(), view(), balls); },
              ThrowsMessage<UserError>(
                  HasSubstr("has triangles, but configuration test cannot hold them")));
}

TEST(LayOut, ASpecialisedCoreSaysWhichKeyIsExceeded) {
  CoreInfo special = core();
  special.made_for = "sail";
  special.address_bits = 5;
  EXPECT_THAT([&] { lay_out(two_objects(), view(), special); },
              ThrowsMessage<Exceeded>(HasSubstr("needs address_bits")));
  special = core();
  special.made_for = "sail";
  const MemoryImage image = lay_out(two_objects(), view(), special);
  SceneNeeds needs = image.needs();
  needs.lights = 1;
  EXPECT_FALSE(excess_of_frame(image, image.needs(), image.trees.instances));
  needs.still.nodes = 1u << 20;
  EXPECT_TRUE(excess_of_frame(image, needs, image.trees.instances));
}

}  // namespace
}  // namespace dynrt::host
