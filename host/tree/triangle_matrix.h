// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The affine map from a triangle (a, b, c) to the unit triangle (1,0,0), (0,1,0), (0,0,0) that
// takes the triangle's unit normal to (0,0,1) (thesis 5.1.2). In doubles: rounding to the core's
// format happens once, in the memory image.
#pragma once

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <optional>

namespace dynrt::host {

/// Nothing for a triangle without area, as far as doubles can tell.
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

}  // namespace dynrt::host
