// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Closed meshes about the origin, of a radius of about one, seen from which every ray must hit.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "host/scene/generate.h"

namespace dynrt::host {

/// The surface of a cube, each face a grid of cells x cells squares of two triangles; the corner in
/// the direction d lies at d times distance(d). Directions have whole coordinates, of which one is
/// +-cells / 2 and the others are within.
inline Mesh make_lattice(int cells, const std::function<double(const glm::ivec3&)>& distance) {
  Mesh mesh;
  mesh.name = "lattice";
  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto corner = [&](const glm::ivec3& d) {
    const auto [place, is_new] =
        known.try_emplace({d.x, d.y, d.z}, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(glm::dvec3(d) * distance(d));
    return place->second;
  };
  const int half = cells / 2;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-half, half}) {
      const auto at = [&](int i, int j) {
        glm::ivec3 d;
        d[axis] = side;
        d[(axis + 1) % 3] = i;
        d[(axis + 2) % 3] = j;
        return corner(d);
      };
      for (int i = -half; i < half; ++i) {
        for (int j = -half; j < half; ++j) {
          const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1),
                              d = at(i, j + 1);
          // Diagonals both ways; all triangles turn the same way seen from outside.
          std::array<glm::uvec3, 2> pair =
              (i + j) % 2 == 0 ? std::array{glm::uvec3(a, b, c), glm::uvec3(a, c, d)}
                               : std::array{glm::uvec3(a, b, d), glm::uvec3(b, c, d)};
          for (glm::uvec3& t : pair) {
            if (side < 0) std::swap(t.y, t.z);
            mesh.triangles.push_back(t);
            mesh.material.push_back(0);
          }
        }
      }
    }
  }
  return mesh;
}

/// A cube of planes: corners, edges and splitting planes lie on one another.
inline Mesh make_cube(int cells) {
  return make_lattice(cells, [cells](const glm::ivec3&) { return 2.0 / cells; });
}

/// A cube whose corners are moved towards the origin or away from it, by few bits: in directions of
/// whole coordinates lie corners and edges exactly.
inline Mesh make_crumpled(int cells) {
  return make_lattice(cells, [cells](const glm::ivec3& d) {
    std::uint32_t hash =
        static_cast<std::uint32_t>(d.x * 73856093 ^ d.y * 19349663 ^ d.z * 83492791);
    hash = (hash ^ hash >> 15) * 2654435761u;
    return (48 + (hash >> 20) % 32) / (32.0 * cells);
  });
}

}  // namespace dynrt::host
