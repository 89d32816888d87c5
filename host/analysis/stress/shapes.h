// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The shapes of stress cases. Where a comment says so, vertices lie on the core's numbers, so that
// only the core's own arithmetic can cause errors.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "host/analysis/stress/numbers.h"
#include "host/scene/scene.h"

namespace dynrt::host::stress {

void add_triangle(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
/// Two triangles, cut from `corner + u` to `corner + v`.
void add_quad(Mesh& mesh, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v);

/// A square of side 2 `half` across an axis, at `at` on it.
Mesh wall(int axis, double at, double half);
/// The box from -half to half, its sides inward or outward all the same.
Mesh cube(double half);
/// An icosphere of radius 1 (20 * 4^subdivisions triangles), every vertex put on the numbers.
Mesh sphere(const MemoryFormat& numbers, int subdivisions);
Mesh moved(Mesh mesh, const glm::dvec3& by);
Mesh scaled(Mesh mesh, const glm::dvec3& by);

/// A surface of 2 n x 2 n squares over directions from the origin: vertex (i, j), -n to n, lies in
/// direction (i / n, j / n, 1) at the height z(i, j), so that rays from the origin to multiples of
/// 1 / n go through vertices, those between two neighbours through edges, exactly.
Mesh lattice(int n, const std::function<double(int i, int j)>& z);

/// The scene's objects and instances moved or scaled by a power of two.
glm::dmat4 translation(const glm::dvec3& by);
glm::dmat4 scaling(const glm::dvec3& by);

}  // namespace dynrt::host::stress
