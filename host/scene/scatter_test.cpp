// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/scatter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/scene/generate.h"

namespace dynrt::host {
namespace {

Scatter meadow() {
  Scatter wanted;
  wanted.count = 500;
  wanted.seed = 7;
  wanted.from = {-20, -10};
  wanted.to = {20, 30};
  wanted.scale = {0.5, 2};
  return wanted;
}

TEST(Scatter, PlacesAllWithinTheRectangle) {
  const std::vector<glm::dmat4> placed = scatter(meadow());
  ASSERT_EQ(placed.size(), 500u);
  glm::dvec3 low(99), high(-99);
  for (const glm::dmat4& m : placed) {
    low = glm::min(low, glm::dvec3(m[3]));
    high = glm::max(high, glm::dvec3(m[3]));
    const double size = glm::length(glm::dvec3(m[1]));
    EXPECT_TRUE(size >= 0.5 && size < 2);
    EXPECT_NEAR(glm::determinant(glm::dmat3(m)), size * size * size, 1e-12);
  }
  EXPECT_TRUE(low.x >= -20 && low.z >= -10 && high.x < 20 && high.z < 30);
  EXPECT_TRUE(low.x < -19 && low.z < -9 && high.x > 19 && high.z > 29);
  EXPECT_EQ(low.y, 0.0);
  EXPECT_EQ(high.y, 0.0);
}

// The first outputs of mt19937 with the seed 5489 are 3499211612 and 581869302.
TEST(Scatter, IsTheSameEverywhere) {
  Scatter one = meadow();
  one.count = 1;
  one.seed = 5489;
  one.from = {0, 0};
  one.to = {1, 1};
  const glm::dmat4 m = scatter(one).at(0);
  EXPECT_EQ(m[3].x, 3499211612.0 / 4294967296.0);
  EXPECT_EQ(m[3].z, 581869302.0 / 4294967296.0);
  EXPECT_EQ(scatter(meadow()), scatter(meadow()));
  Scatter other = meadow();
  other.seed = 8;
  EXPECT_NE(scatter(meadow()), scatter(other));
}

TEST(Scatter, KeepsApartAndOutOfClearings) {
  Scatter wanted = meadow();
  wanted.apart = 1.2;
  wanted.clear = {{5, 6, 7}, {-20, -10, 9}};
  const std::vector<glm::dmat4> placed = scatter(wanted);
  ASSERT_EQ(placed.size(), 500u);
  for (const glm::dmat4& m : placed) {
    const glm::dvec2 at(m[3].x, m[3].z);
    EXPECT_GE(glm::distance(at, {5, 6}), 7);
    EXPECT_GE(glm::distance(at, {-20, -10}), 9);
    for (const glm::dmat4& n : placed) {
      if (&m != &n) EXPECT_GE(glm::distance(at, {n[3].x, n[3].z}), 1.2);
    }
  }
}

TEST(Scatter, GivesUpWhereThereIsNoRoom) {
  Scatter wanted = meadow();
  wanted.apart = 10;
  EXPECT_LT(scatter(wanted).size(), 40u);
  wanted.clear = {{0, 0, 100}};
  EXPECT_TRUE(scatter(wanted).empty());
}

TEST(Scatter, StandsOnTheGround) {
  const Mesh hills = make_hills(100, 3, 20, 0);
  Scatter wanted = meadow();
  wanted.ground = &hills;
  double lowest = 9, highest = -9;
  for (const glm::dmat4& m : scatter(wanted)) {
    double nearest = 1e9, y = 0;
    for (const glm::dvec3& v : hills.vertices) {
      const double distance = glm::distance(glm::dvec2(v.x, v.z), glm::dvec2(m[3].x, m[3].z));
      if (distance < nearest) {
        nearest = distance;
        y = v.y;
      }
    }
    EXPECT_NEAR(m[3].y, y, 1.5);  // half a cell away, where the slope is at most 0.4
    lowest = std::min(lowest, m[3].y);
    highest = std::max(highest, m[3].y);
  }
  EXPECT_GT(highest - lowest, 2.0);
  wanted.from = {60, 60};
  wanted.to = {70, 70};
  EXPECT_TRUE(scatter(wanted).empty());
}

TEST(Scatter, StandsOnATriangleNotOnAVertex) {
  Mesh slope;
  slope.vertices = {{0, 0, 0}, {0, 0, 10}, {10, 20, 0}, {0, -5, 0}, {0, -5, 10}, {10, -5, 0}};
  slope.triangles = {{3, 4, 5}, {0, 1, 2}};  // the highest counts
  Scatter wanted = meadow();
  wanted.ground = &slope;
  wanted.from = {0, 0};
  wanted.to = {5, 5};
  const std::vector<glm::dmat4> placed = scatter(wanted);
  ASSERT_FALSE(placed.empty());
  for (const glm::dmat4& m : placed) EXPECT_NEAR(m[3].y, 2 * m[3].x, 1e-12);
}

}  // namespace
}  // namespace dynrt::host
