// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Scenes far from the origin, as the user places them, and cameras far from the scene.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

constexpr unsigned kSide = 24;
const glm::dvec3 kAway = glm::normalize(glm::dvec3(0.5, 0.3, -0.8));

/// The sphere at `centre`, seen from three radii away.
Trial sphere_at(const MemoryFormat& numbers, const glm::dvec3& centre) {
  return {.scene = scene_of(moved(sphere(numbers, 2), centre)),
          .shots = {picture(centre + glm::dvec3(1, 0.75, 3), centre, 45, kSide, kSide)},
          .rays = Rays::kOfCamera};
}

Case far_scene(int exponent, const Allowed& allowed = {}, const std::string& why = "") {
  const double distance = std::pow(10.0, exponent);
  return Case(
      fmt::format("scene_1e{}", exponent),
      fmt::format("a sphere of radius 1 at 10^{} from the origin, seen from 3 radii", exponent),
      [=](Examiner& b) { b.check(sphere_at(b.numbers(), distance * kAway)); }, allowed, why);
}

/// The same, moved by the host: nothing is far away.
Case fitted_scene(const std::string& name, const std::string& place, const glm::dvec3& centre) {
  return Case("fitted_" + name, "the sphere at " + place + ", fitted to the numbers by the host",
              [=](Examiner& b) { b.check(fitted(sphere_at(b.numbers(), centre), b.numbers())); });
}

Case far_camera(int exponent, const Allowed& allowed = {}, const std::string& why = "") {
  const double distance = std::pow(10.0, exponent);
  return Case(
      fmt::format("camera_1e{}", exponent),
      fmt::format("a sphere of radius 1 at the origin, seen from 10^{} radii", exponent),
      [=](Examiner& b) {
        b.check({.scene = scene_of(sphere(b.numbers(), 2)),
                 .shots = {picture(distance * kAway, {0, 0, 0}, 160 / distance, kSide, kSide)},
                 .rays = Rays::kOfCamera});
      },
      allowed, why);
}

void run_far_instance(Examiner& b) {
  const glm::dvec3 centre = 1e4 * kAway;
  Trial trial = sphere_at(b.numbers(), centre);
  trial.scene = Scene{};
  add(trial.scene, sphere(b.numbers(), 2), translation(centre));
  b.check(trial);
}

}  // namespace

std::vector<Case> far_cases() {
  return {
      far_scene(2, {.distance = 3.4e-3}, reasons::kSteps),
      far_scene(3, {.invented = 2, .wrong = 10, .distance = 1.5e-2}, reasons::kSteps),
      far_scene(4, {.lost = 20, .invented = 12, .wrong = 124, .distance = 6.1e-2}, reasons::kSteps),
      far_scene(5, {.lost = 135, .invented = 54, .wrong = 130, .distance = 1.9e-2},
                reasons::kSteps),
      far_scene(6, {.lost = 233, .invented = 115, .wrong = 35}, reasons::kSteps),
      Case(
          "sphere_148376", "a sphere of radius 1 at (148376, 1234, -223423)",
          [](Examiner& b) { b.check(sphere_at(b.numbers(), {148376, 1234, -223423})); },
          {.lost = 225, .invented = 77, .wrong = 43}, reasons::kSteps),
      fitted_scene("scene_1e4", "10^4", 1e4 * kAway),
      fitted_scene("scene_1e6", "10^6", 1e6 * kAway),
      fitted_scene("sphere_148376", "(148376, 1234, -223423)", {148376, 1234, -223423}),
      Case("instance_1e4", "a sphere around its own origin, placed 10^4 radii away",
           run_far_instance),
      far_camera(2),
      far_camera(4, {.lost = 5, .invented = 24}, reasons::kFarEye),
  };
}

}  // namespace dynrt::host::stress
