// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/light_columns.h"

#include "configs/whitted.h"
#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = config::whitted;
using Column = LightColumns<C>::Column;

MatrixColumn<Real> column_of(double x, double y, double z) {
  MatrixColumn<Real> line;
  line.row[0].value = Real::from_double(x);
  line.row[1].value = Real::from_double(y);
  line.row[2].value = Real::from_double(z);
  return line;
}

class LightColumnsTest : public testing::Test {
 protected:
  LightColumnsTest() {
    const auto real = [](double v) { return Real::from_double(v); };
    bench_.rows(bench_.unit.arriving)[5 * kRays<C> + 2] = {{real(1), real(2), real(3)},
                                                           {real(4), real(5), real(6)}};
  }
  MatrixColumn<Real> through(TransformKind kind, Derivation pass, unsigned number,
                             MatrixColumn<Real> line) {
    Column c;
    c.context.packet = 5;
    c.context.kind = kind;
    c.context.column = uint<2>::from(number);
    c.context.extras.derived = DerivedRay<C>{pass, RayIndex<C>(2)};
    c.address = Address::from(40 + number);
    c.line = line;
    bench_.feed(bench_.unit.fetched, c);
    bench_.run();
    const Column out = bench_.take_one(bench_.unit.column);
    EXPECT_EQ(out.address, c.address);
    EXPECT_TRUE(test::same(out.context, c.context));
    return out.line;
  }
  test::UnitBench<LightColumns<C>> bench_;
};

TEST_F(LightColumnsTest, ALightRaysMatrixTakesTheArrivingRayAndTheLightsPlace) {
  MatrixColumn<Real> power = column_of(2.5, 0, 0);
  power.row[0].spare = 10;
  power.row[1].spare = 20;
  power.row[2].spare = 30;
  const MatrixColumn<Real> place = column_of(7, 8, 9);
  const auto values = [](const MatrixColumn<Real>& c) {
    return std::array{c.row[0].value.to_double(), c.row[1].value.to_double(),
                      c.row[2].value.to_double()};
  };
  const auto light = [&](unsigned number, const MatrixColumn<Real>& line) {
    return values(through(TransformKind::kSecondary, Derivation::kLight, number, line));
  };
  EXPECT_EQ(light(0, power), (std::array{1.0, 2.0, 3.0})) << "origin of the ray that arrived";
  EXPECT_EQ(light(1, column_of(0, 0, 0)), (std::array{4.0, 5.0, 6.0})) << "its direction";
  EXPECT_EQ(light(2, place), (std::array{7.0, 8.0, 9.0}));
  EXPECT_EQ(light(3, place), (std::array{7.0, 8.0, 9.0}));
  const LightPower<C> kept = bench_.rows(bench_.unit.light)[5];
  EXPECT_EQ(kept.intensity.to_double(), 2.5);
  EXPECT_EQ(kept.colour, uint<24>(30 << 16 | 20 << 8 | 10));
}

TEST_F(LightColumnsTest, AllOtherColumnsPassUnchanged) {
  const MatrixColumn<Real> line = column_of(11, 12, 13);
  for (unsigned number = 0; number < 4; ++number) {
    for (const TransformKind kind :
         {TransformKind::kCamera, TransformKind::kObject, TransformKind::kTriangle}) {
      EXPECT_TRUE(test::same(through(kind, Derivation::kLight, number, line), line));
    }
    for (const Derivation pass :
         {Derivation::kIntoObject, Derivation::kMirror, Derivation::kOutOfObject}) {
      EXPECT_TRUE(test::same(through(TransformKind::kSecondary, pass, number, line), line));
    }
  }
  EXPECT_TRUE(test::same(bench_.rows(bench_.unit.light)[5], LightPower<C>{}));
}

}  // namespace
}  // namespace dynrt
