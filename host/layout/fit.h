// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Fits a scene to the core's numbers. A scene far from the origin is moved there, which leaves the
// most digits to its coordinates. Every scene is scaled by a power of two such that the largest
// coordinate lies between 1/2 and 1, where numbers and their inverses have the whole range of
// exponents. The same is done to every object in its own space. Both are chosen once for all
// moments of an animation. A scene that is scaled by a power of two before it comes here has the
// same bits in the core.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/format/memory_format.h"
#include "host/scene/camera.h"
#include "host/scene/scene.h"
#include "host/scene/space.h"

namespace dynrt::host {

/// Powers of two that a scene may grow or shrink by until a coordinate, or an element of a
/// triangle's matrix, leaves the core's numbers.
struct Headroom {
  int up = 0;
  int down = 0;
};

struct Fit {
  Space world;
  std::vector<Space> objects;  ///< one for each of the scene's
  Headroom headroom;
};

/// `camera` is another camera that must see the scene. Throws UserError for a scene that fits at no
/// scale, naming the part that is too far away and the part that is too small.
Fit fit(const Scene& scene, const Camera& camera, const MemoryFormat& format);

/// Moves the scene into the fitted space: objects, instances, lights, cameras and their motion.
/// Lights keep their brightness.
void move_into(const Fit& fit, Scene& scene);
Camera moved_into(const Space& space, const Camera& camera);
CameraOverrides moved_into(const Space& space, const CameraOverrides& flags);

}  // namespace dynrt::host
