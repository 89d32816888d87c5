// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Rays that a viewer of an object would send, to guide the builder. They start at points within its
// box that see some way, as in a room. If such rays often leave the box, lines from outside are
// added, as for an object to look at. Each ray ends where it hits the object.
#pragma once

#include <vector>

#include "host/scene/scene.h"
#include "host/tree/sweep.h"
#include "host/tree/tree.h"

namespace dynrt::host {

/// About `count` rays, the same in every run.
std::vector<RaySpan> sample_rays(const Mesh& object, const Tree& tree, std::size_t count);

}  // namespace dynrt::host
