// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/plane_offset.h"

#include "units/test_bench.h"
#include "units/traversal_slice.h"

namespace dynrt {
namespace {

using C = test::FastFromOnePoint<test::Config<8>>;
struct Watertight : C {
  static constexpr TriangleTest kTriangleTest = TriangleTest::kWatertight;
};

Real real(double value) { return Real::from_double(value); }

template <class Config>
Step<Config> step(NodeKind kind, double split, unsigned level) {
  Step<Config> s;
  s.context.packet = 5;
  s.context.level = Level::from(level);
  s.context.active = 0b1011;
  s.node.kind = kind;
  s.node.split = real(split);
  s.node.left = 123;
  return s;
}

template <class Config>
class Offsets : public testing::Test {
 protected:
  Offsets() {
    bench_.rows(bench_.unit.origin)[5] = {real(1), real(2), real(3)};
    bench_.rows(bench_.unit.origin)[8 + 5] = {real(10), real(20), real(30)};
  }
  Step<Config> send(NodeKind kind, double split, unsigned level) {
    bench_.feed(bench_.unit.step_in, step<Config>(kind, split, level));
    bench_.run();
    return bench_.take_one(bench_.unit.offset);
  }
  test::UnitBench<PlaneOffset<Config>> bench_;
};
using PlaneOffsets = Offsets<C>;
using WatertightPlaneOffsets = Offsets<Watertight>;

TEST_F(PlaneOffsets, AreAlongTheAxisFromTheOriginOfTheLevel) {
  EXPECT_EQ(send(NodeKind::kSplitX, 8, 0).node.split, real(7));
  EXPECT_EQ(send(NodeKind::kSplitY, 8, 0).node.split, real(6));
  EXPECT_EQ(send(NodeKind::kSplitZ, 8, 0).node.split, real(5));
  EXPECT_EQ(send(NodeKind::kSplitX, 8, 1).node.split, real(-2));
  EXPECT_EQ(send(NodeKind::kSplitZ, 8, 1).node.split, real(-22));
}

TEST_F(PlaneOffsets, LeaveTheRestOfTheStep) {
  Step<C> sent = step<C>(NodeKind::kSplitY, 8, 1);
  const Step<C> got = send(NodeKind::kSplitY, 8, 1);
  sent.node.split = got.node.split;
  EXPECT_TRUE(test::same(got, sent));
}

TEST_F(WatertightPlaneOffsets, SayWhetherTheRaysStartInThePlane) {
  EXPECT_TRUE(send(NodeKind::kSplitY, 20, 1).in_plane.get());
  EXPECT_FALSE(send(NodeKind::kSplitY, 20.01, 1).in_plane.get());
  EXPECT_FALSE(send(NodeKind::kSplitX, 20, 1).in_plane.get());
}

/// What a slice decides of a plane that it subtracts its ray's origin from, and of the plane's
/// distance from the origin of all rays.
TEST_F(PlaneOffsets, GiveASliceWhatItsOwnOriginGives) {
  using Own = test::Fast<test::Config<8>>;
  test::UnitBench<TraversalSlice<C>> common;
  test::UnitBench<TraversalSlice<Own>> each;
  const Vector<Real> direction{real(0.5), real(-2), real(0.25)};
  const Ray<Real> ray{{real(1), real(2), real(3)}, direction};
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto row = axis_row<C>(5, uint<2>::from(axis)).to_u64();
    common.rows(common.unit.ray)[row] = slice_ray<C>(ray)[axis];
    each.rows(each.unit.ray)[row] = slice_ray<Own>(ray)[axis];
  }
  common.rows(common.unit.hit_distance)[5] = real(100);
  each.rows(each.unit.hit_distance)[5] = real(100);
  unsigned entered = 0;
  for (const NodeKind kind : {NodeKind::kSplitX, NodeKind::kSplitY, NodeKind::kSplitZ}) {
    for (const double split : {-50.0, 0.5, 1.0, 2.0, 3.0, 9.0, 60.0}) {
      common.feed(common.unit.step_in, send(kind, split, 0));
      each.feed(each.unit.step_in, step<Own>(kind, split, 0));
      common.run();
      each.run();
      const SliceDecision got = common.take_one(common.unit.decision);
      EXPECT_TRUE(test::same(got, each.take_one(each.unit.decision))) << split;
      entered += got.go_left && got.go_right ? 1 : 0;
    }
  }
  EXPECT_GT(entered, 3u) << "of the planes some lie within the rays' intervals";
}

}  // namespace
}  // namespace dynrt
