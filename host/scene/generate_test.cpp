// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/generate.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <numbers>
#include <utility>

namespace dynrt::host {
namespace {

// Each edge is run through once in each direction: closed, and no triangle turned over.
void expect_closed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const glm::uvec3& t : mesh.triangles) {
    ++edges[{t.x, t.y}];
    ++edges[{t.y, t.z}];
    ++edges[{t.z, t.x}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_EQ(edges.size(), 3 * mesh.triangles.size());
  EXPECT_EQ(mesh.material.size(), mesh.triangles.size());
}

// Positive when the triangles are counterclockwise seen from outside.
double volume(const Mesh& mesh) {
  double six = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    six += glm::dot(mesh.vertices[t.x], glm::cross(mesh.vertices[t.y], mesh.vertices[t.z]));
  }
  return six / 6.0;
}

TEST(Generate, Box) {
  const Mesh box = make_box({1, 2, 3}, {2, 4, 6}, 9);
  EXPECT_EQ(box.triangles.size(), 12u);
  expect_closed(box);
  EXPECT_NEAR(volume(box), 6.0, 1e-12);
  EXPECT_EQ(box.material[11], 9u);
}

TEST(Generate, Sphere) {
  for (const auto& [subdivisions, triangles] : {std::pair(0, 20u), std::pair(3, 1280u)}) {
    const Mesh sphere = make_sphere(2.0, subdivisions, 0);
    EXPECT_EQ(sphere.triangles.size(), triangles);
    EXPECT_EQ(sphere.vertices.size(), triangles / 2 + 2);
    expect_closed(sphere);
    for (const glm::dvec3& v : sphere.vertices) EXPECT_NEAR(glm::length(v), 2.0, 1e-12);
  }
  EXPECT_NEAR(volume(make_sphere(2.0, 5, 0)), 32.0 / 3.0 * std::numbers::pi, 0.05);
}

TEST(Generate, Torus) {
  const Mesh torus = make_torus(2.0, 0.5, 64, 32, 0);
  EXPECT_EQ(torus.triangles.size(), 2u * 64 * 32);
  expect_closed(torus);
  EXPECT_NEAR(volume(torus), 2.0 * std::numbers::pi * std::numbers::pi * 2.0 * 0.25, 0.1);
}

TEST(Generate, HillsAreASquareThatFacesUp) {
  const Mesh hills = make_hills(50, 2, 20, 3);
  ASSERT_EQ(hills.triangles.size(), 800u);
  ASSERT_EQ(hills.vertices.size(), 21u * 21);
  double area = 0, lowest = 9, highest = -9;
  for (const glm::uvec3& t : hills.triangles) {
    const glm::dvec3& a = hills.vertices[t.x];
    const double up = glm::cross(hills.vertices[t.y] - a, hills.vertices[t.z] - a).y / 2.0;
    EXPECT_GT(up, 0.0);
    area += up;
  }
  for (const glm::dvec3& v : hills.vertices) {
    lowest = std::min(lowest, v.y);
    highest = std::max(highest, v.y);
  }
  EXPECT_NEAR(area, 2500.0, 1e-9);
  EXPECT_TRUE(lowest >= -2 && lowest < -1 && highest <= 2 && highest > 1) << lowest << highest;
  EXPECT_EQ(hills.material, std::vector<std::uint32_t>(800, 3));
}

}  // namespace
}  // namespace dynrt::host
