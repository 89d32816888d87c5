// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/mesh_builder.h"

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>

namespace dynrt::host {

namespace {
constexpr double kFlat = 1e-7;
}

bool has_zero_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, bc = c - b;
  const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return glm::length(glm::cross(ab, ac)) <= kFlat * longest;
}

std::size_t MeshBuilder::Hash::operator()(const glm::dvec3& v) const {
  const std::hash<double> hash;
  std::size_t h = hash(v.x);
  h = h * 0x9E3779B97F4A7C15u + hash(v.y);
  return h * 0x9E3779B97F4A7C15u + hash(v.z);
}

std::uint32_t MeshBuilder::vertex(const glm::dvec3& position) {
  const auto [entry, is_new] =
      index_of_.try_emplace(position, static_cast<std::uint32_t>(mesh_.vertices.size()));
  if (is_new) mesh_.vertices.push_back(position);
  return entry->second;
}

void MeshBuilder::add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                      std::uint32_t material) {
  if (has_zero_area(a, b, c)) {
    ++zero_area_triangles_;
    return;
  }
  const std::uint32_t i = vertex(a), j = vertex(b), k = vertex(c);
  mesh_.triangles.emplace_back(i, j, k);
  mesh_.material.push_back(material);
}

void MeshBuilder::append(const Mesh& other, const glm::dmat4& placement) {
  std::vector<std::uint32_t> placed;
  placed.reserve(other.vertices.size());
  for (const glm::dvec3& v : other.vertices) {
    placed.push_back(vertex(glm::dvec3(placement * glm::dvec4(v, 1.0))));
  }
  for (const glm::uvec3& t : other.triangles) {
    mesh_.triangles.emplace_back(placed[t.x], placed[t.y], placed[t.z]);
  }
  mesh_.material.insert(mesh_.material.end(), other.material.begin(), other.material.end());
  const glm::dmat3 linear(placement);
  for (const Rectangle& r : other.rectangles) {
    mesh_.rectangles.push_back({glm::dvec3(placement * glm::dvec4(r.corner, 1.0)),
                                linear * r.across, linear * r.along, r.material});
  }
  for (const Ellipsoid& e : other.ellipsoids) {
    mesh_.ellipsoids.push_back({placement * e.from_unit, e.material});
  }
}

}  // namespace dynrt::host
