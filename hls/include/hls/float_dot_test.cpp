// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Fused dot products against MPFR: against their definition, to the bit, natively and by the
// circuit, and against the exact sum within the bound that float.h states.
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

constexpr unsigned kN = 3;
/// The patterns of the factors and of the addend.
struct Operands {
  std::uint64_t a[kN], b[kN], addend;
  bool adds;
};

template <class F>
std::uint64_t native(const Operands& o) {
  F a[kN], b[kN];
  for (unsigned i = 0; i < kN; ++i) a[i] = from_pattern<F>(o.a[i]), b[i] = from_pattern<F>(o.b[i]);
  return pattern(F::of_dot(a, b, from_pattern<F>(o.addend), o.adds));
}
template <class F>
using Circuit = hls::DotCircuit<F::kExponentBits, F::kMantissaBits, F::kRounding, kN>;
template <class F>
std::uint64_t by_circuit(const Operands& o) {
  typename F::Bits a[kN], b[kN];
  for (unsigned i = 0; i < kN; ++i) a[i] = F::Bits::from(o.a[i]), b[i] = F::Bits::from(o.b[i]);
  return Circuit<F>::dot(a, b, F::Bits::from(o.addend), o.adds).to_u64();
}

template <class F>
bool agrees(FloatJudge& judge, const Operands& o) {
  const std::uint64_t want =
      judge.dot(o.a, o.b, kN, o.adds ? &o.addend : nullptr, Circuit<F>::kKept);
  const std::uint64_t got = native<F>(o);
  const std::uint64_t circuit = by_circuit<F>(o);
  const bool near =
      judge.dot_is_near(want, o.a, o.b, kN, o.adds ? &o.addend : nullptr, Circuit<F>::kKept);
  if (got == want && circuit == want && near) return true;
  ADD_FAILURE() << std::hex << "0x" << o.a[0] << " * 0x" << o.b[0] << " + 0x" << o.a[1] << " * 0x"
                << o.b[1] << " + 0x" << o.a[2] << " * 0x" << o.b[2]
                << (o.adds ? " + 0x" : ", not 0x") << o.addend << " is 0x" << got
                << ", by the circuit 0x" << circuit << "; MPFR says 0x" << want
                << (near ? "" : ", which is too far from the exact sum");
  return false;
}

template <class F>
class DotProducts : public ::testing::Test {};
using Formats =
    ::testing::Types<Float<2, 2>, Float<3, 3>, Float<5, 8>, Float<7, 8>, Float<7, 16>, Float<8, 20>,
                     Float<8, 23>, Float<8, 29>, Float<9, 24>, Float<10, 16>,
                     Float<2, 2, Rounding::kTruncate>, Float<7, 16, Rounding::kTruncate>,
                     Float<9, 12, Rounding::kTruncate>>;
TYPED_TEST_SUITE(DotProducts, Formats);

TYPED_TEST(DotProducts, AreThoseOfTheirDefinitionAndNearTheExactSum) {
  using F = TypeParam;
  constexpr unsigned kBits = F::kLeafWidth;
  constexpr std::uint64_t kMask = ~0ull >> (64 - kBits);
  constexpr std::uint64_t kSign = 1ull << (kBits - 1);
  constexpr std::uint64_t kExponent = kMask & ~kSign & (~0ull << F::kMantissaBits);
  FloatJudge judge = judge_of<F>();
  Random random(kBits);
  const auto near_one = [&] {
    const std::uint64_t one = pattern(F::one());
    return (random.next() & kMask & ~kExponent) |
           ((one + (random.below(9) << F::kMantissaBits)) & kExponent);
  };
  for (int n = 0; n < 300'000; ++n) {
    Operands o{};
    const bool moderate = random.below(2) != 0;
    for (unsigned i = 0; i < kN; ++i) {
      o.a[i] = moderate ? near_one() : random.next() & kMask;
      o.b[i] = moderate ? near_one() : random.next() & kMask;
    }
    o.addend = moderate ? near_one() : random.next() & kMask;
    o.adds = random.below(2) != 0;
    switch (random.below(6)) {
      case 0:  // cancels to nothing, or nearly
        o.a[1] = o.b[0];
        o.b[1] = o.a[0] ^ kSign ^ random.below(3);
        break;
      case 1:
        o.a[2] = pattern(F::one());
        o.b[2] = o.addend ^ kSign;
        break;
      case 2:  // nothing but what cancels
        o.a[1] = o.a[0];
        o.b[1] = o.b[0] ^ kSign;
        o.a[2] = pattern(F::one());
        o.b[2] = o.addend ^ kSign;
        o.adds = true;
        break;
      default:
        break;
    }
    ASSERT_TRUE(agrees<F>(judge, o)) << n;
  }
}

TEST(DotProduct, OfEveryShortNumber) {
  using F = Float<2, 2>;
  FloatJudge judge = judge_of<F>();
  constexpr std::uint64_t kMask = (1u << F::kLeafWidth) - 1;
  for (std::uint64_t i = 0; i < 1u << (4 * F::kLeafWidth); ++i) {
    const std::uint64_t one = pattern(F::one());
    ASSERT_TRUE(agrees<F>(
        judge, {{i & kMask, i >> 10 & kMask, one}, {i >> 5 & kMask, one, 0}, i >> 15, true}));
  }
}

TEST(DotProduct, OfWhatCancelsIsTheSmallestNumber) {
  using F = Float<7, 16>;
  const F x = F::from_double(1.7);
  const F y = F::from_double(-0.3);
  const F a[] = {x, -y};
  const F b[] = {y, x};
  EXPECT_EQ(F::of_dot(a, b, F::one(), false), F::smallest());
  EXPECT_EQ(F::of_dot(a, b, F::one(), true), F::one());
}

}  // namespace
