// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Rays as a viewer of an object would send them, wherever the viewer is: from points within its
// box that see some way, as in a room, and, as far as such rays leave the box again, lines from
// outside, as for a thing to look at. Each ends where it hits the object. They guide the builder.
#pragma once

#include <vector>

#include "host/scene/scene.h"
#include "host/tree/sweep.h"
#include "host/tree/tree.h"

namespace dynrt::host {

/// About `count` rays, the same ones every time.
std::vector<RaySpan> sample_rays(const Mesh& object, const Tree& tree, std::size_t count);

}  // namespace dynrt::host
