// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Conversions of floats from doubles, integers and other formats against MPFR; the constants.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "hls/float_patterns.h"
#include "hls/random.h"

namespace {

using hls::Float;
using hls::Rounding;
using hls::testing::circuit_convert;
using hls::testing::FloatJudge;
using hls::testing::from_pattern;
using hls::testing::judge_of;
using hls::testing::pattern;
using hls::testing::Random;

template <class F>
void check_doubles() {
  FloatJudge judge = judge_of<F>();
  Random random(1);
  const auto check = [&](double d) {
    ASSERT_EQ(pattern(F::from_double(d)), judge.from_double(d)) << std::hexfloat << d;
  };
  for (double d :
       {0.0, -0.0, 1.0, -1.0, 0.5, 1e-300, -1e-300, 1e300, -1e300, 0x1p-63, 0x1.fffffp64,
        std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::max()}) {
    check(d);
  }
  for (int i = 0; i < 500'000; ++i) {
    const double any = std::bit_cast<double>(random.next());
    if (std::isfinite(any)) check(any);
    // Within the format's range, half of them at most two bits longer than its mantissa: ties.
    const double long_one = 1 + static_cast<double>(random.next() >> 12) * 0x1p-52;
    const double short_one = 1 + static_cast<double>(random.below(4u << F::kMantissaBits)) /
                                     static_cast<double>(4u << F::kMantissaBits);
    const int exponent = static_cast<int>(random.below(4 + 2 * F::kBias)) - F::kBias - 2;
    check(std::ldexp(long_one, exponent));
    check(-std::ldexp(short_one, exponent));
    const float single = static_cast<float>(std::ldexp(long_one, exponent));
    ASSERT_EQ(pattern(F::from_float(single)), judge.from_double(single));
  }
}
TEST(Conversion, DoublesToNearestEven) { check_doubles<Float<7, 16>>(); }
TEST(Conversion, DoublesTruncated) { check_doubles<Float<7, 16, Rounding::kTruncate>>(); }
TEST(Conversion, DoublesToAShortFormat) { check_doubles<Float<4, 5>>(); }

TEST(Conversion, InfinitiesAndNansSaturate) {
  using F = Float<7, 16>;
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(F::from_double(infinity), F::largest());
  EXPECT_EQ(F::from_double(-infinity), -F::largest());
  EXPECT_EQ(abs(F::from_double(std::nan(""))), F::largest());
}

TEST(Conversion, Integers) {
  using F = Float<7, 16>;
  FloatJudge judge = judge_of<F>();
  Random random(2);
  for (int i = 0; i < 500'000; ++i) {
    const std::uint64_t value = random.next() >> random.below(64);
    ASSERT_EQ(pattern(F::from_uint(hls::uint<64>::from(value))), judge.from_uint(value)) << value;
    const std::uint64_t low = value & 0x1ffff;
    ASSERT_EQ(pattern(F::from_uint(hls::uint<17>::from(low))), judge.from_uint(low)) << low;
    ASSERT_EQ(F::Circuit::from_uint(hls::uint<17>::from(low)).to_u64(), judge.from_uint(low))
        << low;
  }
  EXPECT_EQ(F::from_uint(hls::uint<64>(0)), F::smallest());
}

TEST(Conversion, BetweenTheCoresFormats) {
  using Wide = Float<8, 23>;
  using F = Float<7, 16>;
  FloatJudge wide = judge_of<Wide>();
  FloatJudge judge = judge_of<F>();
  Random random(3);
  for (int i = 0; i < 500'000; ++i) {
    const std::uint64_t bits = random.next() >> 32;
    ASSERT_EQ(pattern(F(from_pattern<Wide>(bits))), judge.convert(wide, bits)) << std::hex << bits;
    ASSERT_EQ(circuit_convert<F>(from_pattern<Wide>(bits)), judge.convert(wide, bits)) << bits;
    const F f = from_pattern<F>(bits & 0xffffff);
    ASSERT_EQ(Wide(f).to_double(), f.to_double());
    ASSERT_EQ(F(Wide(f)), f);
  }
}

TEST(Constants, AreWhatTheyAreCalled) {
  using F = Float<7, 16>;
  EXPECT_EQ(F::one().to_double(), 1.0);
  EXPECT_EQ(F::smallest().to_double(), 0x1p-63);
  EXPECT_EQ(F::largest().to_double(), 0x1.ffffp64);
  EXPECT_EQ(F(), F::smallest());
}

}  // namespace
