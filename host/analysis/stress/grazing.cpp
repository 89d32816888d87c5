// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Rays almost along a surface.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

/// A floor of 128 triangles, as wide as rays of this slope from a height of 1 reach.
Mesh floor_for(double slope) {
  const double part = std::exp2(std::ceil(std::log2(2 / slope))) / 4;
  Mesh floor;
  for (int i = -4; i < 4; ++i) {
    for (int j = -4; j < 4; ++j) {
      add_quad(floor, glm::dvec3(i, 0, j) * part, {part, 0, 0}, {0, 0, part});
    }
  }
  return floor;
}

void run(Examiner& b, double degrees, const glm::dmat4& turn) {
  const double slope = std::tan(degrees * std::numbers::pi / 180);
  Mesh floor = floor_for(slope);
  for (glm::dvec3& v : floor.vertices) v = glm::dvec3(turn * glm::dvec4(v, 1));
  const auto turned = [&](const glm::dvec3& v) { return glm::dmat3(turn) * v; };
  b.check({.scene = scene_of(std::move(floor)),
           .shots = {pencil(turned({0, 1, 0}), turned({-0.46875, -slope, 1}),
                            turned({0.03125, 0, 0}), turned({0, -slope / 16, 0}), 30, 16)},
           .rays = Rays::kOfCamera});
}

Case level(const std::string& name, const std::string& angle, double degrees) {
  return Case(name, "down to a level floor of 128 triangles at " + angle,
              [=](Examiner& b) { run(b, degrees, glm::dmat4(1.0)); });
}

/// The floor turned so that no component of anything is simple.
Case slanting(const std::string& name, const std::string& angle, double degrees,
              const Allowed& allowed) {
  return Case(
      "slanting_" + name, "the same down to a slanting floor, at " + angle,
      [=](Examiner& b) {
        run(b, degrees, glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, 3))));
      },
      allowed, allowed.distance > Allowed{}.distance ? reasons::kGrazing : "");
}

}  // namespace

std::vector<Case> grazing_cases() {
  return {
      level("half_degree", "half a degree", 0.5),
      level("tenth_degree", "a tenth of a degree", 0.1),
      level("hundredth_degree", "a hundredth of a degree", 0.01),
      level("thousandth_degree", "a thousandth of a degree", 0.001),
      slanting("half_degree", "half a degree", 0.5, {}),
      slanting("tenth_degree", "a tenth of a degree", 0.1, {.distance = 3.4e-3}),
      slanting("hundredth_degree", "a hundredth of a degree", 0.01, {.distance = 3.2e-2}),
  };
}

}  // namespace dynrt::host::stress
