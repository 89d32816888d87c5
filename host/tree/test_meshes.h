// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Small generated objects and scenes for the tests of trees and memory images.
#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <random>

#include "host/scene/scene.h"

namespace dynrt::host::testing {

inline void add_triangle(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b,
                         const glm::dvec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.material.push_back(0);
}

inline void add_quad(Mesh& mesh, const glm::dvec3& corner, const glm::dvec3& u,
                     const glm::dvec3& v) {
  add_triangle(mesh, corner, corner + u, corner + v);
  add_triangle(mesh, corner + u + v, corner + v, corner + u);
}

inline void add_box(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 d = high - low;
  const glm::dvec3 x{d.x, 0, 0}, y{0, d.y, 0}, z{0, 0, d.z};
  add_quad(mesh, low, x, y);
  add_quad(mesh, low, y, z);
  add_quad(mesh, low, z, x);
  add_quad(mesh, high, -x, -y);
  add_quad(mesh, high, -y, -z);
  add_quad(mesh, high, -z, -x);
}

inline void add_sphere(Mesh& mesh, const glm::dvec3& centre, double radius, int rows) {
  const auto point = [&](int i, int j) {
    const double a = std::numbers::pi * i / rows;
    const double b = std::numbers::pi * j / rows;
    return centre +
           radius * glm::dvec3(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
  };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < 2 * rows; ++j) {
      if (i > 0) add_triangle(mesh, point(i, j), point(i, j + 1), point(i + 1, j));
      if (i + 1 < rows) add_triangle(mesh, point(i, j + 1), point(i + 1, j + 1), point(i + 1, j));
    }
  }
}

/// Triangles of random place, size and direction within about a unit cube.
inline Mesh soup(unsigned seed, int triangles, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-1, 1), off(-size, size);
  const auto vector = [&](auto& d) { return glm::dvec3(d(random), d(random), d(random)); };
  Mesh mesh;
  mesh.name = "soup";
  for (int i = 0; i < triangles; ++i) {
    const glm::dvec3 a = vector(at);
    add_triangle(mesh, a, a + vector(off), a + vector(off));
  }
  return mesh;
}

/// A room of 4 x 3 x 5 with boxes on the floor and balls on the boxes.
inline Mesh room(unsigned seed, int things, int rows) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Mesh mesh;
  mesh.name = "room";
  add_box(mesh, {0, 0, 0}, {4, 3, 5});
  for (int i = 0; i < things; ++i) {
    const double size = 0.1 + 0.2 * unit(random);
    const double height = 0.2 + unit(random);
    const glm::dvec3 low{3.5 * unit(random), 0, 4.4 * unit(random)};
    add_box(mesh, low, low + glm::dvec3(2 * size, height, 2 * size));
    add_sphere(mesh, low + glm::dvec3(size, height + size, size), size, rows);
  }
  return mesh;
}

inline Scene scene_of(Mesh mesh) {
  Scene scene;
  scene.name = mesh.name;
  scene.materials.push_back({"grey", glm::dvec3(0.5)});
  scene.objects.push_back(std::move(mesh));
  scene.instances.push_back({"one", 0, glm::dmat4(1.0)});
  return scene;
}

/// A camera at a point, looking along a direction, 90 degrees wide and high.
inline Camera camera_at(const glm::dvec3& position, const glm::dvec3& along) {
  const glm::dvec3 forward = glm::normalize(along);
  const glm::dvec3 aside = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, aside));
  return {position, 2.0 * right, 2.0 * glm::cross(right, forward), forward};
}

}  // namespace dynrt::host::testing
