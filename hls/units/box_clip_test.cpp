// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/box_clip.h"

#include <algorithm>
#include <cmath>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using Vec = Vector<Real>;

Real real(double value) { return Real::from_double(value); }

class Box : public testing::Test {
 protected:
  Box() {
    for (unsigned i = 0; i < kRays<C>; ++i) hit(i, Real::largest());
  }
  void hit(unsigned ray, Real t) { bench_.rows(bench_.unit.hit_distance[ray])[5] = t; }
  void send(unsigned ray, const Vec& origin, const Vec& direction, unsigned active = 15) {
    ObjectRay<C> r;
    r.packet = 5;
    r.ray = RayIndex<C>::from(ray);
    r.active = RayMask<C>::from(active);
    r.root = 1234;
    r.in_object = {origin, direction};
    bench_.feed(bench_.unit.ray, r);
    bench_.run();
  }
  BoxInterval<C> interval(unsigned ray) { return bench_.rows(bench_.unit.interval[ray])[5]; }
  test::UnitBench<BoxClip<C>> bench_;
};

const Vec kAlongX{Real::one(), Real{}, Real{}};

TEST_F(Box, APacketEntersWithTheRaysThatMeetTheBox) {
  send(0, {real(-3), real(0.5), real(0.5)}, kAlongX);
  send(1, {real(-3), real(2), real(0.5)}, kAlongX);
  send(2, {real(3), real(0.5), real(0.5)}, kAlongX);
  send(3, {real(-3), real(-0.5), real(-0.5)}, kAlongX);
  const TraversalEvent<C> e = bench_.take_one(bench_.unit.enter_object);
  EXPECT_EQ(e.kind, TraversalKind::kEnter);
  EXPECT_EQ(e.packet, PacketId<C>(5));
  EXPECT_EQ(e.level, Level(1));
  EXPECT_EQ(e.next, Address(1234));
  EXPECT_EQ(e.active, RayMask<C>(0b1001)) << "ray 1 passes the box, ray 2 has it behind";
  EXPECT_TRUE(bench_.take(bench_.unit.missed).empty());
  EXPECT_NEAR(interval(0).near.to_double(), 2, 1e-3);
  EXPECT_LT(interval(0).near.to_double(), 2);
  EXPECT_NEAR(interval(0).far.to_double(), 4, 1e-3);
  EXPECT_GT(interval(0).far.to_double(), 4);
}

TEST_F(Box, APacketThatMissesTheBoxGoesOnInTheList) {
  for (unsigned i = 0; i < kRays<C>; ++i) send(i, {real(-3), real(2), real(0.5)}, kAlongX);
  EXPECT_TRUE(bench_.take(bench_.unit.enter_object).empty());
  const ListJob<C> job = bench_.take_one(bench_.unit.missed);
  EXPECT_EQ(job.packet, PacketId<C>(5));
  EXPECT_EQ(job.level, Level(0));
  EXPECT_FALSE(job.first);
}

TEST_F(Box, ABoxBehindTheHitIsNotEntered) {
  for (unsigned i = 0; i < kRays<C>; ++i) {
    hit(i, real(i == 2 ? 2.5 : 1.5));
    send(i, {real(-3), real(0.5), real(0.5)}, kAlongX);
  }
  EXPECT_EQ(bench_.take_one(bench_.unit.enter_object).active, RayMask<C>(0b0100));
  EXPECT_EQ(interval(2).far, real(2.5));
}

TEST_F(Box, RaysThatAreNotTracedDoNotEnter) {
  for (unsigned i = 0; i < kRays<C>; ++i) {
    send(i, {real(-3), real(0.5), real(0.5)}, kAlongX, 0b0110);
  }
  EXPECT_EQ(bench_.take_one(bench_.unit.enter_object).active, RayMask<C>(0b0110));
}

TEST_F(Box, ARayFromInsideStartsAtOnce) {
  for (unsigned i = 0; i < kRays<C>; ++i) send(i, {real(0.25), real(-0.5), real(0.5)}, kAlongX);
  EXPECT_EQ(bench_.take_one(bench_.unit.enter_object).active, RayMask<C>(0b1111));
  EXPECT_EQ(interval(3).near, Real{});
  EXPECT_NEAR(interval(3).far.to_double(), 0.75, 1e-3);
}

/// The interval from double arithmetic on the same numbers.
TEST_F(Box, NoPartOfTheBoxIsLost) {
  test::Random random(77);
  unsigned met = 0, missed = 0, wide = 0;
  for (unsigned n = 0; n < 200'000; ++n) {
    const auto number = [&random](double scale) {
      const double u = static_cast<double>(random.below(1u << 20)) / (1u << 19) - 1;
      return Real::from_double(u * std::exp2(static_cast<double>(random.below(12)) - 6) * scale);
    };
    const Vec o{number(1), number(1), number(1)};
    const Vec d{number(1), number(1), number(1)};
    double near = 0, far = Real::largest().to_double();
    for (const auto& [origin, direction] :
         {std::pair{o.x, d.x}, std::pair{o.y, d.y}, std::pair{o.z, d.z}}) {
      const double a = (-1 - origin.to_double()) / direction.to_double();
      const double b = (1 - origin.to_double()) / direction.to_double();
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    for (unsigned i = 0; i < kRays<C>; ++i) send(i, o, d);
    const bool enters = !bench_.take(bench_.unit.enter_object).empty();
    bench_.take(bench_.unit.missed);
    if (near <= far && far > 1e-9) {
      ++met;
      ASSERT_TRUE(enters) << "ray " << n;
      ASSERT_LE(interval(0).near.to_double(), std::max(near, 1e-9));
      ASSERT_GE(interval(0).far.to_double(), far);
      if (interval(0).far.to_double() > far * (1 + 1e-3)) ++wide;
    } else if (!enters) {
      ++missed;
    }
  }
  EXPECT_GT(met, 10'000u);
  EXPECT_GT(missed, 10'000u);
  EXPECT_LT(wide, met / 20) << "no wider than rounding asks for";
}

}  // namespace
}  // namespace dynrt
