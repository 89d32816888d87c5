// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Scenes and distances at both ends of the numbers' range.
#include <cmath>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

/// A room with three spheres, one of them moved and turned, all lengths times `size`.
Trial room(const MemoryFormat& numbers, double size) {
  Trial trial{.scene = scene_of(scaled(cube(4), glm::dvec3(size))), .shots = {}};
  const Mesh ball = scaled(sphere(numbers, 2), glm::dvec3(size));
  add(trial.scene, ball);
  add(trial.scene, ball, translation(size * glm::dvec3(1.5, 0.5, -1)));
  add(trial.scene, ball, translation(size * glm::dvec3(-2, -0.25, -2)) * scaling(glm::dvec3(0.5)));
  trial.shots = {pencil(size * glm::dvec3(0.25, 0.5, 3.5), {-0.75, -0.75, -1}, {0.0625, 0, 0},
                        {0, 0.0625, 0}, 25, 25)};
  return trial;
}

bool is_watertight(Examiner& b) { return b.board().core().is_watertight(); }

Rendered without_u_v(Rendered rendered) {
  for (Frame& frame : rendered.frames) {
    for (HitRecord& hit : frame.hits) hit.u = hit.v = 0;
  }
  return rendered;
}

Case scaled_scene(const std::string& name, const std::string& about, int exponent) {
  return Case(name, about, [=](Examiner& b) {
    const Rendered plain = b.check(room(b.numbers(), 1));
    const Trial trial = room(b.numbers(), std::exp2(exponent));
    const Rendered moved = b.check(trial);
    b.expect_same(b.check(fitted(trial, b.numbers())),
                  b.check(fitted(room(b.numbers(), 1), b.numbers())));
    const auto shift = static_cast<std::uint32_t>(exponent) << b.numbers().mantissa_bits;
    const auto scaled = [&](HitRecord hit) {
      hit.t += shift;
      return hit;
    };
    // A watertight test's u and v have the square of the scene's size: those of a ray
    // exactly at an edge, the smallest number, are another part of it.
    if (is_watertight(b)) {
      b.expect_same(without_u_v(moved), without_u_v(plain), scaled);
    } else {
      b.expect_same(moved, plain, scaled);
    }
  });
}

/// A wall at z = `distance`, rays whose direction has this length along z.
Trial wall_at(double distance, double length) {
  return {.scene = scene_of(wall(2, distance, 2 * distance)),
          .shots = {pencil({0, 0, 0}, glm::dvec3(-0.75, -0.75, 1) * length, {0.25 * length, 0, 0},
                           {0, 0.25 * length, 0}, 7, 7)}};
}

void run_wall(Examiner& b, double distance, double length) { b.check(wall_at(distance, length)); }
void run_fitted_wall(Examiner& b, double distance, double length) {
  b.check(fitted(wall_at(distance, length), b.numbers()));
}

}  // namespace

std::vector<Case> exponent_cases() {
  return {
      scaled_scene("scene_2^-20", "a room times 2^-20 gives the same bits, with scaled distances",
                   -20),
      scaled_scene("scene_2^20", "the same times 2^20", 20),
      Case("scene_2^-40", "a room times 2^-40, compared with the truth",
           [](Examiner& b) { b.check(room(b.numbers(), 0x1p-40)); }),
      Case("scene_2^40", "a room times 2^40, compared with the truth",
           [](Examiner& b) { b.check(room(b.numbers(), 0x1p40)); }),
      Case("wall_2^45", "a wall at 2^45, 2^47 wide", [](Examiner& b) { run_wall(b, 0x1p45, 1); }),
      Case("wall_2^-44", "a wall at 2^-44, 2^-42 wide",
           [](Examiner& b) { run_wall(b, 0x1p-44, 0x1p-4); }),
      Case(
          "largest_scene", "a wall at 2^60, 2^62 wide", [](Examiner& b) { run_wall(b, 0x1p60, 1); },
          {.lost = 16}, "directions times the matrix of 2^-62 saturate at 2^-63"),
      Case(
          "smallest_scene", "a wall at 2^-60, 2^-58 wide",
          [](Examiner& b) { run_wall(b, 0x1p-60, 0x1p-20); }, {.lost = 49},
          "the format has no zero: each zero of a matrix adds 2^-63, which moves the origin behind "
          "the wall"),
      Case(
          "distance_too_large", "a wall at 2^10, rays of the length 2^-56: t is 2^66",
          [](Examiner& b) { run_wall(b, 0x1p10, 0x1p-56); }, {.lost = 49},
          "a saturated distance is no nearer than no hit: the ray hits nothing, and the sign "
          "stays"),
      Case(
          "distance_too_small", "a wall at 2^-20, rays of the length 2^50: t is 2^-70",
          [](Examiner& b) { run_wall(b, 0x1p-20, 0x1p50); }, {.lost = 49},
          "the distance saturates at 2^-63, and there the ray is far beyond the wall: no hit"),
      Case("fitted_2^60", "the wall at 2^60, fitted to the numbers by the host",
           [](Examiner& b) { run_fitted_wall(b, 0x1p60, 1); }),
      Case("fitted_2^-60", "the wall at 2^-60, fitted to the numbers by the host",
           [](Examiner& b) { run_fitted_wall(b, 0x1p-60, 0x1p-20); }),
      Case("vertex_too_far", "a wall with a vertex outside the numbers, which the host must refuse",
           [](Examiner& b) {
             b.expect_refusal(
                 {.scene = scene_of(wall(2, 1, 0x1p66)), .shots = {ray({0, 0, 0}, {0, 0, 1})}},
                 "outside the core's numbers");
           }),
      Case("triangle_too_small",
           "a triangle of 2^-70: refused if it has a matrix, which is outside the numbers; corners "
           "saturate",
           [](Examiner& b) {
             const Trial trial{.scene = scene_of(scaled(cube(1), glm::dvec3(0x1p-70))),
                               .shots = {ray({0, 0, 1}, {0, 0, -1})}};
             if (is_watertight(b)) {
               b.check(trial);  // it has corners in place of a matrix, which saturate
             } else {
               b.expect_refusal(trial, "outside the core's numbers");
             }
           }),
      Case("instance_too_small",
           "an instance of 2^-70, whose inverse is outside the numbers: refused",
           [](Examiner& b) {
             Trial trial{.scene = {}, .shots = {ray({0, 0, 4}, {0, 0, -1})}};
             add(trial.scene, cube(1), scaling(glm::dvec3(0x1p-70)));
             b.expect_refusal(trial, "outside the core's numbers");
           }),
  };
}

}  // namespace dynrt::host::stress
