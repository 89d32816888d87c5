// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene fitted to the core's numbers: one that does not lie about the origin is moved there,
// which leaves the most digits to its coordinates, and every one is scaled by a power of two such
// that the largest coordinate lies between 1/2 and 1, where numbers and their inverses have the
// whole range of exponents. The same is done to every object in its own space. Both are chosen once
// for all moments of an animation. A scene that is scaled by a power of two before it comes here
// has the same bits in the core.
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

/// `camera` is one that the scene is seen by besides its own. Throws UserError for a scene that
/// does not fit at any scale, naming what is too far away and what too small.
Fit fit(const Scene& scene, const Camera& camera, const MemoryFormat& format);

/// Moves the scene into its fit: objects, instances, lights, cameras and all that moves them. Light
/// is as bright there as before.
void move_into(const Fit& fit, Scene& scene);
Camera moved_into(const Space& space, const Camera& camera);
CameraOverrides moved_into(const Space& space, const CameraOverrides& flags);

}  // namespace dynrt::host
