// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Objects within and through each other, and leaves that hold many.
#include <cmath>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

Shot at_spheres(unsigned side) { return picture({1, 0.75, 3}, {0, 0, 0}, 45, side, side); }

Scene spheres_within(const MemoryFormat& numbers, int count, double step) {
  Scene scene = scene_of(sphere(numbers, 1));
  for (int i = 1; i < count; ++i) {
    Instance next = scene.instances[0];
    next.transform = scaling(glm::dvec3(1.0 - step * i));
    scene.instances.push_back(next);
  }
  return scene;
}

/// A cube in a sphere in a cube in a cube: the room problem. From between each two of them.
void run_rooms(Examiner& b) {
  Scene scene = scene_of(cube(0.25));
  add(scene, sphere(b.numbers(), 2));
  add(scene, cube(2));
  add(scene, cube(8));
  Trial trial{.scene = scene, .shots = {}};
  for (const double x : {0.125, 0.5, 1.5, 4.0}) {
    for (const double way : {-1.0, 1.0}) {
      trial.shots.push_back(pencil({x, 0.0625, 0.03125}, {way, -0.9375, -0.9375}, {0, 0.125, 0},
                                   {0, 0, 0.125}, 16, 16));
    }
  }
  b.check(trial);
}

/// Small spheres in a row, all in one leaf of the upper tree; the same hits as with a tree.
void run_many_in_a_leaf(Examiner& b, int count) {
  Scene scene = scene_of(scaled(sphere(b.numbers(), 1), glm::dvec3(0.125)));
  scene.instances[0].transform = translation({-1, -1, 0});
  for (int i = 1; i < count; ++i) {
    Instance next = scene.instances[0];
    next.transform = translation({-1 + 0.25 * (i % 9), -1 + 0.25 * (i / 9), 0.0625 * (i % 4)});
    scene.instances.push_back(next);
  }
  Trial trial{.scene = scene, .shots = {at_spheres(24)}};
  const Rendered split = b.check(trial);
  trial.instance_options = {.depth_factor = 0, .depth_extra = 0};
  b.expect_same(b.render(trial), split);
}

/// All 80 triangles of a sphere in one leaf.
void run_triangles_in_a_leaf(Examiner& b) {
  Trial trial{.scene = scene_of(sphere(b.numbers(), 1)), .shots = {at_spheres(24)}};
  const Rendered split = b.check(trial);
  trial.tree_options.depth_factor = trial.tree_options.depth_extra = 0;
  b.expect_same(b.render(trial), split);
}

}  // namespace

std::vector<Case> overlap_cases() {
  return {
      Case("hundred", "a hundred spheres around one centre, each 2^-10 smaller than the one before",
           [](Examiner& b) {
             b.check(
                 {.scene = spheres_within(b.numbers(), 100, 0x1p-10), .shots = {at_spheres(16)}});
           }),
      Case("hundred_coincident", "a hundred times the same sphere",
           [](Examiner& b) {
             b.check({.scene = spheres_within(b.numbers(), 100, 0), .shots = {at_spheres(16)}});
           }),
      Case("rooms", "a cube in a sphere in a cube in a cube, from between each two of them",
           run_rooms),
      Case("leaf_of_9_objects", "a leaf with more objects than the mailbox has slots",
           [](Examiner& b) { run_many_in_a_leaf(b, 9); }),
      Case("leaf_of_65_objects", "65 objects in a leaf",
           [](Examiner& b) { run_many_in_a_leaf(b, 65); }),
      Case("leaf_of_80_triangles", "80 triangles in a leaf", run_triangles_in_a_leaf),
  };
}

}  // namespace dynrt::host::stress
