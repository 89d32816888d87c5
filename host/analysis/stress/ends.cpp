// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Rays that start on a surface, inside one, or end exactly at one.
#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

constexpr unsigned kSide = 16;

/// From points of every face of a cube, along its normal and aslant.
Trial from_faces(double inward) {
  Trial trial{.scene = scene_of(cube(1.0)), .shots = {}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      for (int i = -3; i <= 3; ++i) {
        glm::dvec3 origin(0.0), direction(0.0);
        origin[axis] = side;
        origin[(axis + 1) % 3] = 0.25 * i;
        origin[(axis + 2) % 3] = 0.125 * i + 0.0625;
        direction[axis] = -side * inward;
        trial.shots.push_back(ray(origin, direction));
        direction[(axis + 1) % 3] = 0.25;
        direction[(axis + 2) % 3] = -0.0625 * i;
        trial.shots.push_back(ray(origin, direction));
      }
    }
  }
  return trial;
}

/// Six pencils, one through each face of a cube around the origin.
std::vector<Shot> all_around(const glm::dvec3& origin, unsigned side) {
  std::vector<Shot> shots;
  const double step = 2.0 / side;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double way : {-1.0, 1.0}) {
      glm::dvec3 first(step / 2 - 1), across(0.0), down(0.0);
      first[axis] = way;
      across[(axis + 1) % 3] = down[(axis + 2) % 3] = step;
      shots.push_back(pencil(origin, first, across, down, side, side));
    }
  }
  return shots;
}

/// A light in the middle of a cube without shadows: rays from the light end exactly on the surface.
void run_light_ends(Examiner& b) {
  constexpr std::uint32_t kAmbient = 255 * 8 / 10 / 4;  // the material's 0.8, a quarter of it
  Scene scene = scene_of(cube(1.0));
  scene.lights.push_back({.name = "middle", .position = {0, 0, 0}, .colour = glm::dvec3(4.0)});
  const Rendered rendered = b.render({.scene = scene,
                                      .shots = all_around({0.25, 0.125, -0.5}, kSide),
                                      .configuration = b.with_secondary_rays()});
  for (const Frame& frame : rendered.frames) {
    for (const std::uint32_t pixel : frame.pixels) {
      if ((pixel & 0xff) <= kAmbient) b.count(Fault::kLost, 1);
    }
  }
}

/// A closed room of green mirrors under a red sky: a reflection that gets out brings some red.
void run_reflection_starts(Examiner& b) {
  constexpr std::uint32_t kRed = 0xff;
  Scene scene = scene_of(cube(1.0));
  scene.materials[0] = {.name = "mirror", .diffuse = {0, 1, 0}, .mirror = 0.75};
  Trial trial{.scene = scene,
              .shots = all_around({0.25, 0.125, -0.5}, kSide),
              .configuration = b.with_secondary_rays()};
  for (Shot& shot : trial.shots) shot.options.background = kRed;
  for (const Frame& frame : b.render(trial).frames) {
    for (const std::uint32_t pixel : frame.pixels) {
      if ((pixel & kRed) != 0) b.count(Fault::kLost, 1);
    }
  }
}

}  // namespace

std::vector<Case> end_cases() {
  return {
      Case(
          "on_surface_outward", "from points of a cube's faces outward: there is nothing to hit",
          [](Examiner& b) { b.check(from_faces(-1)); }, {.invented = 12}, reasons::kNoZero),
      Case(
          "on_surface_inward", "from points of a cube's faces inward, to the other faces",
          [](Examiner& b) { b.check(from_faces(1)); }, {.wrong = 72}, reasons::kNoZero),
      Case("inside_sphere", "from a point inside a closed sphere of 320 triangles, all around",
           [](Examiner& b) {
             b.check({.scene = scene_of(sphere(b.numbers(), 2)),
                      .shots = all_around({0.25, 0.125, -0.5}, kSide)});
           }),
      Case("pointing_away", "from just outside the faces of a cube outward",
           [](Examiner& b) {
             Trial trial = from_faces(-1);
             for (Shot& shot : trial.shots) shot.camera.position *= 1.0 + 0x1p-12;
             b.check(trial);
           }),
      Case("light_at_surface",
           "light rays that end exactly at the walls of a cube; no point lies in shadow",
           run_light_ends),
      Case("reflection_from_surface",
           "up to seven reflections in a closed room of mirrors; no ray may leave it",
           run_reflection_starts),
  };
}

}  // namespace dynrt::host::stress
