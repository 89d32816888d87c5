// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Floats as patterns of bits, for the tests that hold them against their judge.
#pragma once

#include <cstdint>

#include "hls/float.h"
#include "hls/float_judge.h"

namespace hls::testing {

template <class F>
FloatJudge judge_of() {
  return FloatJudge(F::kExponentBits, F::kMantissaBits, F::kRounding == Rounding::kNearestEven);
}
template <class F>
F from_pattern(std::uint64_t bits) {
  return F::from_bits(F::Bits::from(bits));
}
template <class F>
std::uint64_t pattern(F f) {
  return f.bits().to_u64();
}

template <class F, unsigned E, unsigned M, Rounding R>
std::uint64_t circuit_convert(Float<E, M, R> from) {
  return F::Circuit::template convert<E, M, R>(from.bits()).to_u64();
}

}  // namespace hls::testing
