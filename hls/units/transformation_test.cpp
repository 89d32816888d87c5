// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/transformation.h"

#include <cmath>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<Transformation<C>>;
using Fused = test::Fast<C>;
using Vec = Vector<Real>;

std::array<Real, 3> parts(const Vec& v) { return {v.x, v.y, v.z}; }
Vec vec(double x, double y, double z) {
  return {Real::from_double(x), Real::from_double(y), Real::from_double(z)};
}

PacketVector<C> transform(UnitBench& bench, const PacketVector<C>& in) {
  bench.feed(bench.unit.vector, in);
  bench.run();
  const PacketVector<C> out = bench.take_one(bench.unit.transformed);
  EXPECT_EQ(out.packet, in.packet);
  EXPECT_EQ(out.point, in.point);
  EXPECT_EQ(out.ray, in.ray);
  return out;
}

TEST(Transformation, APointIsTranslatedADirectionIsNot) {
  UnitBench bench;
  bench.rows(bench.unit.column[0])[2] = vec(0, 2, 0);
  bench.rows(bench.unit.column[1])[2] = vec(-3, 0, 0);
  bench.rows(bench.unit.column[2])[2] = vec(0, 0, 0.5);
  bench.rows(bench.unit.column[3])[2] = vec(100, 200, 300);
  const PacketVector<C> in{2, true, 1, vec(8, 16, 32)};
  const auto point = parts(transform(bench, in).vector);
  EXPECT_EQ(point[0].to_double(), -3 * 16 + 100);
  EXPECT_EQ(point[1].to_double(), 2 * 8 + 200);
  EXPECT_EQ(point[2].to_double(), 0.5 * 32 + 300);
  const auto direction = parts(transform(bench, {2, false, 1, in.vector}).vector);
  EXPECT_EQ(direction[0].to_double(), -3 * 16);
  EXPECT_EQ(direction[1].to_double(), 2 * 8);
  EXPECT_EQ(direction[2].to_double(), 0.5 * 32);
}

Real moderate(test::Random& random) {
  const auto bits = test::random_token<Real>(random).bits().to_u64() & 0x80ffff;
  return Real::from_bits(Real::Bits::from(bits | (53 + random.next() % 21) << 16));
}

/// Random products of a matrix are off by at most so many halves of a unit in the last place, of
/// the sum of the terms' magnitudes.
template <class Config>
void expect_near_the_matrix_product(double halves) {
  test::UnitBench<Transformation<Config>> bench;
  test::Random random(9);
  for (unsigned n = 0; n < 100'000; ++n) {
    const unsigned packet = test::below(random, Config::kPackets);
    const auto vector = [&random] {
      return Vec{moderate(random), moderate(random), moderate(random)};
    };
    for (auto& column : bench.unit.column) bench.rows(column)[packet] = vector();
    const PacketVector<Config> in{PacketId<Config>::from(packet), test::chance(random, 50), 3,
                                  vector()};
    bench.feed(bench.unit.vector, in);
    bench.run();
    const auto out = parts(bench.take_one(bench.unit.transformed).vector);
    for (unsigned row = 0; row < 3; ++row) {
      double sum = 0, size = 0;
      const auto add = [&](double term) { sum += term, size += std::abs(term); };
      const auto v = parts(in.vector);
      for (unsigned c = 0; c < 3; ++c) {
        add(parts(bench.rows(bench.unit.column[c])[packet])[row].to_double() * v[c].to_double());
      }
      if (in.point) add(parts(bench.rows(bench.unit.column[3])[packet])[row].to_double());
      ASSERT_NEAR(out[row].to_double(), sum, size * halves * 0x1p-17);
    }
  }
}

TEST(Transformation, IsTheMatrixProductUpToThreeRoundings) {
  expect_near_the_matrix_product<C>(3.1);
}
TEST(Transformation, FusedIsOffByOneRoundingAndWhatTheTermsLose) {
  expect_near_the_matrix_product<Fused>(1.5);
}

}  // namespace
}  // namespace dynrt
