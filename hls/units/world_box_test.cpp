// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/world_box.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Fast<test::PacketsOf<test::Config<8>, 8>>;
using Vec = std::array<double, 3>;
constexpr unsigned kPacket = 5;
constexpr unsigned kObject = 1234;

Real real(double value) { return Real::from_double(value); }
Bound<Real> bound(double value) { return Bound<Real>::from_double(value); }

class WorldBoxes : public testing::Test {
 protected:
  WorldBoxes() { box({-1, -1, 2}, {1, 1, 4}); }
  /// As it lies from the eye.
  void box(const Vec& low, const Vec& high) {
    BoxedObject<C>& o = bench_.rows(bench_.unit.object)[kPacket];
    o.matrix = kObject;
    for (unsigned i = 0; i < 3; ++i) o.slabs[i] = {bound(low[i]), bound(high[i])};
  }
  void ray(unsigned number, const Vec& direction, double hit = 1e9) {
    const auto row = ray_row<C>(kPacket, RayIndex<C>::from(number)).to_u64();
    bench_.rows(bench_.unit.reciprocal)[row] = {Real::one() / real(direction[0]),
                                                Real::one() / real(direction[1]),
                                                Real::one() / real(direction[2])};
    bench_.rows(bench_.unit.reach)[row] = real(hit);
  }
  /// Of the rays, those that enter; none goes on in the list.
  unsigned enter(unsigned rays) {
    bench_.rows(bench_.unit.object)[kPacket].rays = RayMask<C>::from(rays);
    BoxJob<C> job;
    job.packet = kPacket;
    job.repeat = RepeatCount<C>::from(static_cast<unsigned>(std::popcount(rays)) - 1);
    for (unsigned i = 0; i <= job.repeat.to_u64(); ++i) {
      bench_.feed(bench_.unit.job,
                  Repeated<BoxJob<C>>{RepeatCount<C>::from(i), i == job.repeat.to_u64(), job});
    }
    bench_.run();
    const auto jobs = bench_.take(bench_.unit.enter);
    const auto missed = bench_.take(bench_.unit.missed);
    EXPECT_EQ(jobs.size() + missed.size(), 1u);
    for (const ListJob<C>& go_on : missed) {
      ListJob<C> expected;
      expected.packet = kPacket;
      EXPECT_TRUE(test::same(go_on, expected));
    }
    if (jobs.empty()) return 0;
    EXPECT_NE(jobs[0].active, RayMask<C>{});
    EXPECT_TRUE(test::same(
        jobs[0], TransformJob<C>{3, kPacket, TransformKind::kObject, jobs[0].active, kObject}));
    return static_cast<unsigned>(jobs[0].active.to_u64());
  }
  BoxInterval<C> interval(unsigned ray) {
    return interval_of<C>(bench_.rows(bench_.unit.interval[ray])[kPacket]);
  }
  /// Whether a ray alone enters.
  bool enters(const Vec& direction, double hit = 1e9) {
    ray(3, direction, hit);
    return enter(0b1000) != 0;
  }
  test::UnitBench<WorldBox<C>> bench_;
};

TEST_F(WorldBoxes, TheRaysThatMeetTheBoxEnterTheObject) {
  for (unsigned i = 0; i < kRays<C>; ++i) ray(i, {i % 2 == 0 ? 0.1 : 0.9, 0.2, 1});
  EXPECT_EQ(enter(0b11111111), 0b01010101u);
  EXPECT_EQ(enter(0b11001100), 0b01000100u) << "of those that are to be tested";
  EXPECT_EQ(enter(0b10101010), 0u);
  EXPECT_EQ(enter(0b00000001), 0b00000001u) << "the packet before leaves nothing behind";
}

TEST_F(WorldBoxes, EveryAxisAndDirectionCounts) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      Vec low{-1, -1, -1}, high{1, 1, 1}, along{0.25, -0.25, 0.125};
      low[axis] = side > 0 ? 2 : -4;
      high[axis] = side > 0 ? 4 : -2;
      box(low, high);
      along[axis] = side;
      EXPECT_TRUE(enters(along)) << axis << " " << side;
      along[axis] = -side;
      EXPECT_FALSE(enters(along)) << "it lies behind";
      along[axis] = side;
      along[(axis + 1) % 3] = 0.625;
      EXPECT_FALSE(enters(along)) << "it lies beside";
      along[(axis + 1) % 3] = -0.625;
      EXPECT_FALSE(enters(along));
    }
  }
}

TEST_F(WorldBoxes, ABoxBehindTheHitIsNotEntered) {
  EXPECT_FALSE(enters({0, 0, 1}, 1.98));
  EXPECT_TRUE(enters({0, 0, 1}, 2));
  EXPECT_TRUE(enters({0, 0, 1}, 3));
  EXPECT_FALSE(enters({0, 0, 0.5}, 3.96)) << "distances are in lengths of the direction";
  EXPECT_TRUE(enters({0, 0, 0.5}, 4.01));
}

TEST_F(WorldBoxes, ARayFromInsideEnters) {
  box({-1, -1, -1}, {1, 1, 1});
  EXPECT_TRUE(enters({0.5, -2, 1}));
  EXPECT_TRUE(enters({-0.5, 2, -1}));
  EXPECT_TRUE(enters({0, 0, -1}, 1e-6)) << "whatever it has hit";
}

TEST_F(WorldBoxes, TheTraversalBeginsWithTheIntervalInTheBox) {
  ray(0, {0.1, 0.2, 1});
  ray(1, {0.1, 0.2, 1}, 3);
  ray(2, {0.45, 0.1, -1});
  ray(3, {0.4, 0.1, 1});
  EXPECT_EQ(enter(0b1011), 0b1011u);
  for (const auto& [ray, near, far] : {std::tuple(0u, 2.0, 4.0), {1u, 2.0, 3.0}, {3u, 2.0, 2.5}}) {
    EXPECT_LE(interval(ray).near.to_double(), near) << ray;
    EXPECT_GE(interval(ray).far.to_double(), far) << ray;
    EXPECT_NEAR(interval(ray).near.to_double(), near, 5e-3) << ray;
    EXPECT_NEAR(interval(ray).far.to_double(), far, 2e-2) << ray;
  }
  box({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(enter(0b0100), 0b0100u);
  EXPECT_EQ(interval(2).near, Real{}) << "from inside it starts at once";
  EXPECT_NEAR(interval(2).far.to_double(), 1, 5e-3);
}

/// Zero is the smallest number, of either sign.
TEST_F(WorldBoxes, ARayAlongAnAxisMeetsWhatLiesThere) {
  for (const double zero : {0.0, -1e-30}) {
    box({-1, -1, 2}, {1, 1, 4});
    EXPECT_TRUE(enters({zero, zero, 1})) << zero;
    EXPECT_FALSE(enters({zero, zero, -1}));
    box({0.5, -1, 2}, {1, 1, 4});
    EXPECT_FALSE(enters({zero, zero, 1})) << "it passes beside";
    box({-1, -1, 2}, {-0.5, 1, 4});
    EXPECT_FALSE(enters({zero, zero, 1}));
  }
}

TEST_F(WorldBoxes, ARayThatGrazesAnEdgeEnters) {
  // Through the edges at (1, 2), where it leaves along x as it enters along z, and at (1, 4).
  EXPECT_TRUE(enters({0.5, 0, 1}));
  EXPECT_FALSE(enters({0.5 * (1 + 5e-3), 0, 1}));
  box({1, -1, 2}, {2, 1, 4});
  EXPECT_TRUE(enters({0.25, 0, 1})) << "it enters along x as it leaves along z";
  EXPECT_FALSE(enters({0.25 * (1 - 5e-3), 0, 1}));
  // Where the reciprocals and the products are rounded.
  test::Random random(5);
  for (unsigned n = 0; n < 20'000; ++n) {
    const double x = bound(0.5 + static_cast<double>(random.below(1000)) / 777).to_double();
    const double z = bound(0.5 + static_cast<double>(random.below(1000)) / 555).to_double();
    box({-1, -1, z}, {x, 1, 2 * z});
    // The nearest numbers of which the ray meets the box.
    const Real down = real(1.0 + static_cast<double>(random.below(1u << 16)) / (1u << 16));
    double across = real(down.to_double() * x / z).to_double();
    if (across * z > x * down.to_double()) across -= std::exp2(std::ilogb(across) - 16);
    ASSERT_TRUE(enters({across, 0, down.to_double()})) << n;
  }
}

TEST_F(WorldBoxes, NoRayThatMeetsTheBoxIsRejected) {
  test::Random random(78);
  unsigned met = 0, missed = 0, wide = 0;
  const auto number = [&random] {
    const double u = static_cast<double>(random.below(1u << 20)) / (1u << 19) - 1;
    return u * std::exp2(static_cast<double>(random.below(12)) - 6);
  };
  for (unsigned n = 0; n < 200'000; ++n) {
    Vec low, high, direction;
    double near = 0, far = 1e9;
    for (unsigned i = 0; i < 3; ++i) {
      low[i] = bound(number()).to_double();
      high[i] = bound(number()).to_double();
      if (low[i] > high[i]) std::swap(low[i], high[i]);
      direction[i] = real(number()).to_double();
      near = std::max(near, std::min(low[i] / direction[i], high[i] / direction[i]));
      far = std::min(far, std::max(low[i] / direction[i], high[i] / direction[i]));
    }
    box(low, high);
    const double hit = real(std::abs(8 * number())).to_double();
    const bool entered = enters(direction, hit);
    if (near <= far && near <= hit && far > 0) {
      ++met;
      ASSERT_TRUE(entered) << "ray " << n;
      const double from = interval(3).near.to_double(), to = interval(3).far.to_double();
      ASSERT_LE(from, std::max(near * (1 + 0x1p-17), Real{}.to_double()));
      ASSERT_GE(to, std::min(far, hit));
      ASSERT_GE(from, near * (1 - 0x1p-9)) << "no wider than its bits ask for";
      ASSERT_LE(to, std::min(far, hit) * (1 + 6 * 0x1p-11));
    } else {
      ++missed;
      if (entered && (near > far * (1 + 8 * 0x1p-11) || near > hit * (1 + 8 * 0x1p-11))) ++wide;
    }
  }
  EXPECT_GT(met, 10'000u);
  EXPECT_GT(missed, 10'000u);
  EXPECT_EQ(wide, 0u) << "no wider than rounding asks for";
}

}  // namespace
}  // namespace dynrt
