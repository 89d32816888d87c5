// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cameras within things, before and behind them; scenes of almost nothing.
#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

Case view(const std::string& name, const std::string& about,
          const std::function<Scene(const MemoryFormat&)>& scene, std::vector<Shot> shots,
          const Allowed& allowed = {}, const std::string& why = "") {
  return Case(
      name, about, [=](Examiner& b) { b.check({.scene = scene(b.numbers()), .shots = shots}); },
      allowed, why);
}

Scene one_triangle(const MemoryFormat&) {
  Mesh mesh;
  add_triangle(mesh, {-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.75, 0});
  return scene_of(mesh);
}

Scene ball(const MemoryFormat& numbers) { return scene_of(sphere(numbers, 2)); }

/// Sizes that no packet of 2 x 2 divides, and lines of pixels.
std::vector<Shot> odd_sizes() {
  std::vector<Shot> shots;
  for (const auto& [width, height] :
       {std::pair{1u, 1u}, {1u, 9u}, {11u, 1u}, {3u, 5u}, {2u, 7u}, {129u, 3u}}) {
    shots.push_back(picture({1, 0.75, 3}, {0, 0, 0}, 40, width, height));
  }
  return shots;
}

}  // namespace

std::vector<Case> camera_cases() {
  return {
      Case("empty_scene", "a scene without an instance, which the host must refuse",
           [](Examiner& b) {
             b.expect_refusal({.scene = {}, .shots = {ray({0, 0, 0}, {0, 0, 1})}}, "no instances");
           }),
      view("one_triangle", "a scene of one triangle", one_triangle,
           {pencil({0, 0, 1}, {-0.734375, -0.734375, -1}, {0.0625, 0, 0}, {0, 0.0625, 0}, 24, 24)}),
      view("all_behind", "a sphere behind the camera", ball,
           {picture({0, 0, 3}, {0, 0, 6}, 60, 16, 16)}),
      view("inside_solid", "from within a sphere of 320 triangles", ball,
           {picture({0.3, -0.2, 0.1}, {1, 1, 1}, 90, 24, 24)}),
      view(
          "on_vertex", "from a vertex of a cube",
          [](const MemoryFormat&) { return scene_of(cube(1)); },
          {pencil({1, 1, 1}, {-1, -1.75, -1.75}, {0, 0.125, 0}, {0, 0, 0.125}, 14, 14)},
          {.wrong = 196}, reasons::kNoZero),
      view("field_179_degrees", "from within a sphere through a field of view of 179 degrees", ball,
           {picture({0.25, 0, 0}, {1, 0, 0}, 179, 24, 24)}),
      view("field_hundredth_degree",
           "at a sphere through a field of view of a hundredth of a degree", ball,
           {picture({1, 0.75, 3}, {0.1, 0.2, 0}, 0.01, 24, 24)}),
      view("odd_sizes", "pictures of 1x1 to 129x3 pixels", ball, odd_sizes()),
  };
}

}  // namespace dynrt::host::stress
