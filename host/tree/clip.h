// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The part of a triangle that lies in a cell ("perfect splits": an item's box within a cell is that
// of the part, not of the whole triangle).
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "host/tree/aabb.h"

namespace dynrt::host {

/// The box of the part of a triangle within a closed cell; empty where they do not meet. Exact on
/// the cell's planes, else within a rounding of a double.
Aabb clipped_box(const std::array<glm::dvec3, 3>& triangle, const Aabb& cell);

}  // namespace dynrt::host
