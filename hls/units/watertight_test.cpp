// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The watertight test, function by function and through the units that have it.
#include "units/watertight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "units/intersection.h"
#include "units/packet_decoder.h"
#include "units/ray_shear.h"
#include "units/send_packet.h"
#include "units/test_bench.h"
#include "units/transformation.h"
#include "units/traversal_slice.h"

namespace dynrt {
namespace {

struct C : test::Config<8> {
  static constexpr TriangleTest kTriangleTest = TriangleTest::kWatertight;
};

using Vec = Vector<Real>;
using Map = RayMap<Real>;
using Mapped = MappedTriangle<Real>;

Real real(double value) { return Real::from_double(value); }
Vec vec(double x, double y, double z) { return {real(x), real(y), real(z)}; }
Vec negated(const Vec& v) { return {-v.x, -v.y, -v.z}; }

TEST(RayMap, TheLongestComponentBecomesTheThirdAxis) {
  const Map x = ray_map(Ray<Real>{vec(1, 2, 3), vec(-8, 2, 4)});
  EXPECT_EQ(x.axis, uint<2>(0));
  EXPECT_TRUE(test::same(x.origin, vec(1, 2, 3)));
  EXPECT_TRUE(test::same(x.shear, vec(0.25, 0.5, -0.125)));
  const Map y = ray_map(Ray<Real>{{}, vec(2, 4, -1)});
  EXPECT_EQ(y.axis, uint<2>(1));
  EXPECT_TRUE(test::same(y.shear, vec(0.25, -0.5, 0.25)));
  const Map z = ray_map(Ray<Real>{{}, vec(2, -4, 8)});
  EXPECT_EQ(z.axis, uint<2>(2));
  EXPECT_TRUE(test::same(z.shear, vec(-0.25, 0.5, 0.125)));
  EXPECT_EQ(ray_map(Ray<Real>{{}, vec(-4, 4, 4)}).axis, uint<2>(0)) << "of equals the first";
  EXPECT_EQ(ray_map(Ray<Real>{{}, vec(1, 4, -4)}).axis, uint<2>(1));
}

TEST(RayMap, APermutationKeepsItsTurn) {
  const Vec v = vec(1, 2, 3);
  EXPECT_TRUE(test::same(along(uint<2>(0), v), vec(2, 3, 1)));
  EXPECT_TRUE(test::same(along(uint<2>(1), v), vec(3, 1, 2)));
  EXPECT_TRUE(test::same(along(uint<2>(2), v), v));
}

int sign_of(const EdgeSide<Real>& side) {
  EXPECT_FALSE(side.left && side.right);
  return side.left ? 1 : side.right ? -1 : 0;
}

TEST(Edge, IsDecidedByTheExactProducts) {
  EXPECT_EQ(sign_of(side_of(vec(1, 0, 0), vec(0, 1, 0))), 1);
  EXPECT_EQ(sign_of(side_of(vec(0, 1, 0), vec(1, 0, 0))), -1);
  // (1 + 2^-16)(1 - 2^-16) = 1 - 2^-32, which no Real holds.
  const Vec p = vec(1 + 0x1p-16, 1, 0);
  const Vec q = vec(1, 1 - 0x1p-16, 0);
  EXPECT_EQ(sign_of(side_of(p, q)), -1);
  EXPECT_EQ(side_of(p, q).area.to_double(), 0x1p-32);
  // Products far below the smallest Real.
  const Vec s = vec(0x1p-63, 0x1.8p-63, 0);
  const Vec t = vec(0x1p-62, 0x1.4p-62, 0);
  EXPECT_EQ(sign_of(side_of(s, t)), -1);
  EXPECT_EQ(side_of(s, t).area.to_double(), 0x1p-127);
}

TEST(Edge, ThroughTheAxisIsMovedAside) {
  EXPECT_EQ(sign_of(side_of(vec(1, -2, 0), vec(-1, 2, 0))), 1);
  EXPECT_EQ(sign_of(side_of(vec(-1, 2, 0), vec(1, -2, 0))), -1);
  EXPECT_EQ(sign_of(side_of(vec(2, 4, 0), vec(1, 2, 0))), -1);
  EXPECT_EQ(sign_of(side_of(vec(1, 2, 0), vec(1, 2, 7))), 0) << "one point";
}

TEST(Edge, TheOtherWayRoundHasTheOtherSideAndTheSameArea) {
  test::Random random(17);
  for (unsigned n = 0; n < 200'000; ++n) {
    Vec p = test::random_token<Vec>(random);
    Vec q = test::random_token<Vec>(random);
    if (test::chance(random, 30)) q.x = p.x;
    if (test::chance(random, 30)) q.y = p.y;
    if (test::chance(random, 10)) q = negated(p);
    const EdgeSide<Real> there = side_of(p, q);
    const EdgeSide<Real> back = side_of(q, p);
    ASSERT_EQ(sign_of(there), -sign_of(back));
    ASSERT_EQ(there.area, back.area);
    ASSERT_EQ(sign_of(there) == 0, p.x == q.x && p.y == q.y);
  }
}

TEST(Intersect, ReportsThePartsOfTheFirstTwoCorners) {
  const Mapped m{vec(3, -1, 8), vec(-1, 3, 16), vec(-1, -1, 4), real(0.5)};
  const TriangleHit<Real> hit = intersect(m);
  EXPECT_TRUE(hit.hit());
  EXPECT_TRUE(hit.left);
  EXPECT_EQ(hit.u.to_double(), 0.25);
  EXPECT_EQ(hit.v.to_double(), 0.25);
  EXPECT_EQ(hit.t.to_double(), 0.25 * 8 + 0.25 * 16 + 0.5 * 4);
  const TriangleHit<Real> turned = intersect(Mapped{m.b, m.a, m.c, m.cosine});
  EXPECT_TRUE(turned.hit());
  EXPECT_TRUE(turned.right);
  EXPECT_EQ(turned.t, hit.t);
  EXPECT_EQ(turned.u, hit.v);
  const Vec behind = vec(3, -1, -32);
  EXPECT_FALSE(intersect(Mapped{behind, m.b, m.c, m.cosine}).hit()) << "behind the ray's origin";
  EXPECT_FALSE(intersect(Mapped{vec(-2, 0, 8), m.b, m.c, m.cosine}).hit()) << "beside it";
  EXPECT_FALSE(intersect(Mapped{m.a, m.b, m.a, m.cosine}).hit()) << "an edge alone";
}

/// A fan of triangles round a point at the axis, closed: exactly one of them is hit, wherever
/// between the numbers the point may lie.
TEST(Intersect, OneTriangleOfAFanIsHit) {
  test::Random random(71);
  constexpr unsigned kAround = 7;
  for (unsigned n = 0; n < 100'000; ++n) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(80)) - 40);
    const auto part = [&] { return (static_cast<double>(random.below(2049)) - 1024) / 1024; };
    std::array<Vec, kAround> rim;
    for (unsigned i = 0; i < kAround; ++i) {
      const double angle = (i + 0.3 * part()) * 2 * 3.14159265358979 / kAround;
      rim[i] = vec(scale * std::cos(angle), scale * std::sin(angle), 1);
    }
    Vec middle = vec(0, 0, 1);
    if (test::chance(random, 50))
      middle = vec(0x1p-30 * scale * part(), 0x1p-34 * scale * part(), 1);
    if (test::chance(random, 20)) middle.x = real(0.1 * scale * part());
    unsigned hits = 0;
    for (unsigned i = 0; i < kAround; ++i) {
      hits += intersect(Mapped{middle, rim[i], rim[(i + 1) % kAround], {}}).hit();
    }
    ASSERT_EQ(hits, 1u);
  }
}

/// A packet's way from its rays in an object to the tests of a triangle, unit by unit.
struct Chain {
  test::UnitBench<RayShear<C>> shear;
  test::UnitBench<SendPacket<C>> send;
  test::UnitBench<Transformation<C>> transformation;
  test::UnitBench<PacketDecoder<C>> decoder;
  test::UnitBench<Intersection<C>> intersection;

  std::vector<HitCandidate<C>> run(const std::array<Ray<Real>, kRays<C>>& rays,
                                   const std::array<Vec, 4>& columns) {
    constexpr unsigned kPacket = 5;
    for (unsigned r = 0; r < kRays<C>; ++r) {
      ObjectRay<C> ray;
      ray.packet = kPacket;
      ray.ray = RayIndex<C>::from(r);
      ray.active = 15;
      ray.root = 99;
      ray.in_object = rays[r];
      shear.feed(shear.unit.ray, ray);
      send.rows(send.unit.vectors)[(8 + kPacket) * 8 + 2 * r + 1] = rays[r].direction;
    }
    shear.run();
    EXPECT_EQ(shear.take_one(shear.unit.enter_object).next, Address(99));
    std::ranges::copy(shear.rows(shear.unit.map),
                      transformation.rows(transformation.unit.map).begin());
    for (unsigned c = 0; c < 4; ++c) {
      transformation.rows(transformation.unit.column[c])[kPacket] = columns[c];
    }
    const SendJob<C> job{11, kPacket, TransformKind::kTriangle};
    for (unsigned i = 0; i < 12; ++i) {
      send.feed(send.unit.job, Repeated<SendJob<C>>{RepeatCount<C>::from(i), i == 11, job});
    }
    send.run();
    for (const auto& v : send.take(send.unit.vector)) {
      transformation.feed(transformation.unit.vector, v);
    }
    transformation.run();
    decoder.rows(decoder.unit.record)[kPacket].kind = TransformKind::kTriangle;
    for (const auto& v : transformation.take(transformation.unit.transformed)) {
      decoder.feed(decoder.unit.vector, v);
    }
    decoder.run();
    for (const auto& u : decoder.take(decoder.unit.unit_ray)) {
      EXPECT_FALSE(u.reset);
      intersection.feed(intersection.unit.unit_ray, u);
    }
    intersection.run();
    return intersection.take(intersection.unit.candidate);
  }
};

/// Against the same numbers in doubles (Moeller, Trumbore).
TEST(Chain, FindsWhatTheFormulaFinds) {
  test::Random random(5);
  const auto unit = [&random] { return static_cast<double>(random.below(1u << 20)) * 0x1p-19 - 1; };
  Chain chain;
  unsigned hits = 0;
  for (unsigned n = 0; n < 20'000; ++n) {
    std::array<Ray<Real>, kRays<C>> rays;
    for (auto& ray : rays) ray = {vec(unit(), unit(), unit()), vec(unit(), unit(), unit())};
    std::array<Vec, 4> columns;
    for (Vec& column : columns) column = vec(unit(), unit(), unit());
    const auto found = chain.run(rays, columns);
    ASSERT_EQ(found.size(), kRays<C>);
    for (unsigned r = 0; r < kRays<C>; ++r) {
      using V = std::array<double, 3>;
      const auto of = [](const Vec& v) {
        return V{v.x.to_double(), v.y.to_double(), v.z.to_double()};
      };
      const auto minus = [](const V& a, const V& b) {
        return V{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
      };
      const auto dot = [](const V& a, const V& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      };
      const auto cross = [](const V& a, const V& b) {
        return V{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
      };
      const V o = of(rays[r].origin), d = of(rays[r].direction), c = of(columns[2]);
      const V a = minus(of(columns[0]), c), b = minus(of(columns[1]), c), s = minus(o, c);
      const V p = cross(d, b), q = cross(s, a);
      const double det = dot(a, p);
      if (std::abs(det) < 0.05) continue;
      const double u = dot(s, p) / det, v = dot(d, q) / det, t = dot(b, q) / det;
      const double inside = std::min({u, v, 1 - u - v, t});
      if (std::abs(inside) < 0.01) continue;
      ASSERT_EQ(found[r].ray, RayIndex<C>::from(r));
      ASSERT_EQ(found[r].hit, inside > 0) << n;
      ASSERT_NEAR(found[r].cosine.to_double(), dot(d, of(columns[3])), 1e-4);
      if (inside < 0) continue;
      ++hits;
      ASSERT_NEAR(found[r].u.to_double(), u, 3e-3);
      ASSERT_NEAR(found[r].v.to_double(), v, 3e-3);
      ASSERT_NEAR(found[r].t.to_double(), t, 3e-3 * std::max(1.0, t));
    }
  }
  EXPECT_GT(hits, 1000u);
}

/// A slice whose ray goes along x from its origin: a plane's distance is where it splits.
class WidenedSlice : public testing::Test {
 protected:
  static constexpr std::uint64_t kRow = 3;
  WidenedSlice() {
    ray({{}, {Real::one(), Real::one(), Real::one()}});
    bench_.rows(bench_.unit.hit_distance)[kRow] = Real::largest();
  }
  void ray(const Ray<Real>& ray) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const auto row = axis_row<C>(LevelRow<C>(kRow), uint<2>::from(axis));
      bench_.rows(bench_.unit.ray)[row.to_u64()] = by_axis(ray)[axis];
    }
  }
  SliceDecision decide(IntervalUpdate update, Real split, bool both = true) {
    Step<C> s;
    s.context.packet = kRow;
    s.context.update = update;
    s.context.both = RayMask<C>::from(both ? 15u : 0u);
    s.context.active = 15;
    s.node.kind = NodeKind::kSplitX;
    s.node.split = split;
    bench_.feed(bench_.unit.step_in, s);
    bench_.run();
    return bench_.take_one(bench_.unit.decision);
  }
  auto interval() { return bench_.unit.interval.read(level_row<C>(Level(0), PacketId<C>(kRow))); }
  test::UnitBench<TraversalSlice<C>> bench_;
};

constexpr unsigned kK = 2;
static_assert(kWidening<C> == kK);

TEST_F(WidenedSlice, TheNearChildEndsBehindThePlaneAndTheFarOneBeginsBeforeIt) {
  decide(IntervalUpdate::kInit, real(10), false);
  decide(IntervalUpdate::kClipFarPush, real(4));
  EXPECT_EQ(interval().far, real(10).moved_up<2 * kK>());
  EXPECT_EQ(interval().near, Real::smallest());
  decide(IntervalUpdate::kPop, real(20));
  EXPECT_EQ(interval().near, real(10).moved_down<2 * kK>());
  EXPECT_EQ(interval().far, Real::largest());
  decide(IntervalUpdate::kClipNear, real(30));
  EXPECT_EQ(interval().near, real(20).moved_down<2 * kK>());
}

TEST_F(WidenedSlice, APlaneWithinTheWidenedIntervalDividesIt) {
  decide(IntervalUpdate::kInit, real(10), false);
  decide(IntervalUpdate::kClipFar, real(1));
  const Real far = real(10).moved_up<2 * kK>();
  EXPECT_TRUE(decide(IntervalUpdate::kClipFar, far, false).go_right);
  EXPECT_FALSE(decide(IntervalUpdate::kClipFar, far.moved_up<1>(), false).go_right);
  decide(IntervalUpdate::kClipFar, real(1), false);
  decide(IntervalUpdate::kClipNear, real(1));
  const Real near = real(1).moved_down<2 * kK>();
  EXPECT_TRUE(decide(IntervalUpdate::kClipFar, near, false).go_left);
  EXPECT_FALSE(decide(IntervalUpdate::kClipFar, near.moved_down<1>(), false).go_left);
}

TEST_F(WidenedSlice, ARayEndsWhereItsHitLiesBeforeTheWidenedInterval) {
  decide(IntervalUpdate::kInit, real(10), false);
  bench_.rows(bench_.unit.hit_distance)[kRow] = real(10).moved_down<2 * kK>();
  EXPECT_FALSE(decide(IntervalUpdate::kClipNear, real(20)).terminated);
  bench_.rows(bench_.unit.hit_distance)[kRow] = Real::largest();
  decide(IntervalUpdate::kInit, real(10), false);
  bench_.rows(bench_.unit.hit_distance)[kRow] = real(10).moved_down<2 * kK + 1>();
  EXPECT_TRUE(decide(IntervalUpdate::kClipNear, real(20)).terminated);
}

/// The offset 0 is no number; divided by a tiny direction its stand-in would be far away.
TEST_F(WidenedSlice, ARayFromWithinAPlaneIsOnBothSidesAtOnce) {
  ray({vec(1.5, 0, 0), vec(0x1p-63, 1, 0)});
  bench_.rows(bench_.unit.hit_distance)[kRow] = real(0.5);
  const SliceDecision ahead = decide(IntervalUpdate::kInit, real(1.5), false);
  EXPECT_TRUE(ahead.go_left);
  EXPECT_TRUE(ahead.go_right);
  ray({vec(1.5, 0, 0), vec(-0x1p-63, 1, 0)});
  const SliceDecision back = decide(IntervalUpdate::kInit, real(1.5), false);
  EXPECT_TRUE(back.go_left);
  EXPECT_FALSE(back.go_right);
}

}  // namespace
}  // namespace dynrt
