// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Exact products of floats and the difference of two of them, rounded once, against MPFR.
#include <gtest/gtest.h>

#include <cstdint>

#include "hls/float_patterns.h"
#include "hls/random.h"

namespace {

using hls::Float;
using hls::Rounding;
using hls::testing::FloatJudge;
using hls::testing::from_pattern;
using hls::testing::judge_of;
using hls::testing::pattern;
using hls::testing::Random;

/// The exact product of a pair and the rounded difference of two products, natively and by the
/// circuit.
template <class F, class To>
bool wide_agrees(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
  using Wide = typename F::Product;
  static thread_local FloatJudge judge = judge_of<F>();
  static thread_local FloatJudge wide = judge_of<Wide>();
  static thread_local FloatJudge to = judge_of<To>();
  const Wide first = exact_product(from_pattern<F>(a), from_pattern<F>(b));
  const Wide second = exact_product(from_pattern<F>(c), from_pattern<F>(d));
  const std::uint64_t x = wide.product_of(judge, a, b);
  const std::uint64_t y = wide.product_of(judge, c, d);
  const std::uint64_t difference = to.difference_of(wide, x, y);
  const auto by_circuit =
      Wide::Circuit::template sum_to<typename To::Circuit>(first.bits(), (-second).bits());
  const bool agrees =
      pattern(first) == x && pattern(second) == y &&
      F::Circuit::exact_product(F::Bits::from(a), F::Bits::from(b)).to_u64() == x &&
      first.to_double() == from_pattern<F>(a).to_double() * from_pattern<F>(b).to_double() &&
      pattern(To::of_difference(first, second)) == difference && by_circuit.to_u64() == difference;
  if (agrees) return true;
  ADD_FAILURE() << std::hex << "0x" << a << " * 0x" << b << " - 0x" << c << " * 0x" << d << " is 0x"
                << pattern(To::of_difference(first, second)) << ", by the circuit 0x"
                << by_circuit.to_u64() << "; MPFR says 0x" << difference;
  return false;
}

template <class F>
class Products : public ::testing::Test {};
using ProductFormats =
    ::testing::Types<Float<2, 2>, Float<3, 3>, Float<5, 8>, Float<7, 16>, Float<8, 20>,
                     Float<8, 23>, Float<8, 25>, Float<2, 2, Rounding::kTruncate>,
                     Float<7, 16, Rounding::kTruncate>, Float<8, 25, Rounding::kTruncate>>;
TYPED_TEST_SUITE(Products, ProductFormats);

TYPED_TEST(Products, AreExactAndTheirDifferenceIsRoundedOnce) {
  using F = TypeParam;
  using Longer = Float<F::kExponentBits + 2, F::kMantissaBits, F::kRounding>;
  constexpr unsigned kBits = F::kLeafWidth;
  constexpr std::uint64_t kMask = ~0ull >> (64 - kBits);
  Random random(kBits);
  for (int i = 0; i < 200'000; ++i) {
    const std::uint64_t a = random.next() & kMask;
    const std::uint64_t b = random.next() & kMask;
    std::uint64_t c = random.next() & kMask;
    std::uint64_t d = random.next() & kMask;
    switch (random.below(4)) {
      case 0:  // cancelling, to nothing or nearly
        c = (b + random.below(3) - 1) & kMask;
        d = a;
        break;
      case 1:  // half way between two numbers, but for what lies far behind
        c = (a & ~(kMask >> 2)) | (c & (kMask >> 3));
        break;
      default:
        break;
    }
    ASSERT_TRUE((wide_agrees<F, F>(a, b, c, d)));
    ASSERT_TRUE((wide_agrees<F, Longer>(a, b, c, d)));
  }
}

TEST(ExactProducts, EveryFourShortNumbers) {
  using F = Float<2, 2>;
  for (std::uint64_t i = 0; i < 1u << (4 * F::kLeafWidth); ++i) {
    constexpr std::uint64_t kMask = (1u << F::kLeafWidth) - 1;
    ASSERT_TRUE((wide_agrees<F, F>(i & kMask, i >> 5 & kMask, i >> 10 & kMask, i >> 15)));
  }
}

/// A double of the difference would lie half way between two numbers.
TEST(ExactProducts, ADifferenceIsNotRoundedTwice) {
  using F = Float<7, 16>;
  const F one = F::one();
  const F half_step = F::from_double(0x1p-17);
  const F tiny = F::from_double(0x1p-60);
  const auto tie = exact_product(F::from_double(1 + 0x1p-16), F::from_double(1 + 0x1p-16));
  const auto difference =
      F::of_difference(exact_product(one, F::from_double(1.5)),
                       F::Product::from_double(half_step.to_double() + 0x1p-33));
  EXPECT_EQ(difference.to_double(), 1.5 - 0x1p-16);
  // 1 + 2^-15 + 2^-32 has its half way points at odd multiples of 2^-17.
  EXPECT_EQ(F::of_difference(tie, exact_product(tiny, tiny)).to_double(), 1 + 0x1p-15);
  EXPECT_EQ(
      F::of_difference(F::Product::from_double(1 + 0x1p-17), exact_product(tiny, one)).to_double(),
      1.0);
  EXPECT_EQ(
      F::of_difference(F::Product::from_double(1 + 0x1p-17), exact_product(tiny, -one)).to_double(),
      1 + 0x1p-16);
}

}  // namespace
