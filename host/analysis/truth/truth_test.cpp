// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace dynrt::host {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// One object, placed once.
Scene scene_of(Mesh mesh, const glm::dmat4& transform = glm::dmat4(1.0)) {
  Scene scene;
  scene.materials.emplace_back();
  mesh.material.assign(mesh.triangles.size(), 0);
  scene.objects.push_back(std::move(mesh));
  scene.instances.push_back({"one", 0, transform});
  return scene;
}

Mesh triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return {.name = "triangle", .vertices = {a, b, c}, .triangles = {{0, 1, 2}}, .material = {}};
}

/// Six triangles about a vertex, in the plane z = 0, each with a corner at the origin.
Mesh fan() {
  Mesh mesh{.name = "fan", .vertices = {{0, 0, 0}}, .triangles = {}, .material = {}};
  for (unsigned i = 0; i < 6; ++i) {
    const double angle = 1.0 + i * std::acos(-1.0) / 3;
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % 6);
  }
  return mesh;
}

TEST(TruthTest, GivesDistanceAndWeightsOfTheFirstTwoCorners) {
  const Scene scene = scene_of(triangle({0, 0, -4}, {4, 0, -4}, {0, 8, -4}));
  const Truth truth(scene);
  const auto hit = truth.nearest({{1, 2, 0}, {0, 0, -2}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 2.0);
  EXPECT_EQ(hit->u, 0.5);  // 1 - 1/4 - 2/8 of the corner at (0, 0)
  EXPECT_EQ(hit->v, 0.25);
  EXPECT_EQ(hit->cosine, -2.0);
  EXPECT_EQ(hit->place, HitPlace::kInside);
  EXPECT_EQ(hit->margin, 0.25);
  EXPECT_DOUBLE_EQ(hit->edge_distance, 1.0);
  EXPECT_THAT(hit->ties, IsEmpty());
}

TEST(TruthTest, AllTrianglesOfAVertexAreTied) {
  const Scene scene = scene_of(fan());
  const Truth truth(scene);
  const auto hit = truth.nearest({{0, 0, 3}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->id, (PrimitiveId{0, 0}));
  EXPECT_EQ(hit->place, HitPlace::kVertex);
  EXPECT_EQ(hit->margin, 0.0);
  EXPECT_THAT(hit->ties, ElementsAre(PrimitiveId{0, 1}, PrimitiveId{0, 2}, PrimitiveId{0, 3},
                                     PrimitiveId{0, 4}, PrimitiveId{0, 5}));
  EXPECT_TRUE(hit->tied_with({0, 5}));
  EXPECT_FALSE(hit->tied_with({1, 0}));
}

TEST(TruthTest, TheSmallestStepAsideLeavesTheVertex) {
  const Scene scene = scene_of(fan());
  const Truth truth(scene);
  const auto hit = truth.nearest({{5e-324, 0, 3}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->place, HitPlace::kInside);
  EXPECT_THAT(hit->ties, IsEmpty());
  EXPECT_GT(truth.counts().exact, 0u);
}

TEST(TruthTest, CoincidentTrianglesAreTiedAndTheLowestWins) {
  Scene scene = scene_of(triangle({0.1, 0.2, -1}, {1.3, 0.1, -1.1}, {0.2, 1.7, -0.7}));
  scene.instances.push_back(scene.instances.front());
  scene.instances.push_back(scene.instances.front());
  const Truth truth(scene);
  const TruthRay ray{{0.4, 0.5, 1}, {0.01, 0.02, -1}};
  const auto hit = truth.nearest(ray);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->id, (PrimitiveId{0, 0}));
  EXPECT_THAT(hit->ties, ElementsAre(PrimitiveId{1, 0}, PrimitiveId{2, 0}));

  TruthRay not_own = ray;
  not_own.own = PrimitiveId{0, 0};
  EXPECT_EQ(truth.nearest(not_own)->id, (PrimitiveId{1, 0}));
}

TEST(TruthTest, OneUlpNearerIsNearer) {
  Scene scene = scene_of(triangle({0, 0, -1}, {1, 0, -1}, {0, 1, -1}));
  glm::dmat4 nearer(1.0);
  nearer[3].z = 0x1p-53;
  scene.instances.push_back({"nearer", 0, nearer});
  const Truth truth(scene);
  const auto hit = truth.nearest({{0.25, 0.25, 0}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->id, (PrimitiveId{1, 0}));
  EXPECT_THAT(hit->ties, IsEmpty());
}

TEST(TruthTest, TheEndsOfTheIntervalDoNotBelongToIt) {
  const Scene scene = scene_of(triangle({0, 0, -3}, {1, 0, -3}, {0, 1, -3}));
  const Truth truth(scene);
  const glm::dvec3 origin(0.1, 0.1, 0);
  const glm::dvec3 direction(0, 0, -0.1);
  // 3 / 0.1, the double, is a little less than 30.
  EXPECT_TRUE(truth.any({origin, direction, 0, 30}));
  EXPECT_FALSE(truth.any({origin, direction, 30, 31}));
  EXPECT_FALSE(truth.any({{0.1, 0.1, 0}, {0, 0, -1}, 0, 3}));
  EXPECT_FALSE(truth.any({{0.1, 0.1, 0}, {0, 0, -1}, 3, 4}));
  EXPECT_FALSE(truth.any({{0.1, 0.1, -3}, {0, 0, -1}}));
  EXPECT_FALSE(truth.any({{0.1, 0.1, -4}, {0, 0, -1}}));
}

TEST(TruthTest, ARayInThePlaneDoesNotHit) {
  const Scene scene = scene_of(triangle({0, 0, -3}, {1, 0, -3}, {0, 1, -3}));
  const Truth truth(scene);
  const TruthRay ray{{-1, 0.25, -3}, {1, 0, 0}};
  EXPECT_FALSE(truth.any(ray));
  EXPECT_FALSE(truth.intersect(ray, {0, 0}));
}

TEST(TruthTest, ARectangleIsAParallelogramWithItsEdges) {
  Mesh mesh{.name = "rectangle", .vertices = {}, .triangles = {}, .material = {}};
  mesh.rectangles.push_back({{0, 0, -1}, {2, 0, 0}, {1, 4, 0}, 0});
  const Scene scene = scene_of(mesh);
  const Truth truth(scene);
  const auto at = [&](double x, double y) { return truth.nearest({{x, y, 0}, {0, 0, -1}}); };
  EXPECT_EQ(at(3, 4)->place, HitPlace::kVertex);
  EXPECT_EQ(at(2.5, 2)->place, HitPlace::kEdge);
  EXPECT_FALSE(at(std::nextafter(2.5, 3), 2));
  EXPECT_EQ(at(1.5, 2)->u, 0.5);
  EXPECT_EQ(at(1.5, 2)->margin, 0.5);
}

TEST(TruthTest, MeetTellsHowFarOutsideARayPasses) {
  const Scene scene = scene_of(triangle({0, 0, -2}, {1, 0, -2}, {0, 1, -2}));
  const Truth truth(scene);
  const auto intersection = truth.intersect({{0.25, -0.125, 0}, {0, 0, -1}}, {0, 0});
  ASSERT_TRUE(intersection);
  EXPECT_FALSE(intersection->hit);
  EXPECT_EQ(intersection->t, 2.0);
  EXPECT_DOUBLE_EQ(intersection->edge_distance, -0.125);
  EXPECT_TRUE(truth.intersect({{0.25, 0.125, 0}, {0, 0, -1}}, {0, 0})->hit);
}

TEST(TruthTest, CosineIsThatOfTheObjectsSpace) {
  glm::dmat4 twice = glm::scale(glm::dmat4(1.0), glm::dvec3(2.0));
  const Scene scene = scene_of(triangle({0, 0, -1}, {1, 0, -1}, {0, 1, -1}), twice);
  const Truth truth(scene);
  const auto hit = truth.nearest({{0.5, 0.5, 0}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 2.0);
  EXPECT_EQ(hit->cosine, -0.5);
}

TEST(TruthTest, AnEllipsoidIsHitWhereItIs) {
  Mesh mesh{.name = "sphere", .vertices = {}, .triangles = {}, .material = {}};
  const glm::dmat4 to = glm::translate(glm::dmat4(1.0), glm::dvec3(1, 2, -10));
  mesh.ellipsoids.push_back({glm::scale(to, glm::dvec3(3.0)), 0});
  const Scene scene = scene_of(mesh);
  for (const TruthSearch search : {TruthSearch::kBruteForce, TruthSearch::kTree}) {
    const Truth truth(scene, search);
    const auto outside = truth.nearest({{1, 2, 0}, {0, 0, -1}});
    ASSERT_TRUE(outside);
    EXPECT_DOUBLE_EQ(outside->t, 7);
    EXPECT_DOUBLE_EQ(outside->cosine, -1);
    const auto inside = truth.nearest({{1, 2, -10}, {0, 0, -1}});
    ASSERT_TRUE(inside);
    EXPECT_DOUBLE_EQ(inside->t, 3);
    EXPECT_DOUBLE_EQ(inside->cosine, 1);
    EXPECT_FALSE(truth.any({{1, 5.1, 0}, {0, 0, -1}}));
  }
}

/// Whole numbers, so that an independent judge has them exactly in 128 bits.
class WholeNumbersTest : public testing::Test {
 protected:
  using Wide = __int128;
  struct Point {
    std::int64_t x, y, z;
    Point operator-(const Point& b) const { return {x - b.x, y - b.y, z - b.z}; }
    explicit operator glm::dvec3() const {
      return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    }
  };
  static Wide det(const Point& a, const Point& b, const Point& c) {
    return Wide(a.x) * (Wide(b.y) * c.z - Wide(b.z) * c.y) +
           Wide(a.y) * (Wide(b.z) * c.x - Wide(b.x) * c.z) +
           Wide(a.z) * (Wide(b.x) * c.y - Wide(b.y) * c.x);
  }
  static int sign(Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
  std::int64_t number(std::int64_t size) {
    return std::uniform_int_distribution<std::int64_t>(-size, size)(random_);
  }
  Point point(std::int64_t size) { return {number(size), number(size), number(size)}; }

  std::mt19937_64 random_{20};
};

TEST_F(WholeNumbersTest, HitsAreThoseOfAnotherExactArithmetic) {
  int hits = 0;
  int edges = 0;
  for (int i = 0; i < 200000; ++i) {
    // Small ones for ties, large ones for what doubles cannot hold.
    const std::int64_t size = i % 2 == 0 ? 3 : std::int64_t{1} << 35;
    const Point origin = point(size);
    const Point direction = point(size);
    if (direction.x == 0 && direction.y == 0 && direction.z == 0) continue;
    std::array<Point, 3> corner{point(size), point(size), point(size)};
    if (i % 4 == 3) {  // an edge through the ray's line
      corner[1] = {origin.x + direction.x - (corner[0].x - origin.x),
                   origin.y + direction.y - (corner[0].y - origin.y),
                   origin.z + direction.z - (corner[0].z - origin.z)};
    }
    const Point a = corner[0] - origin;
    const Point b = corner[1] - origin;
    const Point c = corner[2] - origin;
    const int signs[] = {sign(det(direction, b, c)), sign(det(direction, c, a)),
                         sign(det(direction, a, b))};
    const int determinant = sign(det(direction, corner[0] - corner[2], corner[1] - corner[2]));
    const int t = determinant * sign(det(a, b, c));
    const bool within = std::ranges::all_of(signs, [&](int s) { return s * determinant >= 0; });
    const bool hit = determinant != 0 && within && t > 0;

    const Scene scene =
        scene_of(triangle(glm::dvec3(corner[0]), glm::dvec3(corner[1]), glm::dvec3(corner[2])));
    const Truth truth(scene);
    const auto found = truth.nearest({glm::dvec3(origin), glm::dvec3(direction)});
    ASSERT_EQ(found.has_value(), hit) << i;
    if (!hit) continue;
    ++hits;
    const auto zeros = std::ranges::count(signs, 0);
    edges += zeros > 0;
    ASSERT_EQ(found->place, zeros == 0   ? HitPlace::kInside
                            : zeros == 1 ? HitPlace::kEdge
                                         : HitPlace::kVertex)
        << i;
    const auto ratio = [&](Wide numerator) {
      return static_cast<double>(numerator) /
             static_cast<double>(det(direction, corner[0] - corner[2], corner[1] - corner[2]));
    };
    ASSERT_NEAR(found->t / ratio(det(a, b, c)), 1, 1e-12) << i;
    ASSERT_NEAR(found->u, ratio(det(direction, b, c)), 1e-12) << i;
    ASSERT_NEAR(found->v, ratio(det(direction, c, a)), 1e-12) << i;
  }
  EXPECT_GT(hits, 10000);
  EXPECT_GT(edges, 3000);
}

/// The tree loses nothing that brute force finds, wherever the scene lies and whatever the rays
/// are.
class SearchTest : public testing::TestWithParam<double> {
 protected:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  glm::dvec3 point(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
  static constexpr int kTriangles = 300;

  /// Triangles of sizes from 1 to 1e-6 in a cube of side 2, and a grid whose vertices are shared.
  Mesh soup() {
    Mesh mesh{.name = "soup", .vertices = {}, .triangles = {}, .material = {}};
    for (unsigned i = 0; i < kTriangles; ++i) {
      const glm::dvec3 centre = point(1);
      const double size = std::pow(10, between(-6, 0));
      for (int k = 0; k < 3; ++k) mesh.vertices.push_back(centre + point(size));
      mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    const auto first = static_cast<unsigned>(mesh.vertices.size());
    for (unsigned y = 0; y < 9; ++y) {
      for (unsigned x = 0; x < 9; ++x)
        mesh.vertices.emplace_back(x / 8.0 - 0.5, y / 8.0 - 0.5, 0.3);
    }
    for (unsigned y = 0; y < 8; ++y) {
      for (unsigned x = 0; x < 8; ++x) {
        const unsigned at = first + 9 * y + x;
        mesh.triangles.emplace_back(at, at + 1, at + 9);
        mesh.triangles.emplace_back(at + 1, at + 10, at + 9);
      }
    }
    return mesh;
  }

  std::mt19937_64 random_{5};
};

TEST_P(SearchTest, TreeAndBruteForceAgree) {
  const glm::dvec3 shift = GetParam() * glm::dvec3(1, -0.3, 0.7);
  Scene scene = scene_of(soup(), glm::translate(glm::dmat4(1.0), shift));
  glm::dmat4 flat = glm::translate(glm::dmat4(1.0), shift + glm::dvec3(0.1, 0.2, -0.3));
  flat = glm::rotate(flat, 0.7, glm::dvec3(1, 2, 3));
  scene.instances.push_back({"flat", 0, glm::scale(flat, glm::dvec3(1, 1e-5, 2))});
  const Truth brute(scene, TruthSearch::kBruteForce);
  const Truth tree(scene, TruthSearch::kTree);
  std::size_t hits = 0;
  std::size_t ties = 0;
  for (unsigned i = 0; i < 3000; ++i) {
    TruthRay ray;
    const PrimitiveId aim{i % 2, i % (kTriangles + 128)};
    const auto corners = brute.corners(aim);
    glm::dvec3 target = corners[i % 3];
    if (i % 5 == 1) target = 0.5 * (corners[0] + corners[1]);
    if (i % 5 == 2) target = (corners[0] + corners[1] + corners[2]) / 3.0;
    ray.origin = shift + point(i % 7 == 0 ? 1e6 : i % 7 == 1 ? 1e3 : 2);
    if (i % 3 == 0) ray.origin.x = target.x;
    if (i % 6 == 0) ray.origin.y = target.y;
    ray.direction = target - ray.origin;
    if (i % 11 == 0) ray.direction.y = 5e-324;
    if (i % 4 == 0) ray.direction *= std::pow(10, between(-6, 6));
    if (i % 8 == 7) {
      ray.from = 0.5;
      ray.to = 1.0;
    }
    const auto a = brute.nearest(ray);
    const auto b = tree.nearest(ray);
    ASSERT_EQ(a.has_value(), b.has_value()) << i;
    EXPECT_EQ(tree.any(ray), a.has_value()) << i;
    if (!a) continue;
    ++hits;
    ties += !a->ties.empty();
    ASSERT_EQ(a->id, b->id) << i;
    ASSERT_EQ(a->t, b->t) << i;
    ASSERT_EQ(a->ties, b->ties) << i;
  }
  EXPECT_GT(hits, 1000u);
  EXPECT_GT(ties, 25u);
  EXPECT_LT(tree.counts().primitives, brute.counts().primitives / 4);
}

INSTANTIATE_TEST_SUITE_P(Shifts, SearchTest, testing::Values(0.0, 1.0, 1e3, 1e6, 1e9));

}  // namespace
}  // namespace dynrt::host
