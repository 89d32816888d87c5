// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Triangles in the same plane or place, and triangles that are hardly there.
#include <cmath>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

Shot at_wall() {
  return pencil({0, 0, 0}, {-0.9375, -0.9375, 1}, {0.0625, 0, 0}, {0, 0.0625, 0}, 31, 31);
}

/// The same rays in other orders: the same one of two triangles must always win.
std::vector<Shot> in_every_order(Examiner& b, Shot shot) {
  std::vector<Shot> shots = {shot};
  shot.options.packets = 1;
  shots.push_back(shot);
  shot.options.lines = b.fewest_lines();
  shots.push_back(shot);
  shot.options.packets.reset();
  shot.options.order = RayOrder::kScanline;
  shots.push_back(shot);
  return shots;
}

/// Counts the rays of all frames that do not give the bits of the first frame's.
void expect_first(Examiner& b, const Rendered& rendered) {
  for (const Frame& frame : rendered.frames) {
    for (std::size_t i = 0; i < frame.hits.size(); ++i) {
      if (frame.hits[i] != rendered.frames[0].hits[i]) b.count(Fault::kDifferent, 1);
    }
  }
}

void run_coincident_triangles(Examiner& b) {
  Mesh mesh = wall(2, 1.0, 1.0);
  const std::vector<glm::uvec3> first = mesh.triangles;
  for (int copy = 0; copy < 3; ++copy) {
    mesh.triangles.insert(mesh.triangles.end(), first.begin(), first.end());
  }
  mesh.material.assign(mesh.triangles.size(), 0);
  const Trial trial{.scene = scene_of(mesh), .shots = in_every_order(b, at_wall())};
  const Rendered rendered = b.check(trial);
  expect_first(b, rendered);
  for (const Frame& frame : rendered.frames) {
    for (const HitRecord& hit : frame.hits) {
      const auto id = rendered.primitive_of(0, hit);
      if (!id || id->primitive >= first.size()) b.count(Fault::kDifferent, 1);
    }
  }
}

void run_coplanar(Examiner& b) {
  Mesh mesh = wall(2, 1.0, 1.0);
  add_quad(mesh, {-0.7, -0.6, 1}, {1.1, 0.3, 0}, {-0.3, 1.1, 0});
  add_quad(mesh, {-0.5, -0.9, 1}, {1.3, 0.1, 0}, {0.2, 1.3, 0});
  expect_first(b, b.check({.scene = scene_of(mesh), .shots = in_every_order(b, at_wall())}));
}

void run_coincident_instances(Examiner& b) {
  Scene scene = scene_of(sphere(b.numbers(), 2));
  for (int copy = 0; copy < 3; ++copy) scene.instances.push_back(scene.instances[0]);
  const Trial trial{.scene = scene,
                    .shots = in_every_order(b, picture({1, 0.75, 3}, {0, 0, 0}, 40, 24, 24))};
  const Rendered rendered = b.check(trial);
  expect_first(b, rendered);
  for (std::size_t k = 0; k < rendered.frames.size(); ++k) {
    for (const HitRecord& hit : rendered.frames[k].hits) {
      const auto id = rendered.primitive_of(k, hit);
      if (hit.hit && (!id || id->instance != 0)) b.count(Fault::kDifferent, 1);
    }
  }
}

/// 64 triangles as high as 2^-`bits` of their length before a wall.
void run_thin(Examiner& b, int bits) {
  Mesh mesh = wall(2, 1.0, 1.0);
  for (int i = 0; i < 64; ++i) {
    const double y = (i - 32) * 0x1p-6;
    add_triangle(mesh, {-0.5, y, 0.5}, {0.5, y, 0.5}, {0, y + std::ldexp(1.0, -bits), 0.5});
  }
  b.check({.scene = scene_of(mesh), .shots = {at_wall()}});
}

void run_zero_area(Examiner& b) {
  Mesh mesh = wall(2, 1.0, 1.0);
  add_triangle(mesh, {-0.5, 0, 0.5}, {0.5, 0, 0.5}, {0, 0, 0.5});
  b.expect_refusal({.scene = scene_of(mesh), .shots = {at_wall()}}, "has no area");
}

constexpr char kThin[] =
    "the matrix holds the inverse of the triangle's height, 2^20, and a step of a coordinate is "
    "eight heights";

}  // namespace

std::vector<Case> degenerate_cases() {
  return {
      Case("coincident_triangles",
           "four times the same two triangles: those with the lowest numbers win, in every order",
           run_coincident_triangles),
      Case("coincident_instances",
           "four times the same sphere: the first instance wins, in every order",
           run_coincident_instances),
      Case("coplanar", "squares that overlap in one plane: the same square wins in every order",
           run_coplanar),
      Case(
          "nearly_zero_area", "64 triangles of a height of 2^-20 before a wall",
          [](Examiner& b) { run_thin(b, 20); }, {.wrong = 26}, kThin),
      Case("almost_no_area", "the same with a height of 2^-40",
           [](Examiner& b) { run_thin(b, 40); }),
      Case("zero_area", "a triangle whose corners lie on a line: the host must refuse it",
           run_zero_area),
  };
}

}  // namespace dynrt::host::stress
