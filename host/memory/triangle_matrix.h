// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The affine maps from primitives to unit objects (thesis chapter 5): from a triangle (a, b, c), or
// the rectangle with these corners, to (1,0,0), (0,1,0), (0,0,0), from an ellipsoid to the unit
// sphere. In doubles: rounding to the core's format happens once, in the memory image.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <utility>

#include "host/scene/scene.h"

namespace dynrt::host {

/// Takes the triangle's unit normal to (0,0,1) (5.1.2). Nothing for a triangle without area, as far
/// as doubles can tell.
inline std::optional<glm::dmat4x3> triangle_matrix(const std::array<glm::dvec3, 3>& triangle) {
  const glm::dvec3& c = triangle[2];
  const glm::dvec3 to_a = triangle[0] - c;
  const glm::dvec3 to_b = triangle[1] - c;
  // Scaled, so that no product of tiny or of huge edges leaves a double's range.
  const double scale = std::max(glm::length(to_a), glm::length(to_b));
  if (!(scale > 0)) return std::nullopt;
  const glm::dvec3 a = to_a / scale;
  const glm::dvec3 b = to_b / scale;
  const glm::dvec3 cross = glm::cross(a, b);
  const double area = glm::length(cross);
  if (!(area > 0)) return std::nullopt;
  const glm::dvec3 normal = cross / area;
  // The inverse of the matrix with columns a, b, normal, whose determinant is `area`.
  const glm::dvec3 u = glm::cross(b, normal) / (area * scale);
  const glm::dvec3 v = glm::cross(normal, a) / (area * scale);
  return glm::dmat4x3(u.x, v.x, normal.x, u.y, v.y, normal.y, u.z, v.z, normal.z, -glm::dot(u, c),
                      -glm::dot(v, c), -glm::dot(normal, c));
}

/// A map with its properties.
struct UnitMatrix {
  glm::dmat4x3 matrix;
  int ones = 0;  ///< memory-efficient: which column is (1, 1, 1)
  /// Times the scalar product of direction and normal in unit space: the one in the object.
  double cosine_factor = 1;
};

/// The triangle's map in memory-efficient form (5.1.1), from that of triangle_matrix, whose third
/// row is the unit normal n: both forms agree in the triangle's plane, so their rows differ by
/// multiples of n alone, and the third by its length. The column of ones belongs to n's largest
/// component, which keeps the multiples small.
inline UnitMatrix efficient_matrix(const glm::dmat4x3& consistent) {
  UnitMatrix out{consistent};
  for (int c = 1; c < 3; ++c) {
    if (std::abs(consistent[c].z) > std::abs(consistent[out.ones].z)) out.ones = c;
  }
  const double largest = consistent[out.ones].z;
  const double u = (1 - consistent[out.ones].x) / largest;
  const double v = (1 - consistent[out.ones].y) / largest;
  for (int c = 0; c < 4; ++c) {
    const double n = consistent[c].z;
    out.matrix[c] += glm::dvec3(u * n, v * n, n / largest - n);
  }
  out.matrix[out.ones] = glm::dvec3(1);
  out.cosine_factor = largest;
  return out;
}

/// The data of the watertight test, which has no map: the corners, and the unit normal of the map
/// of triangle_matrix.
inline UnitMatrix corner_matrix(const std::array<glm::dvec3, 3>& triangle,
                                const glm::dmat4x3& consistent) {
  const glm::dvec3 normal(consistent[0].z, consistent[1].z, consistent[2].z);
  return {glm::dmat4x3(triangle[0], triangle[1], triangle[2], normal)};
}

/// The points where a ray enters and leaves the unit sphere; NaN if it misses the sphere.
inline std::pair<double, double> sphere_hits(const glm::dvec3& origin,
                                             const glm::dvec3& direction) {
  const double square = glm::dot(direction, direction);
  const double nearest = -glm::dot(origin, direction) / square;
  const glm::dvec3 p = origin + nearest * direction;
  const double half = std::sqrt((1 - glm::dot(p, p)) / square);
  return {nearest - half, nearest + half};
}

/// A sphere's factor is its radius. The normals of an ellipsoid are stretched differently at each
/// point, so no factor is right for all; it has the geometric mean of its radii.
inline UnitMatrix ellipsoid_matrix(const Ellipsoid& ellipsoid) {
  return {glm::dmat4x3(glm::inverse(ellipsoid.from_unit)), 0,
          std::cbrt(std::abs(glm::determinant(glm::dmat3(ellipsoid.from_unit))))};
}

}  // namespace dynrt::host
