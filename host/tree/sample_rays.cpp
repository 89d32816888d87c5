// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/sample_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "host/memory/triangle_matrix.h"

namespace dynrt::host {

namespace {

constexpr int kRaysPerPoint = 8;
/// A point whose rays are shorter than this part of the mean lies inside something.
constexpr double kClosedIn = 0.5;
/// Lines tried for each that is to meet the box; a box like a needle gets fewer.
constexpr std::size_t kTries = 20;

struct Interval {
  double from, to;
  bool is_empty() const { return !(from < to); }
};

/// Closest hits along single rays.
class Caster {
 public:
  Caster(const Mesh& object, const Tree& tree) : object_(object), tree_(tree) {}

  /// The part of the line, from `from` on, within the box.
  Interval within_box(const glm::dvec3& origin, const glm::dvec3& along, double from) const {
    Interval part{from, std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (tree_.box.low[axis] - origin[axis]) / along[axis];
      const double b = (tree_.box.high[axis] - origin[axis]) / along[axis];
      part.from = std::max(part.from, std::min(a, b));
      part.to = std::min(part.to, std::max(a, b));
    }
    return part;
  }

  /// Distance of the closest hit within the box; infinity where there is none.
  double cast(const glm::dvec3& origin, const glm::dvec3& along, const Interval& part) {
    closest_ = std::numeric_limits<double>::infinity();
    visit(tree_.root, origin, along, part.from, part.to);
    return closest_;
  }

 private:
  void visit(std::uint32_t index, const glm::dvec3& origin, const glm::dvec3& along, double near,
             double far) {
    while (index != kNullNode && near <= closest_) {
      const TreeNode& node = tree_.nodes[index];
      if (node.is_leaf()) {
        for (std::uint32_t i = 0; i < node.right; ++i) {
          intersect(tree_.items[node.left + i], origin, along);
        }
        return;
      }
      const double d = (node.split - origin[node.axis]) / along[node.axis];
      const bool left_first = origin[node.axis] <= node.split;
      const std::uint32_t first = left_first ? node.left : node.right;
      const std::uint32_t second = left_first ? node.right : node.left;
      if (d < 0 || d > far) {
        index = first;
      } else if (d < near) {
        index = second;
      } else {
        visit(first, origin, along, near, d);
        index = second;
        near = d;
      }
    }
  }

  void intersect(std::size_t primitive, const glm::dvec3& origin, const glm::dvec3& along) {
    if (object_.is_ellipsoid(primitive)) return intersect_ellipsoid(primitive, origin, along);
    const auto [x, y, c] = object_.corners(primitive);
    const glm::dvec3 a = x - c;
    const glm::dvec3 b = y - c;
    const glm::dvec3 p = glm::cross(along, b);
    const double determinant = glm::dot(a, p);
    const double u = glm::dot(origin - c, p) / determinant;
    const glm::dvec3 q = glm::cross(origin - c, a);
    const double v = glm::dot(along, q) / determinant;
    const double t = glm::dot(b, q) / determinant;
    const bool inside = object_.is_rectangle(primitive) ? u <= 1 && v <= 1 : u + v <= 1;
    if (u >= 0 && v >= 0 && inside && t > 0 && t < closest_) closest_ = t;
  }

  void intersect_ellipsoid(std::size_t primitive, const glm::dvec3& origin,
                           const glm::dvec3& along) {
    const glm::dmat4x3 m = ellipsoid_matrix(object_.ellipsoid(primitive)).matrix;
    const auto [first, second] =
        sphere_hits(m * glm::dvec4(origin, 1.0), m * glm::dvec4(along, 0.0));
    const double t = first > 0 ? first : second;
    if (t > 0 && t < closest_) closest_ = t;
  }

  const Mesh& object_;
  const Tree& tree_;
  double closest_ = 0;
};

class Sampler {
 public:
  Sampler(const Mesh& object, const Tree& tree) : caster_(object, tree), box_(tree.box) {}

  /// Rays from points within the box; returns which part of them hits the object.
  double from_inside(std::size_t count, std::vector<RaySpan>& rays) {
    struct Point {
      std::array<RaySpan, kRaysPerPoint> rays;
      double length = 0;
    };
    std::vector<Point> points(std::max<std::size_t>(count / kRaysPerPoint, 1));
    double length = 0;
    std::size_t hits = 0;
    for (Point& point : points) {
      const glm::dvec3 origin = box_.low + box_.extent() * glm::dvec3(unit(), unit(), unit());
      for (RaySpan& ray : point.rays) {
        const glm::dvec3 along = direction();
        const Interval part = caster_.within_box(origin, along, 0);
        const double hit = caster_.cast(origin, along, part);
        hits += std::isfinite(hit);
        const double t = std::min(hit, part.to);
        ray = {origin, origin + t * along};
        point.length += t;
      }
      length += point.length;
    }
    const double closed_in = kClosedIn * length / static_cast<double>(points.size());
    for (const Point& point : points) {
      if (point.length < closed_in) continue;
      rays.insert(rays.end(), point.rays.begin(), point.rays.end());
    }
    return static_cast<double>(hits) / static_cast<double>(points.size() * kRaysPerPoint);
  }

  /// Lines that meet the box, evenly distributed.
  void from_outside(std::size_t count, std::vector<RaySpan>& rays) {
    const glm::dvec3 centre = 0.5 * (box_.low + box_.high);
    const double radius = 0.5 * glm::length(box_.extent());
    for (std::size_t tries = kTries * count; count > 0 && tries > 0; --tries) {
      const glm::dvec3 along = direction();
      const glm::dvec3 aside = direction();
      const glm::dvec3 u = glm::normalize(glm::cross(along, aside));
      const glm::dvec3 origin = centre - 2 * radius * along + std::sqrt(unit()) * radius * u;
      const Interval part = caster_.within_box(origin, along, 0);
      if (part.is_empty()) continue;
      const double t = std::min(caster_.cast(origin, along, part), part.to);
      rays.push_back({origin + part.from * along, origin + t * along});
      --count;
    }
  }

 private:
  double unit() { return std::ldexp(random_(), -32); }
  glm::dvec3 direction() {
    while (true) {
      const glm::dvec3 v = 2.0 * glm::dvec3(unit(), unit(), unit()) - 1.0;
      const double length = glm::dot(v, v);
      if (length <= 1 && length > 1e-3) return v / std::sqrt(length);
    }
  }

  Caster caster_;
  const Aabb box_;
  std::mt19937 random_{1};
};

}  // namespace

std::vector<RaySpan> sample_rays(const Mesh& object, const Tree& tree, std::size_t count) {
  std::vector<RaySpan> rays;
  Sampler sampler(object, tree);
  const double enclosed = sampler.from_inside(count, rays);
  rays.resize(static_cast<std::size_t>(static_cast<double>(rays.size()) * enclosed));
  sampler.from_outside(static_cast<std::size_t>(static_cast<double>(count) * (1 - enclosed)), rays);
  return rays;
}

}  // namespace dynrt::host
