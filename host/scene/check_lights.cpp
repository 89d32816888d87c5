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

#include "host/error.h"
#include "host/scene/camera.h"

namespace dynrt::host {

namespace {

// No axis of a building, none near another.
constexpr std::array kDirections = {
    glm::dvec3{0.613, 0.271, 0.742},   glm::dvec3{-0.391, 0.823, 0.412},
    glm::dvec3{0.217, -0.911, 0.351},  glm::dvec3{-0.727, -0.319, 0.608},
    glm::dvec3{0.833, -0.142, -0.535}, glm::dvec3{-0.261, 0.447, -0.856},
    glm::dvec3{-0.179, -0.683, -0.708}};

using Corners = std::array<glm::dvec3, 3>;

struct Intersection {
  double distance;  // in lengths of the ray's direction
  int side;         // from which the ray comes: 1 or -1
};

// The point where the ray, or its other half, meets the triangle, or the rectangle of which the
// triangle is half.
std::optional<Intersection> intersects(const glm::dvec3& from, const glm::dvec3& along,
                                       const Corners& at, bool rectangle) {
  const glm::dvec3 u = at[0] - at[2], v = at[1] - at[2];
  const glm::dvec3 p = glm::cross(along, v);
  const double volume = glm::dot(u, p);
  if (volume == 0.0) return std::nullopt;
  const glm::dvec3 to = from - at[2];
  const double a = glm::dot(to, p) / volume;
  const glm::dvec3 q = glm::cross(to, u);
  const double b = glm::dot(along, q) / volume;
  const bool within = rectangle ? a <= 1.0 && b <= 1.0 : a + b <= 1.0;
  if (!(a >= 0.0 && b >= 0.0 && within)) return std::nullopt;
  return Intersection{glm::dot(v, q) / volume, volume > 0.0 ? 1 : -1};
}

// Of a closed mesh: from inside, every ray meets it an odd number of times, or, where closed parts
// overlap, leaves it as many times more than it enters it as every other.
bool is_inside(const Mesh& mesh, const glm::dvec3& point) {
  std::array<int, kDirections.size()> turns{};  // times left less times entered
  for (std::size_t i = 0; i < mesh.primitives(); ++i) {
    if (mesh.is_ellipsoid(i)) {
      const glm::dmat4 into = glm::inverse(mesh.ellipsoid(i).from_unit);
      if (glm::length(glm::dvec3(into * glm::dvec4(point, 1.0))) < 1.0) {
        for (int& n : turns) ++n;
      }
      continue;
    }
    const Corners corners = mesh.corners(i);
    for (std::size_t k = 0; k < turns.size(); ++k) {
      const auto intersection = intersects(point, kDirections[k], corners, mesh.is_rectangle(i));
      if (intersection && intersection->distance > 0.0) turns[k] += intersection->side;
    }
  }
  const bool odd = std::ranges::all_of(turns, [](int n) { return n % 2 != 0; });
  const bool alike = std::ranges::all_of(turns, [&](int n) { return n != 0 && n == turns[0]; });
  return odd || alike;
}

// How far it is to the ellipsoid, straight from or to its centre.
double distance_to(const glm::dmat4& from_unit, const glm::dvec3& point) {
  const double radii = glm::length(glm::dvec3(glm::inverse(from_unit) * glm::dvec4(point, 1.0)));
  const double from_centre = glm::length(point - glm::dvec3(from_unit[3]));
  return radii > 0.0 ? from_centre * std::abs(1.0 - 1.0 / radii)
                     : std::numeric_limits<double>::infinity();
}

// The first primitive that comes as close to the point as `reach`.
std::optional<std::size_t> touched(const Mesh& mesh, const glm::dmat4& transform,
                                   const glm::dvec3& point, double reach) {
  for (std::size_t i = 0; i < mesh.primitives(); ++i) {
    if (mesh.is_ellipsoid(i)) {
      if (distance_to(transform * mesh.ellipsoid(i).from_unit, point) <= reach) return i;
      continue;
    }
    Corners at = mesh.corners(i);
    for (glm::dvec3& corner : at) corner = glm::dvec3(transform * glm::dvec4(corner, 1.0));
    const glm::dvec3 normal = glm::cross(at[0] - at[2], at[1] - at[2]);
    const auto intersection = intersects(point, glm::normalize(normal), at, mesh.is_rectangle(i));
    if (intersection && std::abs(intersection->distance) <= reach) return i;
  }
  return std::nullopt;
}

void check_light(const Scene& scene, const std::vector<Box>& boxes, const PointLight& light,
                 const glm::dvec3& eye, const CoreNumbers& numbers) {
  const glm::dvec3& p = light.position;
  const glm::dvec3 told = numbers.space.outside(p);
  const double reach = numbers.last_place * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  for (const Instance& instance : scene.instances) {
    const glm::dmat4 into = glm::inverse(instance.transform);
    const glm::dvec3 point(into * glm::dvec4(p, 1.0));
    // How far the reach goes in the object, along each of its axes.
    const glm::dmat3 rows = glm::transpose(glm::dmat3(into));
    const glm::dvec3 margin =
        reach * glm::dvec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    const Box& box = boxes[instance.object];
    if (!glm::all(glm::greaterThanEqual(point, box.low - margin)) ||
        !glm::all(glm::lessThanEqual(point, box.high + margin))) {
      continue;
    }
    const Mesh& mesh = scene.objects[instance.object];
    if (const auto primitive = touched(mesh, instance.transform, p, reach)) {
      const char* kind = mesh.is_ellipsoid(*primitive)   ? "sphere"
                         : mesh.is_rectangle(*primitive) ? "rectangle"
                                                         : "triangle";
      refuse(
          "scene '{}': light '{}' at ({:g}, {:g}, {:g}) lies on {} {} of '{}': the core's numbers "
          "cannot tell the two apart; move the light away from the surface",
          scene.name, light.name, told.x, told.y, told.z, kind, *primitive, instance.name);
    }
    if (is_inside(mesh, point) && !is_inside(mesh, glm::dvec3(into * glm::dvec4(eye, 1.0)))) {
      refuse(
          "scene '{}': light '{}' at ({:g}, {:g}, {:g}) lies inside '{}', a closed object that no "
          "light leaves; move the light",
          scene.name, light.name, told.x, told.y, told.z, instance.name);
    }
  }
}

}  // namespace

void check_lights(const Scene& scene, const glm::dvec3& eye, const CoreNumbers& numbers) {
  if (!scene.distant_lights.empty()) {
    refuse(
        "scene '{}': light '{}' is infinitely far away, and dynrt has only point lights; make it a "
        "point light that is far away, or remove it",
        scene.name, scene.distant_lights[0]);
  }
  if (scene.lights.empty()) return;
  std::vector<Box> boxes;
  for (const Mesh& mesh : scene.objects) boxes.push_back(bounds(mesh));
  for (const PointLight& light : scene.lights) check_light(scene, boxes, light, eye, numbers);
}

}  // namespace dynrt::host
