// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/traversal_slice.h"

#include <cmath>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using Slice = TraversalSlice<C>;
using UnitBench = test::UnitBench<Slice>;
using Vec = Vector<Real>;

Real real(double value) { return Real::from_double(value); }

Step<C> step(IntervalUpdate update, double split, bool both, unsigned stack = 0,
             unsigned level = 0) {
  Step<C> s;
  s.context.packet = 3;
  s.context.level = Level::from(level);
  s.context.update = update;
  s.context.both = RayMask<C>::from(both ? 15 : 0);
  s.context.active = 15;
  s.context.stack = StackPointer<C>::from(stack);
  s.node.kind = NodeKind::kSplitX;
  s.node.split = real(split);
  return s;
}
SliceDecision decide(UnitBench& bench, const Step<C>& s) {
  bench.feed(bench.unit.step_in, s);
  bench.run();
  return bench.take_one(bench.unit.decision);
}
void set_ray(UnitBench& bench, const Step<C>& s, const Ray<Real>& ray) {
  const LevelRow<C> row = level_row<C>(s.context.level, s.context.packet);
  for (unsigned axis = 0; axis < 3; ++axis) {
    bench.rows(bench.unit.ray)[axis_row<C>(row, uint<2>::from(axis)).to_u64()] = by_axis(ray)[axis];
  }
}

/// A ray along x from the origin: a plane's distance is where it splits.
class AlongX : public testing::Test {
 protected:
  AlongX() {
    for (auto& row : bench_.rows(bench_.unit.ray)) row = {{}, Real::one()};
    hit(Real::largest());
  }
  void hit(Real distance) { bench_.rows(bench_.unit.hit_distance)[3] = distance; }
  void expect(unsigned level, double near, double far, double plane) {
    const Slice::Interval i =
        bench_.unit.interval.read(level_row<C>(Level::from(level), PacketId<C>(3)));
    EXPECT_EQ(i.near.to_double(), near);
    EXPECT_EQ(i.far.to_double(), far);
    EXPECT_EQ(i.plane.to_double(), plane);
  }
  const double kSmallest = Real::smallest().to_double();
  const double kLargest = Real::largest().to_double();
  UnitBench bench_;
};

TEST_F(AlongX, StartsWithTheRayUpToItsHit) {
  for (const unsigned level : {0, 1}) {
    hit(Real::largest());
    decide(bench_, step(IntervalUpdate::kInit, 10, true, 0, level));
    expect(level, kSmallest, kLargest, 10);
    hit(real(40));
    decide(bench_, step(IntervalUpdate::kInit, 10, true, 0, level));
    expect(level, kSmallest, 40, 10);
  }
}

TEST_F(AlongX, ClipsPushesAndPops) {
  using enum IntervalUpdate;
  decide(bench_, step(kInit, 10, false));
  expect(0, kSmallest, kLargest, 10);
  decide(bench_, step(kClipFarPush, 4, true, 0));
  expect(0, kSmallest, 10, 4);
  decide(bench_, step(kClipFarPush, 2, true, 1));
  expect(0, kSmallest, 4, 2);
  decide(bench_, step(kClipNear, 3, true, 2));
  expect(0, 2, 4, 3);
  decide(bench_, step(kClipFar, 5, true, 2));
  expect(0, 2, 3, 5);
  decide(bench_, step(kPop, 7, true, 1));
  expect(0, 3, 10, 7);
  decide(bench_, step(kPop, 12, true, 0));
  expect(0, 10, kLargest, 12);
}

TEST_F(AlongX, ARayThatEntersOneChildKeepsItsInterval) {
  using enum IntervalUpdate;
  decide(bench_, step(kInit, 10, false));
  for (const IntervalUpdate update : {kClipFar, kClipFarPush, kClipNear, kPop}) {
    decide(bench_, step(update, 20, false, 5));
    expect(0, kSmallest, kLargest, 20);
  }
}

TEST_F(AlongX, TerminatesWhereTheHitLiesBeforeTheInterval) {
  using enum IntervalUpdate;
  hit(real(15));
  decide(bench_, step(kInit, 10, false));
  EXPECT_FALSE(decide(bench_, step(kClipNear, 14, true)).terminated);
  EXPECT_FALSE(decide(bench_, step(kClipNear, 15, true)).terminated);
  EXPECT_FALSE(decide(bench_, step(kClipNear, 16, true)).terminated) << "a hit at its beginning";
  EXPECT_TRUE(decide(bench_, step(kClipNear, 17, true)).terminated);
  EXPECT_FALSE(decide(bench_, step(kInit, 10, true)).terminated) << "the interval is new";
}

TEST_F(AlongX, TheLaneChoosesTheRaysBit) {
  using enum IntervalUpdate;
  for (unsigned lane = 0; lane < kRays<C>; ++lane) {
    bench_.value(bench_.unit.lane) = RayIndex<C>::from(lane);
    decide(bench_, step(kInit, 10, false));
    Step<C> s = step(kClipFar, 20, false);
    s.context.both = RayMask<C>::from(15u ^ (1u << lane));
    decide(bench_, s);
    expect(0, kSmallest, kLargest, 20);
    s.context.both = RayMask<C>::from(1u << lane);
    decide(bench_, s);
    expect(0, kSmallest, 20, 20);
  }
}

TEST(TraversalSlice, TheAxisIsTheNodes) {
  UnitBench bench;
  const Ray<Real> ray{{real(1), real(2), real(3)}, {real(1), real(-2), real(4)}};
  const double expected[] = {9.0, -4.0, 1.75};
  for (unsigned axis = 0; axis < 3; ++axis) {
    Step<C> s = step(IntervalUpdate::kInit, 10, false);
    s.node.kind = static_cast<NodeKind>(axis);
    set_ray(bench, s, ray);
    decide(bench, s);
    EXPECT_EQ(bench.unit.interval.read(3).plane.to_double(), expected[axis]);
  }
}

/// Magnitudes over 2^-20 to 2^20, either sign.
Real random_real(test::Random& random) {
  auto bits = test::random_token<Real>(random).bits().to_u64() & 0x80ffff;
  return Real::from_bits(Real::Bits::from(bits | (43 + random.next() % 41) << 16));
}
Vec random_vector(test::Random& random) {
  return {random_real(random), random_real(random), random_real(random)};
}

TEST(TraversalSlice, DecidesAsDoubleArithmeticDoes) {
  UnitBench bench;
  test::Random random(312);
  unsigned decided = 0, left = 0, right = 0, both = 0, terminated = 0;
  for (unsigned n = 0; n < 200'000; ++n) {
    Step<C> s = step(IntervalUpdate::kClipFar, 0, false);
    s.node.kind = static_cast<NodeKind>(test::below(random, 3));
    s.node.split = random_real(random);
    const Ray<Real> ray{random_vector(random), random_vector(random)};
    const Real hit = abs(random_real(random));
    Slice::Interval interval{abs(random_real(random)), abs(random_real(random)), {}};
    if (interval.far < interval.near) std::swap(interval.near, interval.far);
    set_ray(bench, s, ray);
    bench.rows(bench.unit.hit_distance)[3] = hit;
    bench.unit.interval.write(3, interval);
    const SliceDecision out = decide(bench, s);

    const unsigned axis = static_cast<unsigned>(s.node.kind);
    const auto component = [axis](const Vec& v) {
      return (axis == 0 ? v.x : axis == 1 ? v.y : v.z).to_double();
    };
    const double split = s.node.split.to_double();
    const double d = (split - component(ray.origin)) / component(ray.direction);
    const double near = interval.near.to_double();
    const double far = interval.far.to_double();
    ASSERT_EQ(out.left_first, component(ray.origin) <= split);
    ASSERT_EQ(out.terminated, hit.to_double() < near);
    // Two roundings of half a unit in the last place each may move d.
    const double doubt = std::abs(d) * 0x1p-15;
    if (std::abs(d - near) <= doubt || std::abs(d - far) <= doubt || d == 0) continue;
    ++decided;
    const bool go_near = d >= near || d <= 0;
    const bool go_far = d <= far && d >= 0;
    ASSERT_EQ(out.left_first ? out.go_left : out.go_right, go_near) << n;
    ASSERT_EQ(out.left_first ? out.go_right : out.go_left, go_far) << n;
    left += out.go_left && !out.go_right;
    right += out.go_right && !out.go_left;
    both += out.go_left && out.go_right;
    terminated += out.terminated;
  }
  EXPECT_GT(decided, 190'000u);
  EXPECT_GT(std::min({left, right, both, terminated}), 5'000u);
}

TEST(TraversalSlice, ARayAlongThePlaneStaysOnItsSide) {
  UnitBench bench;
  for (const bool backward : {false, true}) {
    for (const double origin : {-5.0, 5.0}) {
      Step<C> s = step(IntervalUpdate::kClipFar, 1, false);
      const Real along = backward ? -Real::smallest() : Real::smallest();
      set_ray(bench, s, {{real(origin), {}, {}}, {along, {}, {}}});
      bench.rows(bench.unit.hit_distance)[3] = Real::largest();
      bench.unit.interval.write(3, {real(1), real(1e6), {}});
      const SliceDecision out = decide(bench, s);
      EXPECT_EQ(out.go_left, origin < 1);
      EXPECT_EQ(out.go_right, origin > 1);
    }
  }
}

TEST(TraversalSlice, AnOriginInThePlaneHasTheLeftChildFirst) {
  UnitBench bench;
  for (const double direction : {-1.0, 1.0}) {
    Step<C> s = step(IntervalUpdate::kInit, 3, false);
    set_ray(bench, s, {{real(3), {}, {}}, {real(direction), {}, {}}});
    const SliceDecision out = decide(bench, s);
    EXPECT_TRUE(out.left_first);
    EXPECT_TRUE(out.go_left);
    EXPECT_EQ(out.go_right, direction > 0);
  }
}

TEST(TraversalSlice, KeepsPacketsAndLevelsApart) {
  struct State {
    Real near, far, plane;
    Real stack[C::kStackDepth];
  };
  State states[2][C::kPackets] = {};
  UnitBench bench;
  test::Random random(77);
  for (unsigned n = 0; n < 100'000; ++n) {
    const bool first = n < 16;  // every interval starts somewhere
    const unsigned packet = first ? n % 8 : test::below(random, C::kPackets);
    const unsigned level = first ? n / 8 : test::below(random, 2);
    Step<C> s =
        step(first ? IntervalUpdate::kInit : static_cast<IntervalUpdate>(test::below(random, 5)), 0,
             test::chance(random, 70), test::below(random, C::kStackDepth), level);
    s.context.packet = PacketId<C>::from(packet);
    s.node.split = random_real(random);
    const Ray<Real> ray{random_vector(random), random_vector(random)};
    const Real hit = abs(random_real(random));
    set_ray(bench, s, ray);
    bench.rows(bench.unit.hit_distance)[packet] = hit;
    decide(bench, s);

    State& state = states[level][packet];
    const unsigned top = static_cast<unsigned>(s.context.stack.to_u64());
    const bool both = s.context.both.bit<0>();
    const Real far = state.far;
    if (s.context.update == IntervalUpdate::kInit) {
      state.near = Real::smallest();
      state.far = hit;
    } else if (s.context.update == IntervalUpdate::kPop && both) {
      state.near = state.far;
      state.far = state.stack[top];
    } else if (s.context.update == IntervalUpdate::kClipNear && both) {
      state.near = state.plane;
    } else if (both) {
      state.far = state.plane;
    }
    if (s.context.update == IntervalUpdate::kClipFarPush) state.stack[top] = far;
    state.plane = (s.node.split - ray.origin.x) / ray.direction.x;
    const Slice::Interval interval =
        bench.unit.interval.read(level_row<C>(s.context.level, s.context.packet));
    ASSERT_EQ(interval.near, state.near) << n;
    ASSERT_EQ(interval.far, state.far) << n;
    ASSERT_EQ(interval.plane, state.plane) << n;
  }
}

struct Remembers : test::Config<8> {
  static constexpr unsigned kReflections = 1;
  static constexpr Crossing kCrossing = Crossing::kRemember;
};

TEST(TraversalSlice, ARayThatCrossedOthersPopsTheIntervalOfTheParent) {
  using Crossed = TraversalSlice<Remembers>;
  test::UnitBench<Crossed> bench;
  for (auto& row : bench.rows(bench.unit.ray)) row.fill({{}, Real::one()});
  bench.rows(bench.unit.hit_distance)[0] = Real::largest();
  bench.rows(bench.unit.start_distance)[0] = real(1);
  const auto decide = [&](IntervalUpdate update, double split, bool both, bool crossing) {
    Step<Remembers> s;
    s.context.update = update;
    s.context.both = RayMask<C>::from(both);
    s.context.crossing = RayMask<C>::from(crossing);
    s.node.kind = NodeKind::kSplitX;
    s.node.split = real(split);
    bench.feed(bench.unit.step_in, s);
    bench.run();
    bench.take_one(bench.unit.decision);
    return bench.unit.interval.read(LevelRow<Remembers>{});
  };
  using enum IntervalUpdate;
  decide(kInit, 10, false, false);
  EXPECT_EQ(decide(kClipFarPush, 3, false, false).far, Real::largest()) << "not clipped at 10";
  EXPECT_EQ(decide(kClipNear, 5, true, false).near, real(3));
  const auto other_child = decide(kPop, 7, false, true);
  EXPECT_EQ(other_child.near, real(1));
  EXPECT_EQ(other_child.far, Real::largest());
}

using WorldBoxes = test::FastFromOnePoint<test::Config<8>>;

TEST(TraversalSliceOfBoxes, BeginsAnObjectWithTheIntervalInItsBox) {
  test::UnitBench<TraversalSlice<WorldBoxes>> bench;
  for (auto& row : bench.rows(bench.unit.ray)) row = Real::one();
  bench.rows(bench.unit.hit_distance)[3] = real(100);
  using Distance = BoxDistance<Real>;
  bench.rows(bench.unit.box)[3] = {Distance::from_double(4).magnitude(),
                                   Distance::from_double(8).magnitude()};
  const auto begin = [&bench](double split, unsigned level) {
    Step<WorldBoxes> s;
    s.context.packet = 3;
    s.context.level = Level::from(level);
    s.context.update = IntervalUpdate::kInit;
    s.context.active = 15;
    s.node.kind = NodeKind::kSplitX;
    s.node.split = real(split);
    bench.feed(bench.unit.step_in, s);
    bench.run();
    return bench.take_one(bench.unit.decision);
  };
  EXPECT_FALSE(begin(3.9, 1).go_left) << "it enters the box behind the plane";
  EXPECT_TRUE(begin(3.9, 1).go_right);
  EXPECT_TRUE(begin(6, 1).go_left && begin(6, 1).go_right);
  EXPECT_FALSE(begin(8.1, 1).go_right) << "it leaves the box before the plane";
  for (const double split : {3.9, 8.1}) {
    EXPECT_TRUE(begin(split, 0).go_left && begin(split, 0).go_right) << "the world has no box";
  }
}

}  // namespace
}  // namespace dynrt
