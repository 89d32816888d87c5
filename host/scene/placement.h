// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// How a scene description places an instance, at rest and at the keys of its motion.
// scenes/README.md has the keys.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "host/scene/json_reader.h"
#include "host/scene/scene.h"

namespace dynrt::host {

/// Scaled, then turned about y, then rotated about an axis, then moved. Angles in degrees.
struct Placement {
  glm::dvec3 position{0.0};
  double turn = 0.0;
  glm::dvec3 axis{0.0, 1.0, 0.0};
  double degrees = 0.0;
  glm::dvec3 scale{1.0};

  glm::dmat4 matrix() const;
};

/// "position", "turn", "rotate" and "scale" of `at`; a missing key has its value in `otherwise`.
Placement read_placement(const JsonReader& at, const Placement& otherwise = {});

/// The keys of a "motion"; the first continues from `start`. A turn may go round more than once.
/// Throws UserError if there is no key, times do not rise or a size is or passes zero.
MotionNode read_motion(const JsonReader& motion, const Placement& start);

/// The keys of a camera's "path"; the same holds of their times.
std::vector<PathKey> read_path(const JsonReader& file);

}  // namespace dynrt::host
