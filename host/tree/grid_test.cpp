// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "units/memory_format.h"

namespace dynrt::host {
namespace {

TEST(Grid, CodesAscendAndAreTheFloatsOfTheCore) {
  for (Code code = kMinCode; code < kMaxCode; code += 97) {
    ASSERT_LT(grid_value(code), grid_value(code + 1)) << code;
    const Real real = Real::from_double(grid_value(code));
    ASSERT_EQ(real.to_double(), grid_value(code)) << code;
  }
  EXPECT_EQ(grid_smallest(), std::ldexp(1.0, -63));
  EXPECT_EQ(grid_largest(), Real::largest().to_double());
}

TEST(Grid, FloorAndCeilEncloseTightly) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-2, 2);
  std::uniform_int_distribution<int> exponent(-70, 63);
  for (int i = 0; i < 1000000; ++i) {
    const double x = std::ldexp(mantissa(random), exponent(random));
    const Code below = floor_code(x);
    const Code above = ceil_code(x);
    ASSERT_LE(grid_value(below), x);
    ASSERT_GE(grid_value(above), x);
    ASSERT_LE(above - below, 1);
    ASSERT_EQ(above == below, grid_value(below) == x);
  }
}

TEST(Grid, EveryCodeIsItsOwnFloorAndCeil) {
  for (Code code = kMinCode; code <= kMaxCode; code += 13) {
    ASSERT_EQ(floor_code(grid_value(code)), code);
    ASSERT_EQ(ceil_code(grid_value(code)), code);
  }
}

TEST(Grid, ZeroLiesBetweenTheSmallestNumbers) {
  EXPECT_EQ(floor_code(0.0), -1);
  EXPECT_EQ(ceil_code(0.0), 0);
  EXPECT_EQ(floor_code(-0.0), -1);
  EXPECT_EQ(floor_code(1e-30), -1);
  EXPECT_EQ(ceil_code(1e-30), 0);
  EXPECT_EQ(floor_code(-1e-30), -1);
  EXPECT_EQ(ceil_code(-1e-30), 0);
}

}  // namespace
}  // namespace dynrt::host
