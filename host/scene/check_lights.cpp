// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/check_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <optional>

#include "host/scene/wording.h"

namespace dynrt::host {

namespace {

// A coordinate of the core has 17 significant bits.
constexpr double kLastPlace = 1.0 / (1 << 16);

// No axis of a building, none near another.
constexpr std::array kDirections = {
    glm::dvec3{0.613, 0.271, 0.742},   glm::dvec3{-0.391, 0.823, 0.412},
    glm::dvec3{0.217, -0.911, 0.351},  glm::dvec3{-0.727, -0.319, 0.608},
    glm::dvec3{0.833, -0.142, -0.535}, glm::dvec3{-0.261, 0.447, -0.856},
    glm::dvec3{-0.179, -0.683, -0.708}};

using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(const Mesh& mesh, std::size_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  return {mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]};
}

struct Meeting {
  double distance;  // in lengths of the ray's direction
  int side;         // from which the ray comes: 1 or -1
};

// Where the ray, or its other half, meets the triangle.
std::optional<Meeting> meets(const glm::dvec3& from, const glm::dvec3& along, const Corners& at) {
  const glm::dvec3 u = at[1] - at[0], v = at[2] - at[0];
  const glm::dvec3 p = glm::cross(along, v);
  const double volume = glm::dot(u, p);
  if (volume == 0.0) return std::nullopt;
  const glm::dvec3 to = from - at[0];
  const double a = glm::dot(to, p) / volume;
  const glm::dvec3 q = glm::cross(to, u);
  const double b = glm::dot(along, q) / volume;
  if (!(a >= 0.0 && b >= 0.0 && a + b <= 1.0)) return std::nullopt;
  return Meeting{glm::dot(v, q) / volume, volume > 0.0 ? 1 : -1};
}

// Of a closed mesh: from inside, every ray meets it an odd number of times, or, where closed parts
// overlap, leaves it as many times more than it enters it as every other.
bool is_inside(const Mesh& mesh, const glm::dvec3& point) {
  std::array<int, kDirections.size()> turns{};  // times left less times entered
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners corners = corners_of(mesh, i);
    for (std::size_t k = 0; k < turns.size(); ++k) {
      const auto meeting = meets(point, kDirections[k], corners);
      if (meeting && meeting->distance > 0.0) turns[k] += meeting->side;
    }
  }
  const bool odd = std::ranges::all_of(turns, [](int n) { return n % 2 != 0; });
  const bool alike = std::ranges::all_of(turns, [&](int n) { return n != 0 && n == turns[0]; });
  return odd || alike;
}

// The first triangle that comes as close to the point as `reach`, measured across it.
std::optional<std::size_t> touched(const Mesh& mesh, const glm::dmat4& transform,
                                   const glm::dvec3& point, double reach) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Corners at = corners_of(mesh, i);
    for (glm::dvec3& corner : at) corner = glm::dvec3(transform * glm::dvec4(corner, 1.0));
    const glm::dvec3 normal = glm::cross(at[1] - at[0], at[2] - at[0]);
    const auto meeting = meets(point, glm::normalize(normal), at);
    if (meeting && std::abs(meeting->distance) <= reach) return i;
  }
  return std::nullopt;
}

struct ObjectBox {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};
};

ObjectBox box_of(const Mesh& mesh) {
  ObjectBox box;
  for (const glm::dvec3& v : mesh.vertices) {
    box.low = glm::min(box.low, v);
    box.high = glm::max(box.high, v);
  }
  return box;
}

void check_light(const Scene& scene, const std::vector<ObjectBox>& boxes, const PointLight& light,
                 const glm::dvec3& eye) {
  const glm::dvec3& p = light.position;
  const double reach = kLastPlace * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  for (const Instance& instance : scene.instances) {
    const glm::dmat4 into = glm::inverse(instance.transform);
    const glm::dvec3 point(into * glm::dvec4(p, 1.0));
    // How far the reach goes in the object, along each of its axes.
    const glm::dmat3 rows = glm::transpose(glm::dmat3(into));
    const glm::dvec3 margin =
        reach * glm::dvec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    const ObjectBox& box = boxes[instance.object];
    if (!glm::all(glm::greaterThanEqual(point, box.low - margin)) ||
        !glm::all(glm::lessThanEqual(point, box.high + margin))) {
      continue;
    }
    const Mesh& mesh = scene.objects[instance.object];
    if (const auto triangle = touched(mesh, instance.transform, p, reach)) {
      wording::fail(wording::kLightOnSurface, scene.name, light.name, p.x, p.y, p.z, *triangle,
                    instance.name);
    }
    if (is_inside(mesh, point) && !is_inside(mesh, glm::dvec3(into * glm::dvec4(eye, 1.0)))) {
      wording::fail(wording::kLightInside, scene.name, light.name, p.x, p.y, p.z, instance.name);
    }
  }
}

}  // namespace

void check_lights(const Scene& scene, const glm::dvec3& eye) {
  if (!scene.distant_lights.empty()) {
    wording::fail(wording::kLightDistant, scene.name, scene.distant_lights[0]);
  }
  if (scene.lights.empty()) return;
  std::vector<ObjectBox> boxes;
  for (const Mesh& mesh : scene.objects) boxes.push_back(box_of(mesh));
  for (const PointLight& light : scene.lights) check_light(scene, boxes, light, eye);
}

}  // namespace dynrt::host
