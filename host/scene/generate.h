// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Surfaces made by formula, closed but for the hills, centred on the origin unless said otherwise,
// y up, triangles counterclockwise seen from outside.
#pragma once

#include <glm/vec3.hpp>

#include "host/scene/scene.h"

namespace dynrt::host {

/// An icosahedron whose faces are split in four `subdivisions` times: 20 * 4^subdivisions
/// triangles, all vertices on the sphere.
Mesh make_sphere(double radius, int subdivisions, std::uint32_t material);

/// 12 triangles between two corners.
Mesh make_box(const glm::dvec3& low, const glm::dvec3& high, std::uint32_t material);

/// A tube of `minor_radius` around a circle of `major_radius` in the plane y = 0: `segments` along
/// the circle, `sides` around the tube, 2 * segments * sides triangles.
Mesh make_torus(double major_radius, double minor_radius, int segments, int sides,
                std::uint32_t material);

/// A ground without an underside, `side` metres long both ways: `cells` x `cells` squares of two
/// triangles, waves of up to `height` above and below y = 0.
Mesh make_hills(double side, double height, int cells, std::uint32_t material);

}  // namespace dynrt::host
