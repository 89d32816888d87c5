// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Float against MPFR: every pair of every operation for formats of up to 10 bits, ten million
// random and extreme pairs for <7, 16>, comparisons, both roundings. MPFR judges both the operators
// as the native model computes them and FloatCircuit, the hardware's.
#include "hls/float.h"

#include <gtest/gtest.h>

#include <cmath>

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

/// All operations and comparisons of one pair, natively and by the circuit; false after the first
/// difference, which it reports.
template <class F>
bool agree(FloatJudge& judge, std::uint64_t a, std::uint64_t b) {
  const F x = from_pattern<F>(a);
  const F y = from_pattern<F>(b);
  using Circuit = typename F::Circuit;
  const auto xb = F::Bits::from(a);
  const auto yb = F::Bits::from(b);
  const int order = judge.compare(a, b);
  const std::uint64_t sum = judge.add(a, b);
  const std::uint64_t product = judge.mul(a, b);
  const std::uint64_t quotient = judge.div(a, b);
  struct {
    const char* name;
    std::uint64_t got, want;
  } const checks[] = {
      {"+", pattern(x + y), sum},
      {"-", pattern(x - y), judge.sub(a, b)},
      {"*", pattern(x * y), product},
      {"/", pattern(x / y), quotient},
      {"+ (circuit)", Circuit::sum(xb, yb).to_u64(), sum},
      {"* (circuit)", Circuit::product(xb, yb).to_u64(), product},
      {"/ (circuit)", Circuit::quotient(xb, yb).to_u64(), quotient},
      {"< (circuit)", Circuit::less(xb, yb), order < 0},
      {"==", x == y, order == 0},
      {"!=", x != y, order != 0},
      {"<", x < y, order < 0},
      {"<=", x <= y, order <= 0},
      {">", x > y, order > 0},
      {">=", x >= y, order >= 0},
  };
  for (const auto& check : checks) {
    if (check.got != check.want) {
      ADD_FAILURE() << std::hex << "0x" << a << ' ' << check.name << " 0x" << b << " is 0x"
                    << check.got << ", MPFR says 0x" << check.want << std::dec << " ("
                    << judge.to_double(a) << ", " << judge.to_double(b) << ')';
      return false;
    }
  }
  return true;
}

/// The square root, natively and by the circuit.
template <class F>
bool root_agrees(FloatJudge& judge, std::uint64_t a) {
  const std::uint64_t native = pattern(sqrt(from_pattern<F>(a)));
  const std::uint64_t circuit = F::Circuit::root(F::Bits::from(a)).to_u64();
  const std::uint64_t want = judge.sqrt(a);
  if (native == want && circuit == want) return true;
  ADD_FAILURE() << std::hex << "the root of 0x" << a << " is 0x" << native << ", by the circuit 0x"
                << circuit << "; MPFR says 0x" << want;
  return false;
}

template <class F>
class AllPairs : public ::testing::Test {};

using Formats =
    ::testing::Types<Float<2, 7>, Float<3, 6>, Float<4, 5>, Float<5, 4>, Float<6, 3>, Float<7, 2>,
                     Float<2, 2>, Float<3, 3>, Float<4, 4>, Float<2, 7, Rounding::kTruncate>,
                     Float<3, 6, Rounding::kTruncate>, Float<4, 5, Rounding::kTruncate>,
                     Float<5, 4, Rounding::kTruncate>, Float<6, 3, Rounding::kTruncate>,
                     Float<7, 2, Rounding::kTruncate>, Float<2, 2, Rounding::kTruncate>,
                     Float<3, 3, Rounding::kTruncate>, Float<4, 4, Rounding::kTruncate>>;
TYPED_TEST_SUITE(AllPairs, Formats);

TYPED_TEST(AllPairs, EveryOperation) {
  FloatJudge judge = judge_of<TypeParam>();
  constexpr std::uint64_t kPatterns = 1u << TypeParam::kLeafWidth;
  std::uint64_t pairs = 0;
  for (std::uint64_t a = 0; a < kPatterns; ++a) {
    for (std::uint64_t b = 0; b < kPatterns; ++b) {
      ASSERT_TRUE(agree<TypeParam>(judge, a, b));
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, kPatterns * kPatterns);
}

TYPED_TEST(AllPairs, EveryRoot) {
  FloatJudge judge = judge_of<TypeParam>();
  for (std::uint64_t a = 0; a < 1u << TypeParam::kLeafWidth; ++a) {
    ASSERT_TRUE(root_agrees<TypeParam>(judge, a));
  }
}

TYPED_TEST(AllPairs, EveryPatternToDoubleAndBack) {
  FloatJudge judge = judge_of<TypeParam>();
  for (std::uint64_t a = 0; a < 1u << TypeParam::kLeafWidth; ++a) {
    const TypeParam x = from_pattern<TypeParam>(a);
    ASSERT_EQ(x.to_double(), judge.to_double(a)) << std::hex << a;
    ASSERT_EQ(pattern(TypeParam::from_double(x.to_double())), a);
    ASSERT_EQ(pattern(TypeParam::from_float(static_cast<float>(x.to_double()))), a);
    ASSERT_EQ((-x).to_double(), -x.to_double());
    ASSERT_EQ(abs(x).to_double(), std::fabs(x.to_double()));
    ASSERT_EQ(x.sign(), std::signbit(x.to_double()));
    ASSERT_EQ(pattern(x), a);
  }
}

TYPED_TEST(AllPairs, EveryPatternOfOtherFormats) {
  FloatJudge judge = judge_of<TypeParam>();
  const auto convert_all = [&]<class From>(std::type_identity<From>) {
    FloatJudge other = judge_of<From>();
    for (std::uint64_t a = 0; a < 1u << From::kLeafWidth; ++a) {
      const std::uint64_t want = judge.convert(other, a);
      ASSERT_EQ(pattern(TypeParam(from_pattern<From>(a))), want) << std::hex << a;
      ASSERT_EQ(circuit_convert<TypeParam>(from_pattern<From>(a)), want) << std::hex << a;
    }
  };
  convert_all(std::type_identity<Float<2, 8>>{});
  convert_all(std::type_identity<Float<3, 3>>{});
  convert_all(std::type_identity<Float<5, 8>>{});
  convert_all(std::type_identity<Float<8, 5, Rounding::kTruncate>>{});
}

TYPED_TEST(AllPairs, EveryIntegerOfSixteenBits) {
  FloatJudge judge = judge_of<TypeParam>();
  for (unsigned i = 0; i < 1u << 16; ++i) {
    const auto integer = hls::uint<16>::from(i);
    ASSERT_EQ(pattern(TypeParam::from_uint(integer)), judge.from_uint(i)) << i;
    ASSERT_EQ(TypeParam::Circuit::from_uint(integer).to_u64(), judge.from_uint(i)) << i;
  }
  for (unsigned i = 0; i < 2; ++i) {
    ASSERT_EQ(pattern(TypeParam::from_uint(hls::uint<1>::from(i))), judge.from_uint(i)) << i;
  }
}

/// Patterns of <7, 16>: random ones, and such that meet the corners of rounding, cancelling and
/// saturating.
struct Pair {
  std::uint64_t a, b;
};
Pair random_pair(Random& random) {
  constexpr std::uint64_t kMantissas[] = {0,      1,      2,      3,      0x7fff, 0x8000,
                                          0x8001, 0x5555, 0xaaaa, 0xfffe, 0xffff};
  constexpr std::uint64_t kExponents[] = {0, 1, 2, 62, 63, 64, 125, 126, 127};
  const auto join = [](std::uint64_t sign, std::uint64_t exponent, std::uint64_t mantissa) {
    return (sign & 1) << 23 | (exponent & 0x7f) << 16 | (mantissa & 0xffff);
  };
  const auto mantissa = [&] {
    return random.below(2) ? random.next() : kMantissas[random.below(std::size(kMantissas))];
  };
  const std::uint64_t a = random.next() & 0xffffff;
  switch (random.below(6)) {
    case 0:  // exponents so near that the mantissas meet
      return {a, join(random.next(), (a >> 16) + random.below(41) - 20, mantissa())};
    case 1:  // cancelling
      return {a, (a ^ 0x800000) + random.below(9) - 4};
    case 2:  // extreme in every part
      return {join(random.next(), kExponents[random.below(std::size(kExponents))], mantissa()),
              join(random.next(), kExponents[random.below(std::size(kExponents))], mantissa())};
    case 3:  // product or quotient about one, the smallest and the largest number
      return {
          join(random.next(), random.below(128), mantissa()),
          join(random.next(), 63 * random.below(4) - (a >> 16) + random.below(5) - 2, mantissa())};
    case 4:  // short mantissas: exact results and ties
      return {a & ~0xffull, random.next() & 0xffffff & ~0xffull};
    default:
      return {a, random.next() & 0xffffff};
  }
}

constexpr unsigned kShards = 10;
constexpr std::uint64_t kPairsPerShard = 1'000'000;

class Pairs : public ::testing::TestWithParam<unsigned> {};

template <class F>
void run_pairs(unsigned shard) {
  FloatJudge judge = judge_of<F>();
  Random random(0xd1a0'0000u + shard);
  std::uint64_t pairs = 0;
  for (; pairs < kPairsPerShard; ++pairs) {
    const Pair p = random_pair(random);
    ASSERT_TRUE(agree<F>(judge, p.a & 0xffffff, p.b & 0xffffff));
  }
  EXPECT_EQ(pairs, kPairsPerShard);
}
TEST_P(Pairs, NearestEven) { run_pairs<Float<7, 16>>(GetParam()); }
TEST_P(Pairs, Truncate) { run_pairs<Float<7, 16, Rounding::kTruncate>>(kShards + GetParam()); }
INSTANTIATE_TEST_SUITE_P(Shard, Pairs, ::testing::Range(0u, kShards));

/// A root's digits depend on the mantissa and on whether the exponent is odd.
template <class F>
void check_roots() {
  FloatJudge judge = judge_of<F>();
  for (const std::uint64_t exponent : {0, 1, 2, 62, 63, 64, 126, 127}) {
    for (std::uint64_t mantissa = 0; mantissa < 1u << 16; ++mantissa) {
      ASSERT_TRUE(root_agrees<F>(judge, exponent << 16 | mantissa));
    }
  }
  ASSERT_TRUE(root_agrees<F>(judge, 0x800000 | 65 << 16)) << "of the magnitude";
}
TEST(Roots, NearestEven) { check_roots<Float<7, 16>>(); }
TEST(Roots, Truncate) { check_roots<Float<7, 16, Rounding::kTruncate>>(); }

template <class F, unsigned Steps>
void check_steps(std::uint64_t bits) {
  constexpr auto kTop = static_cast<std::int64_t>(~0ull >> (64 - F::kLeafWidth + 1));
  const auto magnitude = static_cast<std::int64_t>(bits) & kTop;
  const auto up = static_cast<std::uint64_t>(std::min<std::int64_t>(magnitude + Steps, kTop));
  const auto down = static_cast<std::uint64_t>(std::max<std::int64_t>(magnitude - Steps, 0));
  const F f = from_pattern<F>(bits);
  ASSERT_EQ(pattern(f.template moved_up<Steps>()), up);
  ASSERT_EQ(pattern(f.template moved_down<Steps>()), down);
  ASSERT_EQ(F::Circuit::template moved_up<Steps>(f.bits()).to_u64(), up);
  ASSERT_EQ(F::Circuit::template moved_down<Steps>(f.bits()).to_u64(), down);
  for (const int sign : {1, -1}) {
    using Signed = hls::sint<hls::index_width(Steps + 1) + 1>;
    const auto steps =
        Signed::of_raw(static_cast<typename Signed::Raw>(sign * static_cast<int>(Steps)));
    ASSERT_EQ(pattern(f.moved(steps)), sign > 0 ? up : down);
    ASSERT_EQ(F::Circuit::moved(f.bits(), steps).to_u64(), sign > 0 ? up : down);
  }
}
TEST(Steps, GoUpAndDownAndStopAtTheEnds) {
  for (std::uint64_t bits = 0; bits < 1u << Float<4, 5>::kLeafWidth; ++bits) {
    check_steps<Float<4, 5>, 1>(bits);
    check_steps<Float<4, 5>, 6>(bits);
  }
  for (const std::uint64_t bits : {0u, 1u, 2u, 0x3fffffu, 0x7ffffeu, 0x7fffffu, 0xfffffdu}) {
    check_steps<Float<7, 16>, 2>(bits);
    check_steps<Float<7, 16>, 128>(bits);
  }
}

/// Formats at the edges of what the template takes.
template <class F>
class OtherFormats : public ::testing::Test {};
using LargeFormats = ::testing::Types<Float<8, 23>, Float<10, 24>, Float<8, 25>, Float<10, 52>,
                                      Float<2, 52>, Float<10, 2>, Float<5, 10, Rounding::kTruncate>,
                                      Float<10, 30>, Float<8, 23, Rounding::kTruncate>>;
TYPED_TEST_SUITE(OtherFormats, LargeFormats);

TYPED_TEST(OtherFormats, RandomPairs) {
  FloatJudge judge = judge_of<TypeParam>();
  Random random(TypeParam::kLeafWidth);
  constexpr std::uint64_t kMask = ~0ull >> (64 - TypeParam::kLeafWidth);
  for (int i = 0; i < 100'000; ++i) {
    const std::uint64_t a = random.next() & kMask;
    const std::uint64_t b =
        random.below(2) ? a + (random.next() >> random.below(64)) : random.next();
    ASSERT_TRUE(agree<TypeParam>(judge, a, b & kMask));
    ASSERT_TRUE(root_agrees<TypeParam>(judge, a));
  }
}

}  // namespace
