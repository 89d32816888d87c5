// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Puts an object together triangle by triangle: vertices at exactly the same position become one
// (neighbouring triangles then share them), triangles of zero area are left out and counted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <unordered_map>

#include "host/scene/scene.h"

namespace dynrt::host {

/// Tells whether the height over the longest edge is at most 1e-7 of that edge. Three points on a
/// line, read from a file's decimals in single precision, lie about that far from the line, so the
/// normal of such a triangle would be random. Slivers with an aspect of a million stay.
bool has_zero_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

class MeshBuilder {
 public:
  explicit MeshBuilder(std::string name) { mesh_.name = std::move(name); }

  void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, std::uint32_t material);

  /// All primitives of another object, placed by an affine transform with an inverse.
  void append(const Mesh& other, const glm::dmat4& placement);

  std::size_t zero_area_triangles() const { return zero_area_triangles_; }
  Mesh take() { return std::move(mesh_); }

 private:
  struct Hash {
    std::size_t operator()(const glm::dvec3& v) const;
  };

  std::uint32_t vertex(const glm::dvec3& position);

  Mesh mesh_;
  std::unordered_map<glm::dvec3, std::uint32_t, Hash> index_of_;
  std::size_t zero_area_triangles_ = 0;
};

}  // namespace dynrt::host
