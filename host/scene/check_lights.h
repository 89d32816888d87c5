// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Lights that cannot light anything. For the configurations that have light rays: the others do
// without lights, wherever they are.
#pragma once

#include <glm/vec3.hpp>

#include "host/scene/scene.h"
#include "host/scene/space.h"

namespace dynrt::host {

/// How the core knows the scene: one step of its numbers, relative to them, and the space that it
/// is given in here.
struct CoreNumbers {
  double last_place = 0x1p-16;
  Space space{};
};

/// Throws UserError, naming the light, for one at infinity, one on a surface as far as the core's
/// numbers can tell, and one inside a closed object that is seen from outside, as which `eye`
/// counts unless it is inside too: a room is closed as well.
void check_lights(const Scene& scene, const glm::dvec3& eye, const CoreNumbers& numbers = {});

}  // namespace dynrt::host
