// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/clip.h"

#include <algorithm>
#include <array>

namespace dynrt::host {

namespace {

/// A convex polygon: a rectangle cut by six planes has at most ten corners.
struct Polygon {
  std::array<glm::dvec3, 10> corner;
  int count = 0;
};

/// Keeps the part at or above (sign +1), at or below (sign -1) the plane (Sutherland, Hodgman).
Polygon cut(const Polygon& in, int axis, double plane, double sign) {
  Polygon out;
  for (int i = 0; i < in.count; ++i) {
    const glm::dvec3& a = in.corner[i];
    const glm::dvec3& b = in.corner[i + 1 == in.count ? 0 : i + 1];
    const double da = sign * (a[axis] - plane);
    const double db = sign * (b[axis] - plane);
    if (da >= 0) out.corner[out.count++] = a;
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      glm::dvec3 p = a + (b - a) * (da / (da - db));
      p = glm::clamp(p, glm::min(a, b), glm::max(a, b));
      p[axis] = plane;
      out.corner[out.count++] = p;
    }
  }
  return out;
}

}  // namespace

Aabb clipped_box(std::span<const glm::dvec3> corners, const Aabb& cell) {
  Polygon polygon;
  std::ranges::copy(corners, polygon.corner.begin());
  polygon.count = static_cast<int>(corners.size());
  Aabb whole;
  for (const glm::dvec3& corner : corners) whole.include(corner);
  for (int axis = 0; axis < 3; ++axis) {
    if (whole.low[axis] < cell.low[axis]) polygon = cut(polygon, axis, cell.low[axis], 1.0);
    if (whole.high[axis] > cell.high[axis]) polygon = cut(polygon, axis, cell.high[axis], -1.0);
  }
  Aabb box;
  for (int i = 0; i < polygon.count; ++i) box.include(polygon.corner[i]);
  return box;
}

}  // namespace dynrt::host
