// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Finds lights that cannot light anything. Only configurations with light rays need this check.
#pragma once

#include <glm/vec3.hpp>

#include "host/scene/scene.h"
#include "host/scene/space.h"

namespace dynrt::host {

/// The precision of the core's numbers (one step, relative to the number) and the space in which
/// this scene is given.
struct CoreNumbers {
  double last_place = 0x1p-16;
  Space space{};
};

/// Throws UserError, naming the light, for a light at infinity, a light that the core's numbers
/// cannot tell from a surface, and a light inside a closed object. The last is allowed if `eye` is
/// inside too, as in a closed room.
void check_lights(const Scene& scene, const glm::dvec3& eye, const CoreNumbers& numbers = {});

}  // namespace dynrt::host
