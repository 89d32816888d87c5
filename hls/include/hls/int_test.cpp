// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// uint and sint against arithmetic on 128-bit integers: result widths at compile time, values for
// every pair of small widths and random pairs of larger ones.
#include "hls/int.h"

#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

#include "hls/random.h"

namespace {

using hls::sint;
using hls::uint;
using hls::testing::Random;
using Big = __int128;

template <class A, class B>
constexpr bool same = std::is_same_v<A, B>;

static_assert(same<decltype(uint<8>{} + uint<5>{}), uint<9>>);
static_assert(same<decltype(uint<8>{} - uint<5>{}), sint<9>>);
static_assert(same<decltype(uint<5>{} - uint<8>{}), sint<9>>);
static_assert(same<decltype(uint<8>{} * uint<5>{}), uint<13>>);
static_assert(same<decltype(uint<8>{} / uint<5>{}), uint<8>>);
static_assert(same<decltype(uint<5>{} / uint<8>{}), uint<5>>);
static_assert(same<decltype(sint<8>{} + sint<5>{}), sint<9>>);
static_assert(same<decltype(sint<5>{} - sint<8>{}), sint<9>>);
static_assert(same<decltype(sint<8>{} * sint<5>{}), sint<13>>);
static_assert(same<decltype(uint<8>{} << uint<5>{}), uint<8>>);
static_assert(same<decltype(uint<8>{} >> uint<64>{}), uint<8>>);
static_assert(same<decltype(concat(uint<3>{}, uint<4>{})), uint<7>>);
static_assert(same<decltype(next(uint<3>{})), uint<3>>);
static_assert(same<decltype(count_leading_zeros(uint<16>{})), uint<5>>);
static_assert(same<decltype(count_leading_zeros(uint<15>{})), uint<4>>);
static_assert(same<decltype(uint<7>{}.to_signed()), sint<8>>);
static_assert(same<decltype(uint<7>{}.as_signed()), sint<7>>);
static_assert(same<decltype(sint<7>{}.as_unsigned()), uint<7>>);

// Widening is implicit, narrowing and mixing are not.
static_assert(std::is_convertible_v<uint<7>, uint<8>>);
static_assert(!std::is_convertible_v<uint<8>, uint<7>>);
static_assert(std::is_convertible_v<sint<7>, sint<8>>);
static_assert(!std::is_convertible_v<sint<8>, sint<7>>);
static_assert(!std::is_convertible_v<uint<7>, sint<8>>);
static_assert(!std::is_convertible_v<sint<7>, uint<8>>);
static_assert(!std::is_convertible_v<uint<8>, int>);
static_assert(std::is_convertible_v<bool, uint<1>>);

static_assert(hls::index_width(1) == 1 && hls::index_width(2) == 1 && hls::index_width(3) == 2);
static_assert(hls::index_width(64) == 6 && hls::index_width(65) == 7);
static_assert(uint<8>(255).raw() == 255 && sint<8>(-128).raw() == -128);

template <unsigned W>
Big value(uint<W> u) {
  return static_cast<Big>(static_cast<unsigned __int128>(u.raw()));
}
template <unsigned W>
Big value(sint<W> s) {
  return static_cast<Big>(s.raw());
}
/// The low W bits of a number.
Big low_bits(Big v, unsigned w) { return v & ((Big{1} << w) - 1); }

/// Everything that two operands of A and B bits (at most 60) can do.
template <unsigned A, unsigned B>
void check_pair(unsigned long long a, unsigned long long b) {
  const auto x = uint<A>::from(a);
  const auto y = uint<B>::from(b);
  ASSERT_EQ(value(x), static_cast<Big>(a));
  ASSERT_TRUE(value(x + y) == value(x) + value(y)) << A << ' ' << B << ' ' << a << ' ' << b;
  ASSERT_TRUE(value(x - y) == value(x) - value(y)) << A << ' ' << B << ' ' << a << ' ' << b;
  ASSERT_TRUE(value(x * y) == value(x) * value(y)) << A << ' ' << B << ' ' << a << ' ' << b;
  if (b != 0) ASSERT_TRUE(value(x / y) == value(x) / value(y)) << a << ' ' << b;
  ASSERT_TRUE(value(concat(x, y)) == (value(x) << B) + value(y)) << a << ' ' << b;
  ASSERT_TRUE(value(x << y) == (b < A ? low_bits(value(x) << b, A) : 0)) << A << a << ' ' << b;
  ASSERT_TRUE(value(x >> y) == (b < A ? value(x) >> b : 0)) << A << ' ' << a << ' ' << b;
  ASSERT_EQ(y.reaches(A), b >= A) << A << ' ' << b;
  constexpr unsigned kWide = hls::max_width(A, B);
  const uint<kWide> p = x;
  const uint<kWide> q = y;
  ASSERT_EQ(p == q, a == b);
  ASSERT_EQ(p != q, a != b);
  ASSERT_EQ(p < q, a < b);
  ASSERT_EQ(p <= q, a <= b);
  ASSERT_EQ(p > q, a > b);
  ASSERT_EQ(p >= q, a >= b);
  ASSERT_EQ((p & q).to_u64(), a & b);
  ASSERT_EQ((p | q).to_u64(), a | b);
  ASSERT_EQ((p ^ q).to_u64(), a ^ b);
  ASSERT_EQ(select(a < b, p, q).to_u64(), a < b ? a : b);
  ASSERT_TRUE(value(~x) == low_bits(~value(x), A));
  ASSERT_TRUE(value(next(x)) == low_bits(value(x) + 1, A));
  ASSERT_TRUE(value(x.to_signed()) == value(x));
  unsigned zeros = 0;
  while (zeros < A && !x.bit(A - 1 - zeros)) ++zeros;
  ASSERT_EQ(count_leading_zeros(x).to_u64(), zeros) << A << ' ' << a;
  ASSERT_EQ(x.template bit<A - 1>(), (a >> (A - 1)) != 0);
  ASSERT_EQ((x.template bits<A - 1, A / 2>().to_u64()), a >> (A / 2));
  ASSERT_EQ((x.template bits<A / 2, 0>().to_u64()), a & ((2ull << (A / 2)) - 1));
  ASSERT_EQ(x.template trunc<(A + 1) / 2>().to_u64(), a & ((1ull << ((A + 1) / 2)) - 1));
  ASSERT_TRUE(value(x.template zext<A + 3>()) == value(x));

  if constexpr (A >= 2 && B >= 2) {
    const sint<A> s = x.as_signed();
    const sint<B> t = y.as_signed();
    const Big sign = value(x) >= (Big{1} << (A - 1)) ? Big{1} << A : 0;
    ASSERT_TRUE(value(s) == value(x) - sign);
    ASSERT_TRUE(s.as_unsigned() == x);
    ASSERT_EQ(s.negative(), sign != 0);
    ASSERT_TRUE(value(s + t) == value(s) + value(t)) << A << ' ' << B << ' ' << a << ' ' << b;
    ASSERT_TRUE(value(s - t) == value(s) - value(t)) << A << ' ' << B << ' ' << a << ' ' << b;
    ASSERT_TRUE(value(s * t) == value(s) * value(t)) << A << ' ' << B << ' ' << a << ' ' << b;
    const sint<kWide> m = s;
    const sint<kWide> n = t;
    ASSERT_EQ(m == n, value(s) == value(t));
    ASSERT_EQ(m != n, value(s) != value(t));
    ASSERT_EQ(m < n, value(s) < value(t));
    ASSERT_EQ(m <= n, value(s) <= value(t));
    ASSERT_EQ(m > n, value(s) > value(t));
    ASSERT_EQ(m >= n, value(s) >= value(t));
    ASSERT_EQ(s.to_s64(), static_cast<long long>(value(s)));
    ASSERT_TRUE(value(s.template trunc<2>()) == ((value(s) & 3) ^ 2) - 2);
  }
}

template <unsigned A, unsigned B>
void check_all() {
  for (unsigned a = 0; a < 1u << A; ++a) {
    for (unsigned b = 0; b < 1u << B; ++b) {
      ASSERT_NO_FATAL_FAILURE((check_pair<A, B>(a, b)));
    }
  }
}
TEST(Int, EveryPairOfSmallWidths) {
  [&]<unsigned... I>(std::integer_sequence<unsigned, I...>) {
    (check_all<I / 6 + 1, I % 6 + 1>(), ...);
  }(std::make_integer_sequence<unsigned, 36>{});
}

template <unsigned A, unsigned B>
void check_random(Random& random) {
  for (int i = 0; i < 20'000; ++i) {
    // Short numbers are as likely as long ones, so that shifts stay within the width at times.
    const auto draw = [&](unsigned width) {
      return random.next() >> (64 - width) >> random.below(width);
    };
    ASSERT_NO_FATAL_FAILURE((check_pair<A, B>(draw(A), draw(B))));
  }
}
TEST(Int, RandomPairsOfLargerWidths) {
  Random random(7);
  check_random<8, 8>(random);
  check_random<16, 5>(random);
  check_random<17, 17>(random);
  check_random<24, 33>(random);
  check_random<32, 32>(random);
  check_random<33, 7>(random);
  check_random<60, 60>(random);
}

TEST(Int, HoldsAHundredAndTwentyEightBits) {
  const auto high = uint<64>::from(0x0123456789abcdef);
  const auto low = uint<64>::from(0xfedcba9876543210);
  const uint<128> both = concat(high, low);
  EXPECT_TRUE((both.bits<127, 64>() == high));
  EXPECT_TRUE(both.trunc<64>() == low);
  EXPECT_TRUE((both.shr<64>() == uint<128>(high)));
  EXPECT_TRUE((uint<128>(high).shl<64>() | uint<128>(low)) == both);
  EXPECT_TRUE((both >> uint<8>(128)) == uint<128>(0));
  EXPECT_EQ(count_leading_zeros(both).to_u64(), 7u);
  EXPECT_TRUE(~uint<128>::ones() == uint<128>(0));
}

}  // namespace
