// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The reciprocals of all significands of 6 to 16 bits against their bounds, and quotients made with
// them against integer division: every pair of short significands, and for longer ones those whose
// quotient is a number, or lies closest to one or to the middle of two.
#include "hls/reciprocal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "hls/float_circuit.h"
#include "hls/random.h"

namespace {

using hls::FloatCircuit;
using hls::Rounding;
using hls::SignificandReciprocal;

template <class T>
class Significands : public ::testing::Test {};

template <unsigned M>
using Bits = std::integral_constant<unsigned, M>;
using Widths = ::testing::Types<Bits<6>, Bits<7>, Bits<8>, Bits<9>, Bits<10>, Bits<11>, Bits<12>,
                                Bits<13>, Bits<14>, Bits<15>, Bits<16>>;
TYPED_TEST_SUITE(Significands, Widths);

/// x / y for significands in [2^M, 2^(M+1)), as the pattern of the quotient of numbers in [1, 2).
template <unsigned M, Rounding R>
std::uint64_t expected(std::uint64_t x, std::uint64_t y) {
  const bool below = x < y;
  const std::uint64_t halves = (below ? 2 * x : x) * (std::uint64_t{2} << M) / y;
  const std::uint64_t significand = (halves + (R == Rounding::kNearestEven ? 1 : 0)) / 2;
  const std::uint64_t exponent =
      static_cast<std::uint64_t>(FloatCircuit<7, M, R>::kBias) - (below ? 1 : 0);
  return (exponent << M) + significand - (std::uint64_t{1} << M);
}

template <unsigned M, Rounding R>
bool divides(std::uint64_t x, std::uint64_t y) {
  using Circuit = FloatCircuit<7, M, R>;
  const auto number = [](std::uint64_t significand) {
    return Circuit::Bits::from((static_cast<std::uint64_t>(Circuit::kBias) << M) + significand -
                               (std::uint64_t{1} << M));
  };
  const std::uint64_t got = Circuit::quotient(number(x), number(y)).to_u64();
  const std::uint64_t want = expected<M, R>(x, y);
  EXPECT_EQ(got, want) << x << " / " << y << ", significands of " << M << " bits";
  return got == want;
}

TYPED_TEST(Significands, HaveAReciprocalWithinItsBounds) {
  constexpr unsigned M = TypeParam::value;
  using Reciprocal = SignificandReciprocal<M>;
  double worst = 0;
  for (std::uint64_t y = std::uint64_t{1} << M; y < std::uint64_t{2} << M; ++y) {
    const std::uint64_t r = Reciprocal::below(hls::uint<M + 1>::from(y)).to_u64();
    const std::uint64_t one = std::uint64_t{1} << (M + Reciprocal::kFractionBits);
    ASSERT_LT(r * y, one) << y;
    const double error = static_cast<double>(one - r * y) / static_cast<double>(one);
    worst = std::max(worst, error * static_cast<double>(std::uint64_t{2} << M));
    ASSERT_LT(worst, Reciprocal::kError) << y;
  }
  EXPECT_GT(worst, 0.9) << "the bound could be narrower";
}

/// 1 / 2^n modulo an odd number.
std::uint64_t halved(std::uint64_t odd, unsigned n) {
  std::uint64_t inverse = 1 % odd;
  for (unsigned i = 0; i < n; ++i) inverse = (inverse % 2 == 0 ? inverse : inverse + odd) / 2;
  return inverse;
}

struct Dividend {
  std::uint64_t x;         ///< a significand
  std::uint64_t in_range;  ///< x or 2 x, so that its quotient by y lies in [1, 2)
};

/// The dividends whose quotient by y lies rest 2^k / y half units of its last place above a number
/// of M bits or the middle of two, where 2^k is the greatest power of two in y.
std::vector<Dividend> dividends(unsigned M, std::uint64_t y, int rest) {
  const unsigned k = static_cast<unsigned>(std::countr_zero(y));
  const std::uint64_t odd = y >> k;
  // With d in the range, d 2^(M + 1) = rest 2^k modulo y, so d 2^(M + 1 - k) = rest modulo odd.
  const auto positive = static_cast<std::uint64_t>(rest + static_cast<std::int64_t>(odd));
  std::vector<Dividend> found;
  for (std::uint64_t d = y + positive * halved(odd, M + 1 - k) % odd; d < 2 * y; d += odd) {
    if (d >> (M + 1) == 0) {
      found.push_back({d, d});
    } else if (d % 2 == 0) {
      found.push_back({d / 2, d});
    }
  }
  return found;
}

TYPED_TEST(Significands, DivideBesideNumbersAndMiddles) {
  constexpr unsigned M = TypeParam::value;
  constexpr std::uint64_t kHidden = std::uint64_t{1} << M;
  std::uint64_t cases[2][2] = {};  // below and above a number, below and above a middle
  for (std::uint64_t y = kHidden; y < 2 * kHidden; ++y) {
    if (y % 8 == 0) continue;  // its quotients are farther apart
    for (const int rest : {-2, -1, 1, 2}) {
      for (const auto [x, in_range] : dividends(M, y, rest)) {
        const std::uint64_t halves = (in_range << (M + 1)) / y;
        const std::uint64_t above = (in_range << (M + 1)) % y;  // in half units / y
        const bool is_above = above < y / 2;
        const std::uint64_t apart = is_above ? above : y - above;
        ASSERT_TRUE(apart >= 1 && apart <= 8) << x << " / " << y;
        ++cases[(halves + (is_above ? 0 : 1)) % 2][is_above ? 1 : 0];
        ASSERT_TRUE((divides<M, Rounding::kNearestEven>(x, y)));
        ASSERT_TRUE((divides<M, Rounding::kTruncate>(x, y)));
      }
    }
  }
  for (const auto& side : cases) {
    for (const std::uint64_t count : side) EXPECT_GT(count, kHidden * 9 / 10);
  }
}

TYPED_TEST(Significands, DivideExactly) {
  constexpr unsigned M = TypeParam::value;
  constexpr std::uint64_t kHidden = std::uint64_t{1} << M;
  std::uint64_t cases = 0;
  for (std::uint64_t y = kHidden; y < 2 * kHidden; ++y) {
    for (const auto [x, in_range] : dividends(M, y, 0)) {
      ASSERT_EQ((in_range << M) % y, 0u) << x << " / " << y;
      ++cases;
      ASSERT_TRUE((divides<M, Rounding::kNearestEven>(x, y)));
      ASSERT_TRUE((divides<M, Rounding::kTruncate>(x, y)));
    }
  }
  EXPECT_GT(cases, 2 * kHidden);
}

TYPED_TEST(Significands, DivideAndRound) {
  constexpr unsigned M = TypeParam::value;
  hls::testing::Random random(M);
  const std::uint64_t hidden = std::uint64_t{1} << M;
  for (std::uint64_t y = hidden; y < 2 * hidden; ++y) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint64_t x = hidden + random.next() % hidden;
      ASSERT_TRUE((divides<M, Rounding::kNearestEven>(x, y)));
      ASSERT_TRUE((divides<M, Rounding::kTruncate>(x, y)));
    }
  }
}

template <unsigned M, Rounding R>
void divide_all() {
  constexpr std::uint64_t kHidden = std::uint64_t{1} << M;
  for (std::uint64_t x = kHidden; x < 2 * kHidden; ++x) {
    for (std::uint64_t y = kHidden; y < 2 * kHidden; ++y) ASSERT_TRUE((divides<M, R>(x, y)));
  }
}

TEST(ShortSignificands, DivideInEveryPair) {
  divide_all<6, Rounding::kNearestEven>();
  divide_all<6, Rounding::kTruncate>();
  divide_all<9, Rounding::kNearestEven>();
  divide_all<9, Rounding::kTruncate>();
  divide_all<10, Rounding::kNearestEven>();
}

}  // namespace
