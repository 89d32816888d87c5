// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Triangles much longer than wide, and tiny ones next to huge ones.
#include <cmath>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

constexpr int kSlivers = 32;

/// Slivers side by side: 1 long, `width` wide, two triangles each, at z = 1 around x = `middle`.
Mesh strip(double width, double middle) {
  Mesh mesh;
  for (int i = -kSlivers / 2; i < kSlivers / 2; ++i) {
    add_quad(mesh, {middle + i * width, -0.5, 1.0}, {width, 0, 0}, {0, 1, 0});
  }
  return mesh;
}

/// Rays to the strip, four across each sliver, every fourth along an edge.
Shot across_strip(double width, double middle) {
  const double step = width / 4;
  return pencil({0, 0, 0}, {middle - (2 * kSlivers - 4) * step, -0.4375, 1.0}, {step, 0, 0},
                {0, 0.125, 0}, 4 * kSlivers - 8, 8);
}

Case strip_case(const std::string& name, const std::string& about, double width, double middle) {
  return Case(name, about, [=](Examiner& b) {
    b.check({.scene = scene_of(strip(width, middle)), .shots = {across_strip(width, middle)}});
  });
}

/// Needles from one point to a far edge of `width` each.
Mesh fan(double width) {
  Mesh mesh;
  for (int i = -kSlivers / 2; i < kSlivers / 2; ++i) {
    add_triangle(mesh, {0, -0.5, 1.0}, {i * width, 0.5, 1.0}, {(i + 1) * width, 0.5, 1.0});
  }
  return mesh;
}

void run_fan(Examiner& b) {
  const double width = 0x1p-13;
  b.check({.scene = scene_of(fan(width)),
           .shots = {
               pencil({0, 0, 0}, {-4 * width, 0.0, 1.0}, {width / 4, 0, 0}, {0, 0.0625, 0}, 32, 8),
               ray({0, 0, 0}, {0, -0.5, 1.0})}});
}

/// A sphere pressed flat, seen from its centre: the triangles at its rim are slivers.
void run_disc(Examiner& b) {
  const Mesh disc = scaled(sphere(b.numbers(), 2), {1, 0x1p-10, 1});
  Trial trial{.scene = scene_of(disc), .shots = {}};
  for (const glm::dvec3& way : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1)}) {
    const glm::dvec3 side(way.z, 0, way.x);
    trial.shots.push_back(pencil({0, 0, 0}, way - side * 0.9375 - glm::dvec3(0, 0x1.ep-11, 0),
                                 side * 0.0625, {0, 0x1p-14, 0}, 31, 16));
  }
  b.check(trial);
}

}  // namespace

std::vector<Case> sliver_cases() {
  return {
      strip_case("aspect_1e2",
                 "32 slivers 1 long and 2^-7 wide, rays in them and along their edges", 0x1p-7, 0),
      strip_case("aspect_1e4", "the same, 2^-13 wide", 0x1p-13, 0),
      strip_case("aspect_1e6", "the same, 2^-20 wide", 0x1p-20, 0),
      strip_case("aspect_1e4_off_axis",
                 "the same, 2^-13 wide and 3/4 away from the axis, where the width is 16 steps of "
                 "the numbers",
                 0x1p-13, 0.75),
      Case("fan_1e4", "32 needles from one vertex to an edge of 2^-13, and a ray to the vertex",
           run_fan),
      Case("disc", "a sphere pressed to 2^-10 of its height, seen from its centre", run_disc,
           {.lost = 8}, reasons::kCracks),
  };
}

namespace {

constexpr double kTiny = 0x1p-20;

/// 16 x 16 squares of a millionth, `gap` in front of a wall that fills the scene, around `middle`
/// as it is seen from the origin.
Scene tiny_before_wall(const glm::dvec3& middle, double gap) {
  Mesh mesh = wall(2, 1.0, 1.0);
  for (int j = -8; j < 8; ++j) {
    for (int i = -8; i < 8; ++i) {
      const glm::dvec3 corner = middle + glm::dvec3(i * kTiny, j * kTiny, 1.0);
      add_quad(mesh, (1.0 - gap) * corner, {(1.0 - gap) * kTiny, 0, 0},
               {0, (1.0 - gap) * kTiny, 0});
    }
  }
  return scene_of(std::move(mesh));
}

/// Rays at them and just past them.
Shot at_tiny(const glm::dvec3& middle) {
  const double step = kTiny / 2;
  return pencil({0, 0, 0}, middle + glm::dvec3(-20 * step, -20 * step, 1.0), {step, 0, 0},
                {0, step, 0}, 40, 40);
}

}  // namespace

std::vector<Case> size_cases() {
  return {
      Case("millionth_on_axis",
           "256 squares of a millionth of the scene 2^-10 before a wall that fills it, around the "
           "axis",
           [](Examiner& b) {
             b.check(
                 {.scene = tiny_before_wall({0, 0, 0}, 0x1p-10), .shots = {at_tiny({0, 0, 0})}});
           }),
      Case(
          "millionth_off_axis",
          "the same around (1/2, 1/2), where a millionth is an eighth of a step of the numbers",
          [](Examiner& b) {
            b.check({.scene = tiny_before_wall({0.5, 0.5, 0}, 0x1p-10),
                     .shots = {at_tiny({0.5, 0.5, 0})},
                     .rays = Rays::kOfCamera});
          },
          {.wrong = 511}, reasons::kSteps),
      Case("huge_around_small", "a cube within a cube 2^20 times as large, seen from between them",
           [](Examiner& b) {
             Scene scene = scene_of(cube(1.0));
             add(scene, cube(0x1p20));
             b.check({.scene = scene,
                      .shots = {pencil({0, 0, -4}, {-0.9375, -0.9375, 1}, {0.0625, 0, 0},
                                       {0, 0.0625, 0}, 31, 31)}});
           }),
  };
}

}  // namespace dynrt::host::stress
