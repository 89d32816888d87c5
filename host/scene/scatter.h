// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Scatters many instances of an object over a rectangle, the same on every machine: std::mt19937
// and std::generate_canonical are specified to the bit, the library's distributions are not.
// Lengths in metres, the rectangle lies in the plane of x and z.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "host/scene/scene.h"

namespace dynrt::host {

struct Scatter {
  std::size_t count = 0;
  std::uint32_t seed = 1;
  glm::dvec2 from{0.0}, to{0.0};  ///< x and z
  glm::dvec2 scale{1.0};          ///< lowest and highest, the same along all axes
  double apart = 0.0;             ///< no two are nearer than this
  std::vector<glm::dvec3> clear;  ///< x, z and radius of circles that stay empty
  const Mesh* ground = nullptr;   ///< stand on its highest triangle; none: on y = 0
};

/// Object to world: scaled, turned about y by any angle, moved. Returns fewer than `count` if the
/// rectangle is too small for their distance or has no ground below it.
std::vector<glm::dmat4> scatter(const Scatter& wanted);

}  // namespace dynrt::host
