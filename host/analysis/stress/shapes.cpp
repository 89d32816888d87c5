// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include "host/scene/generate.h"

namespace dynrt::host::stress {

void add_triangle(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.material.push_back(0);
}

void add_quad(Mesh& mesh, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
  add_triangle(mesh, corner, corner + u, corner + v);
  add_triangle(mesh, corner + u + v, corner + v, corner + u);
}

Mesh wall(int axis, double at, double half) {
  glm::dvec3 corner(-half), u(0.0), v(0.0);
  corner[axis] = at;
  u[(axis + 1) % 3] = 2 * half;
  v[(axis + 2) % 3] = 2 * half;
  Mesh mesh;
  add_quad(mesh, corner, u, v);
  return mesh;
}

Mesh cube(double half) { return make_box(glm::dvec3(-half), glm::dvec3(half), 0); }

Mesh sphere(const MemoryFormat& numbers, int subdivisions) {
  Mesh mesh = make_sphere(1.0, subdivisions, 0);
  for (glm::dvec3& vertex : mesh.vertices) vertex = on_grid(numbers, vertex);
  return mesh;
}

Mesh moved(Mesh mesh, const glm::dvec3& by) {
  for (glm::dvec3& vertex : mesh.vertices) vertex += by;
  return mesh;
}

Mesh scaled(Mesh mesh, const glm::dvec3& by) {
  for (glm::dvec3& vertex : mesh.vertices) vertex *= by;
  return mesh;
}

Mesh lattice(int n, const std::function<double(int i, int j)>& z) {
  Mesh mesh;
  const int side = 2 * n + 1;
  for (int j = -n; j <= n; ++j) {
    for (int i = -n; i <= n; ++i) {
      mesh.vertices.push_back(z(i, j) * glm::dvec3(double(i) / n, double(j) / n, 1.0));
    }
  }
  for (int j = 0; j + 1 < side; ++j) {
    for (int i = 0; i + 1 < side; ++i) {
      const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * side + x); };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  mesh.material.assign(mesh.triangles.size(), 0);
  return mesh;
}

glm::dmat4 translation(const glm::dvec3& by) { return glm::translate(glm::dmat4(1.0), by); }
glm::dmat4 scaling(const glm::dvec3& by) { return glm::scale(glm::dmat4(1.0), by); }

}  // namespace dynrt::host::stress
