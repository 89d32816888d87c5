// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/mesh_builder.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace dynrt::host {
namespace {

TEST(MeshBuilder, SharesVerticesAtTheSamePositionOnly) {
  MeshBuilder builder("m");
  builder.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3);
  builder.add({1, 0, 0}, {1, 1, 0}, {0, 1, 0}, 4);
  builder.add({1 + 1e-12, 0, 0}, {1, 1, 0}, {0, 0, 1}, 5);
  const Mesh mesh = builder.take();
  EXPECT_EQ(mesh.name, "m");
  EXPECT_EQ(mesh.vertices.size(), 6u);
  ASSERT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2));
  EXPECT_EQ(mesh.triangles[1], glm::uvec3(1, 3, 2));
  EXPECT_EQ(mesh.triangles[2], glm::uvec3(4, 3, 5));
  EXPECT_EQ(mesh.material, (std::vector<std::uint32_t>{3, 4, 5}));
}

TEST(MeshBuilder, LeavesOutAndCountsTrianglesOfZeroArea) {
  MeshBuilder builder("m");
  builder.add({1, 2, 3}, {1, 2, 3}, {0, 1, 0}, 0);              // two corners in one place
  builder.add({0, 0, 0}, {1, 2, 3}, {2, 4, 6}, 0);              // on a line
  builder.add({0, 0, 0}, {0.1f, 0.7f, 0}, {0.3f, 2.1f, 0}, 0);  // on a line but for rounding
  builder.add({5, 5, 5}, {5, 5, 5}, {5, 5, 5}, 0);
  EXPECT_EQ(builder.zero_area_triangles(), 4u);
  EXPECT_TRUE(builder.take().vertices.empty());
}

TEST(MeshBuilder, KeepsSliversOfAnAspectOfAMillionAtEveryScale) {
  for (const double scale : {1e-20, 1.0, 1e20}) {
    EXPECT_FALSE(has_zero_area(scale * glm::dvec3(0, 0, 0), scale * glm::dvec3(1, 0, 0),
                               scale * glm::dvec3(0.5, 1e-6, 0)));
    EXPECT_TRUE(has_zero_area(scale * glm::dvec3(0, 0, 0), scale * glm::dvec3(1, 0, 0),
                              scale * glm::dvec3(0.5, 1e-8, 0)));
  }
}

TEST(MeshBuilder, PlacesAnotherObject) {
  MeshBuilder inner("inner");
  inner.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 7);
  const Mesh mesh = inner.take();
  MeshBuilder builder("outer");
  builder.append(mesh, glm::translate(glm::dmat4(1.0), {10, 0, 0}));
  builder.append(mesh, glm::scale(glm::dmat4(1.0), {2, 2, 2}));
  const Mesh both = builder.take();
  ASSERT_EQ(both.triangles.size(), 2u);
  EXPECT_EQ(both.vertices[both.triangles[0].y], glm::dvec3(11, 0, 0));
  EXPECT_EQ(both.vertices[both.triangles[1].z], glm::dvec3(0, 2, 0));
  EXPECT_EQ(both.material, (std::vector<std::uint32_t>{7, 7}));
}

}  // namespace
}  // namespace dynrt::host
