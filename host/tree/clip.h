// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The part of a polygon that lies in a cell ("perfect splits": an item's box within a cell is that
// of the part, not of the whole triangle or rectangle).
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "host/tree/aabb.h"

namespace dynrt::host {

/// The box of the part of a triangle or rectangle, given by its corners, within a closed cell;
/// empty where they do not meet. Exact on the cell's planes, else within a rounding of a double.
Aabb clipped_box(std::span<const glm::dvec3> corners, const Aabb& cell);

}  // namespace dynrt::host
