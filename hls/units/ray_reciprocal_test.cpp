// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/ray_reciprocal.h"

#include <cmath>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Fast<test::Config<8>>;
using Vec = Vector<Real>;
constexpr int kBias = Real::kBias;

Real real(double value) { return Real::from_double(value); }

class RayReciprocals : public testing::Test {
 protected:
  /// As the join's repeater sends it.
  void send(bool is_new, unsigned ray, const Vec& direction) {
    Repeated<TracedRay<C>> traced;
    traced.job.is_new = is_new;
    traced.job.ray.packet = 5;
    traced.job.ray.ray = RayIndex<C>::from(ray);
    traced.job.ray.active = RayMask<C>(0b1011);
    traced.job.ray.root = 1234;
    traced.job.ray.in_object = {kOrigin, direction};
    traced.job.ray.last = ray == kRays<C> - 1;
    for (unsigned axis = 0; axis <= traced.job.repeat.to_u64(); ++axis) {
      traced.index = RepeatCount<C>::from(axis);
      traced.last = axis == traced.job.repeat.to_u64();
      bench_.feed(bench_.unit.traced, traced);
    }
    bench_.run();
  }
  Ray<Real> saved(unsigned level, unsigned ray) {
    const auto row = level_row<C>(Level::from(level), PacketId<C>(5));
    const RayByAxis<Real>& r = bench_.rows(bench_.unit.ray[ray])[row.to_u64()];
    return {{r[0].origin, r[1].origin, r[2].origin},
            {r[0].direction, r[1].direction, r[2].direction}};
  }
  const Vec kOrigin{real(1), real(2), real(3)};
  test::UnitBench<RayReciprocal<C>> bench_;
};

TEST_F(RayReciprocals, ANewRayIsSavedForTheTopLevelBeforeItsReset) {
  send(true, 2, {real(0.5), real(-3), real(1024)});
  const UnitRay<C> reset = bench_.take_one(bench_.unit.reset);
  EXPECT_TRUE(reset.reset);
  EXPECT_EQ(reset.packet, PacketId<C>(5));
  EXPECT_EQ(reset.ray, RayIndex<C>(2));
  EXPECT_TRUE(bench_.take(bench_.unit.enter_object).empty());
  const Ray<Real> ray = saved(0, 2);
  EXPECT_EQ(ray.origin.y, real(2));
  EXPECT_EQ(ray.direction.x, real(2));
  EXPECT_EQ(ray.direction.y, Real::one() / real(-3));
  EXPECT_EQ(ray.direction.z, real(1.0 / 1024));
}

TEST_F(RayReciprocals, APacketEntersAnObjectAfterItsLastRay) {
  for (unsigned ray = 0; ray < kRays<C>; ++ray) {
    EXPECT_TRUE(bench_.take(bench_.unit.enter_object).empty()) << ray;
    send(false, ray, {real(ray + 1), real(4), real(4)});
  }
  const TraversalEvent<C> e = bench_.take_one(bench_.unit.enter_object);
  EXPECT_EQ(e.kind, TraversalKind::kEnter);
  EXPECT_EQ(e.packet, PacketId<C>(5));
  EXPECT_EQ(e.level, Level(1));
  EXPECT_EQ(e.next, Address(1234));
  EXPECT_EQ(e.active, RayMask<C>(0b1011));
  EXPECT_TRUE(bench_.take(bench_.unit.reset).empty());
  EXPECT_EQ(saved(1, 1).direction.x, real(0.5));
  EXPECT_EQ(saved(1, 3).direction.x, real(0.25));
}

TEST_F(RayReciprocals, HaveTheDirectionsSignWhateverItsSize) {
  hls::testing::Random random(1);
  for (unsigned i = 0; i < 3000; ++i) {
    const Vec d{hls::testing::random_leaf<Real>(random), hls::testing::random_leaf<Real>(random),
                hls::testing::random_leaf<Real>(random)};
    send(true, 0, d);
    const Vec r = saved(0, 0).direction;
    EXPECT_EQ(r.x.sign(), d.x.sign());
    EXPECT_EQ(r.y.sign(), d.y.sign());
    EXPECT_EQ(r.z.sign(), d.z.sign());
  }
}

TEST_F(RayReciprocals, SaturateForDirectionsAboveTheRangesMiddleAlone) {
  const Real edge = real(std::ldexp(1, kBias));
  send(true, 0, {-Real::smallest(), edge, -Real::largest()});
  const Vec r = saved(0, 0).direction;
  EXPECT_EQ(r.x, real(-std::ldexp(1, kBias))) << "the smallest has a reciprocal";
  EXPECT_EQ(r.y, Real::smallest()) << "2^bias is the largest whose reciprocal is exact";
  EXPECT_EQ(r.z, -Real::smallest()) << "saturated: the exact one is four times smaller";
  // What is twice the middle has half the reciprocal, which no number is.
  send(true, 0, {real(std::ldexp(1, kBias - 1)), real(std::ldexp(1, kBias + 1)), edge});
  EXPECT_EQ(saved(0, 0).direction.x, real(std::ldexp(1, 1 - kBias)));
  EXPECT_EQ(saved(0, 0).direction.y, Real::smallest());
}

using WorldBoxes = test::FastFromOnePoint<test::PacketsOf<test::Config<8>, 8>>;

TEST(RayReciprocalsOfBoxes, KeepThoseOfTheWorldForTheTestOfBoxes) {
  test::UnitBench<RayReciprocal<WorldBoxes>> bench;
  const auto send = [&bench](bool is_new, unsigned ray, const Vec& direction) {
    Repeated<TracedRay<WorldBoxes>> traced;
    traced.job.is_new = is_new;
    traced.job.ray.packet = 5;
    traced.job.ray.ray = RayIndex<WorldBoxes>::from(ray);
    traced.job.ray.in_object.direction = direction;
    for (const bool last : {false, true}) {
      traced.last = last;
      bench.feed(bench.unit.traced, traced);
      bench.run();
      EXPECT_EQ(bench.take(bench.unit.reset).size(), is_new && last)
          << "a ray that waits is not sent";
    }
  };
  for (unsigned ray = 0; ray < kRays<WorldBoxes>; ++ray) {
    send(true, ray, {real(1u << ray), real(-4), real(0.5)});
  }
  send(false, 2, {real(3), real(3), real(3)});
  for (unsigned ray = 0; ray < kRays<WorldBoxes>; ++ray) {
    const Vec world{real(std::ldexp(1, -static_cast<int>(ray))), real(-0.25), real(2)};
    EXPECT_TRUE(test::same(bench.rows(bench.unit.in_world)[8 * 5 + ray], world)) << ray;
  }
}

}  // namespace
}  // namespace dynrt
