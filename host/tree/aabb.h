// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// An axis-aligned box in doubles.
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace dynrt::host {

struct Aabb {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void include(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void include(const Aabb& b) {
    low = glm::min(low, b.low);
    high = glm::max(high, b.high);
  }
  bool is_empty() const { return !(low.x <= high.x); }
  glm::dvec3 extent() const { return high - low; }
  /// True for points inside, not for those on a face.
  bool holds(const glm::dvec3& p) const {
    return p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y &&
           p.z < high.z;
  }
};

/// Half the surface.
inline double half_area(const Aabb& box) {
  const glm::dvec3 d = box.extent();
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

}  // namespace dynrt::host
