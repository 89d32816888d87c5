// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/generate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

namespace dynrt::host {

namespace {

// The point of the unit sphere between two of its points, made once for both neighbours.
class Midpoints {
 public:
  explicit Midpoints(Mesh& mesh) : mesh_(mesh) {}

  std::uint32_t operator()(std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] =
        known_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) {
      const glm::dvec3 sum = mesh_.vertices[a] + mesh_.vertices[b];
      mesh_.vertices.push_back(glm::normalize(sum));
    }
    return entry->second;
  }

 private:
  Mesh& mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known_;
};

Mesh icosahedron() {
  const double g = std::numbers::phi;
  Mesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (glm::dvec3& v : mesh.vertices) v = glm::normalize(v);
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

}  // namespace

Mesh make_sphere(double radius, int subdivisions, std::uint32_t material) {
  Mesh mesh = icosahedron();
  for (int level = 0; level < subdivisions; ++level) {
    Midpoints between(mesh);
    std::vector<glm::uvec3> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles) {
      const std::uint32_t xy = between(t.x, t.y), yz = between(t.y, t.z), zx = between(t.z, t.x);
      finer.insert(finer.end(), {{t.x, xy, zx}, {t.y, yz, xy}, {t.z, zx, yz}, {xy, yz, zx}});
    }
    mesh.triangles = std::move(finer);
  }
  for (glm::dvec3& v : mesh.vertices) v *= radius;
  mesh.material.assign(mesh.triangles.size(), material);
  return mesh;
}

Mesh make_box(const glm::dvec3& low, const glm::dvec3& high, std::uint32_t material) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner) {  // bit k set: at the high side of axis k
    mesh.vertices.emplace_back(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                               corner & 4 ? high.z : low.z);
  }
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  mesh.material.assign(mesh.triangles.size(), material);
  return mesh;
}

Mesh make_torus(double major_radius, double minor_radius, int segments, int sides,
                std::uint32_t material) {
  const auto at = [&](int segment, int side) {
    return static_cast<std::uint32_t>((segment % segments) * sides + side % sides);
  };
  Mesh mesh;
  for (int i = 0; i < segments; ++i) {
    const double around = 2.0 * std::numbers::pi * i / segments;
    for (int j = 0; j < sides; ++j) {
      const double tube = 2.0 * std::numbers::pi * j / sides;
      const double r = major_radius + minor_radius * std::cos(tube);
      mesh.vertices.emplace_back(r * std::cos(around), minor_radius * std::sin(tube),
                                 -r * std::sin(around));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  mesh.material.assign(mesh.triangles.size(), material);
  return mesh;
}

Mesh make_hills(double side, double height, int cells, std::uint32_t material) {
  const auto at = [&](int row, int column) {
    return static_cast<std::uint32_t>(row * (cells + 1) + column);
  };
  Mesh mesh;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const double u = static_cast<double>(column) / cells, v = static_cast<double>(row) / cells;
      // Wave numbers that share no period over the square.
      const double wave =
          0.6 * std::sin(9.0 * u + 1.0) * std::cos(7.0 * v) + 0.4 * std::sin(17.0 * v + 5.0 * u);
      mesh.vertices.emplace_back((u - 0.5) * side, height * wave, (v - 0.5) * side);
    }
  }
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const std::uint32_t a = at(row, column), b = at(row, column + 1), c = at(row + 1, column),
                          d = at(row + 1, column + 1);
      mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {b, c, d}});
    }
  }
  mesh.material.assign(mesh.triangles.size(), material);
  return mesh;
}

}  // namespace dynrt::host
