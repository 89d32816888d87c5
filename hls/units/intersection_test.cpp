// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/intersection.h"

#include <algorithm>
#include <cmath>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<>;
struct Tolerant : C {
  static constexpr double kEpsilon = 0.25;
};
using Vec = Vector<Real>;

Vec vec(double x, double y, double z) {
  return {Real::from_double(x), Real::from_double(y), Real::from_double(z)};
}
template <class Config = C>
HitCandidate<Config> intersect(const Vec& origin, const Vec& direction) {
  test::UnitBench<Intersection<Config>> bench;
  bench.feed(bench.unit.unit_ray, UnitRay<Config>{3, 2, false, {origin, direction}});
  bench.run();
  const HitCandidate<Config> out = bench.take_one(bench.unit.candidate);
  EXPECT_EQ(out.packet, PacketId<Config>(3));
  EXPECT_EQ(out.ray, RayIndex<C>(2));
  EXPECT_FALSE(out.reset);
  return out;
}
/// Straight down from height 2, above (u, v).
template <class Config = C>
bool hits_at(double u, double v) {
  const auto out = intersect<Config>(vec(u, v, 2), vec(0, 0, -1));
  EXPECT_EQ(out.t.to_double(), 2);
  EXPECT_EQ(out.cosine.to_double(), -1);
  return out.hit;
}

TEST(Intersection, TheEdgesBelongToTheTriangle) {
  for (const auto& [u, v] : {std::pair{0.25, 0.25},
                             {0.0, 0.0},
                             {1.0, 0.0},
                             {0.0, 1.0},
                             {0.5, 0.5},
                             {0.0, 0.5},
                             {0.5, 0.0},
                             {0.75, 0.25}}) {
    EXPECT_TRUE(hits_at(u, v)) << u << ' ' << v;
  }
  constexpr double kHair = 0x1p-16;
  for (const auto& [u, v] : {std::pair{-kHair, 0.5},
                             {0.5, -kHair},
                             {1 + kHair, 0.0},
                             {0.0, 1 + kHair},
                             {0.5 + kHair, 0.5},
                             {-1.0, 2.0}}) {
    EXPECT_FALSE(hits_at(u, v)) << u << ' ' << v;
  }
}

TEST(Intersection, EpsilonWidensTheTriangle) {
  EXPECT_TRUE(hits_at<Tolerant>(-0.25, 0.5));
  EXPECT_TRUE(hits_at<Tolerant>(0.5, -0.25));
  EXPECT_TRUE(hits_at<Tolerant>(0.625, 0.625));
  EXPECT_FALSE(hits_at<Tolerant>(-0.25 - 0x1p-16, 0.5));
  EXPECT_FALSE(hits_at<Tolerant>(0.5, -0.25 - 0x1p-16));
  EXPECT_FALSE(hits_at<Tolerant>(0.625, 0.625 + 0x1p-15));
}

TEST(Intersection, NothingBehindTheRayIsHit) {
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(intersect(vec(0.25, 0.25, side), vec(0, 0, -side)).hit);
    EXPECT_FALSE(intersect(vec(0.25, 0.25, side), vec(0, 0, side)).hit);
  }
}

TEST(Intersection, ARayInTheTrianglesPlaneSaturatesAndMisses) {
  EXPECT_FALSE(intersect(vec(0.25, 0.25, 1), vec(1, 0, 0)).hit);
  const auto away = intersect(vec(0.25, 0.25, 1), {{}, {}, -Real::smallest()});
  EXPECT_EQ(away.t, Real::from_double(0x1p63)) << "a far but finite distance";
}

TEST(Intersection, ANewRayPassesWithoutATest) {
  test::UnitBench<Intersection<C>> bench;
  bench.feed(bench.unit.unit_ray, UnitRay<C>{3, 1, true, {vec(0.25, 0.25, 1), vec(0, 0, -1)}});
  bench.run();
  const auto out = bench.take_one(bench.unit.candidate);
  EXPECT_TRUE(out.reset);
  EXPECT_FALSE(out.hit);
  EXPECT_EQ(out.ray, RayIndex<C>(1));
}

TEST(Intersection, AgreesWithDoubleArithmetic) {
  test::Random random(52);
  test::UnitBench<Intersection<C>> bench;
  const auto real = [&random](double range) {
    return Real::from_double((static_cast<double>(random.next() >> 11) * 0x1p-52 - 1) * range);
  };
  unsigned hits = 0, decided = 0;
  constexpr double kUlp = 0x1p-17;  // half a unit in the last place
  for (unsigned n = 0; n < 200'000; ++n) {
    const Vec o{real(1), real(1), real(1)};
    const Vec d{real(1), real(1), real(2)};
    bench.feed(bench.unit.unit_ray, UnitRay<C>{0, 0, false, {o, d}});
    bench.run();
    const auto out = bench.take_one(bench.unit.candidate);
    const double t = -o.z.to_double() / d.z.to_double();
    const double u = t * d.x.to_double() + o.x.to_double();
    const double v = t * d.y.to_double() + o.y.to_double();
    // Two roundings on the product, one more on the sum.
    const double u_doubt = kUlp * (2.1 * std::abs(t * d.x.to_double()) + 1.1 * std::abs(u));
    const double v_doubt = kUlp * (2.1 * std::abs(t * d.y.to_double()) + 1.1 * std::abs(v));
    ASSERT_NEAR(out.t.to_double(), t, kUlp * std::abs(t));
    ASSERT_NEAR(out.u.to_double(), u, u_doubt);
    ASSERT_NEAR(out.v.to_double(), v, v_doubt);
    ASSERT_EQ(out.cosine, d.z);
    const double margin = std::min({std::abs(u), std::abs(v), std::abs(1 - u - v)});
    if (margin <= u_doubt + v_doubt + 2 * kUlp * (1 + std::abs(u) + std::abs(v))) continue;
    ++decided;
    const bool hit = t > 0 && u > 0 && v > 0 && u + v < 1;
    ASSERT_EQ(out.hit, hit) << n;
    hits += hit;
  }
  EXPECT_GT(decided, 190'000u);
  EXPECT_GT(hits, 1'000u);
}

struct Every : C {
  static constexpr Primitives kPrimitives{.triangle = true, .sphere = true, .rectangle = true};
};
HitCandidate<Every> intersect(Primitive primitive, const Vec& origin, const Vec& direction,
                              double factor = 1) {
  test::UnitBench<Intersection<Every>> bench;
  UnitRay<Every> ray{0, 0, false, {origin, direction}};
  ray.primitive = primitive;
  ray.cosine_factor = Real::from_double(factor);
  bench.feed(bench.unit.unit_ray, ray);
  bench.run();
  return bench.take_one(bench.unit.candidate);
}

TEST(Intersection, TheRectangleIsTheWholeSquare) {
  constexpr double kHair = 0x1p-16;
  for (const auto& [u, v, in_rectangle, in_triangle] : {std::tuple{0.25, 0.25, true, true},
                                                        {0.75, 0.75, true, false},
                                                        {1.0, 1.0, true, false},
                                                        {0.0, 1.0, true, true},
                                                        {1 + kHair, 0.5, false, false},
                                                        {0.5, 1 + kHair, false, false},
                                                        {-kHair, 0.5, false, false},
                                                        {0.5, -kHair, false, false}}) {
    const Vec above = vec(u, v, 2);
    const auto out = intersect(Primitive::kRectangle, above, vec(0, 0, -1), 0.5);
    EXPECT_EQ(out.hit, in_rectangle) << u << ' ' << v;
    EXPECT_EQ(out.t.to_double(), 2);
    EXPECT_EQ(out.cosine.to_double(), -0.5) << "scaled by the factor";
    EXPECT_EQ(intersect(Primitive::kTriangle, above, vec(0, 0, -1)).hit, in_triangle)
        << u << ' ' << v;
  }
}

TEST(Intersection, ASphereIsHitInFrontAndFromWithin) {
  const auto front = intersect(Primitive::kSphere, vec(0, 0, 3), vec(0, 0, -2), 0.25);
  EXPECT_TRUE(front.hit);
  EXPECT_EQ(front.t.to_double(), 1);
  EXPECT_EQ(front.cosine.to_double(), -0.5) << "against the outward normal, times the factor";
  const auto within = intersect(Primitive::kSphere, vec(0, 0, 0.5), vec(0, 0, -2));
  EXPECT_TRUE(within.hit);
  EXPECT_EQ(within.t.to_double(), 0.75);
  EXPECT_EQ(within.cosine.to_double(), 2);
  EXPECT_FALSE(intersect(Primitive::kSphere, vec(0, 0, 3), vec(0, 0, 2)).hit) << "behind the ray";
  EXPECT_FALSE(intersect(Primitive::kSphere, vec(1.001, 0, 3), vec(0, 0, -2)).hit) << "passes by";
  EXPECT_TRUE(intersect(Primitive::kSphere, vec(0.999, 0, 3), vec(0, 0, -2)).hit);
}

TEST(Intersection, SpheresAgreeWithTheQuadraticEquation) {
  test::Random random(53);
  const auto real = [&random](double range) {
    return Real::from_double((static_cast<double>(random.next() >> 11) * 0x1p-52 - 1) * range);
  };
  unsigned hits = 0, misses = 0;
  for (unsigned n = 0; n < 20'000; ++n) {
    const double far = n % 2 == 0 ? 2 : 100;
    const Vec o{real(far), real(far), real(far)};
    // Towards about the sphere.
    const Vec aim{real(1.3), real(1.3), real(1.3)};
    const Vec d{aim.x - o.x, aim.y - o.y, aim.z - o.z};
    const auto dot = [](const Vec& a, const Vec& b) {
      return a.x.to_double() * b.x.to_double() + a.y.to_double() * b.y.to_double() +
             a.z.to_double() * b.z.to_double();
    };
    const double a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1;
    const double discriminant = b * b - a * c;
    // The square of the nearest point's distance decides; the point is as exact as the origin.
    const double inside = discriminant / a;
    const double doubt = 0x1p-17 * (8 + 12 * std::sqrt(dot(o, o)));
    if (std::abs(inside) < 2 * doubt) continue;
    const auto out = intersect(Primitive::kSphere, o, d);
    const double root = std::sqrt(std::max(discriminant, 0.0));
    const double first = (-b - root) / a, second = (-b + root) / a;
    const double slack = doubt / std::sqrt(a) / std::sqrt(std::max(inside, doubt));
    if (std::abs(first) < slack || std::abs(second) < slack) continue;
    const double t = first > 0 ? first : second;
    ASSERT_EQ(out.hit, discriminant > 0 && t > 0) << n;
    out.hit ? ++hits : ++misses;
    if (!out.hit) continue;
    ASSERT_NEAR(out.t.to_double(), t, slack + 0x1p-15 * std::abs(t)) << n;
    ASSERT_NEAR(out.cosine.to_double(), first > 0 ? -root : root, a * slack + 0x1p-14 * root) << n;
  }
  EXPECT_GT(hits, 5'000u);
  EXPECT_GT(misses, 1'000u);
}

}  // namespace
}  // namespace dynrt
