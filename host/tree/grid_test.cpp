// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host/format/memory_format_of.h"

namespace dynrt::host {
namespace {

template <class R>
class GridOf : public testing::Test {
 protected:
  static constexpr const MemoryFormat& kFormat = kMemoryFormatOf<R>;
  static constexpr Grid kGrid{kFormat};
};

using Floats = testing::Types<hls::Float<7, 16>, hls::Float<5, 8>, hls::Float<6, 12>,
                              hls::Float<7, 10>, hls::Float<5, 23>, hls::Float<8, 23>>;
TYPED_TEST_SUITE(GridOf, Floats);

TYPED_TEST(GridOf, AscendsAndHoldsNumbersOfTheFormat) {
  const Grid& grid = this->kGrid;
  for (Code code = grid.min_code(); code < grid.max_code(); code += 97) {
    const double x = grid.value(code);
    ASSERT_LT(x, grid.value(code + 1)) << code;
    ASSERT_EQ(this->kFormat.round(x), x) << code;
  }
}

TYPED_TEST(GridOf, FloorAndCeilEncloseTightly) {
  const Grid& grid = this->kGrid;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-2, 2);
  std::uniform_int_distribution<int> exponent(-70, 63);
  for (int i = 0; i < 300'000; ++i) {
    const double x = std::ldexp(mantissa(random), exponent(random));
    if (!(std::abs(x) <= grid.largest())) continue;
    const Code below = grid.floor(x);
    const Code above = grid.ceil(x);
    ASSERT_LE(grid.value(below), x);
    ASSERT_GE(grid.value(above), x);
    ASSERT_LE(above - below, 1);
    ASSERT_EQ(above == below, grid.value(below) == x);
  }
}

TYPED_TEST(GridOf, GivesEveryCodeAsItsOwnFloorAndCeil) {
  const Grid& grid = this->kGrid;
  for (Code code = grid.min_code(); code <= grid.max_code(); code += 13) {
    ASSERT_EQ(grid.floor(grid.value(code)), code);
    ASSERT_EQ(grid.ceil(grid.value(code)), code);
  }
}

TYPED_TEST(GridOf, HasZeroBetweenItsSmallestNumbers) {
  const Grid& grid = this->kGrid;
  for (const double x : {0.0, -0.0, 1e-30, -1e-30}) {
    EXPECT_EQ(grid.floor(x), -1) << x;
    EXPECT_EQ(grid.ceil(x), 0) << x;
  }
}

TEST(Grid, IsNoFinerAndNoWiderThanThatOfTheShippedFormat) {
  EXPECT_EQ(Grid(kShippedFormat), Grid());
  EXPECT_EQ(Grid().smallest(), kShippedFormat.smallest);
  EXPECT_EQ(Grid().largest(), kShippedFormat.largest);
  EXPECT_EQ(Grid(kMemoryFormatOf<hls::Float<8, 23>>), Grid());
  const MemoryFormat& narrow = kMemoryFormatOf<hls::Float<5, 8>>;
  EXPECT_EQ(Grid(narrow).smallest(), narrow.smallest);
  EXPECT_EQ(Grid(narrow).largest(), narrow.largest);
  EXPECT_EQ(Grid(narrow).max_code(), (1 << 13) - 1);
}

}  // namespace
}  // namespace dynrt::host
