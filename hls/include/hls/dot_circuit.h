// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// DotCircuit<E, M, R, N>: the sum of N products of Float<E, M, R> and one more number, as the
// hardware has it, from bits to bits. A fused dot product with a fixed number of kept bits, after
// Saleh and Swartzlander, "A Floating-Point Fused Dot-Product Unit" (2008): terms are aligned to
// the largest exponent, cut off towards zero kKept bits behind it, and the sum is
// rounded once. So N + 1 shifters, N adders and one normalisation replace 2 N roundings.
#pragma once

#include "hls/float_circuit.h"

namespace hls {

template <unsigned E, unsigned M, Rounding R, unsigned N>
struct DotCircuit {
  using Number = FloatCircuit<E, M, R>;
  using Bits = typename Number::Bits;
  /// Bits kept behind the largest exponent, which is the sum of the exponents of two factors: 4
  /// more than the result has, so that four terms lose at most half of the error of its rounding.
  static constexpr unsigned kKept = M + 4;

  /// a[0] b[0] + ... + a[N - 1] b[N - 1], and `addend` where `adds`.
  static constexpr Bits dot(const Bits (&a)[N], const Bits (&b)[N], Bits addend, bool adds) {
    Exponent exponents[N + 1];
    uint<kTerm> terms[N + 1];
    bool signs[N + 1];
    for (unsigned i = 0; i < N; ++i) {
      exponents[i] = Number::exponent(a[i]) + Number::exponent(b[i]);
      terms[i] = product_term(a[i], b[i]);
      signs[i] = Number::sign(a[i]) != Number::sign(b[i]);
    }
    const Exponent of_addend = Number::exponent(addend) + uint<E>::of_raw(Number::kBias);
    exponents[N] = select(adds, of_addend, Exponent(0));
    terms[N] = select(adds, addend_term(addend), uint<kTerm>(0));
    signs[N] = Number::sign(addend);
    const Exponent largest = greatest<0, N + 1>(exponents);

    // Signs are those beside the first term's: each of the N additions takes one as its carry.
    uint<kSum> sum = aligned(terms[0], largest, exponents[0]);
    for (unsigned i = 1; i <= N; ++i) {
      sum = added(sum, aligned(terms[i], largest, exponents[i]), signs[i] != signs[0]);
    }
    return packed(sum, largest, signs[0]);
  }

 private:
  using Wide = FloatCircuit<E + 1, M, R>;  // whose shifts are as long as products' exponents ask
  using Exponent = uint<E + 1>;
  static constexpr unsigned kTerm = kKept + 2;                        // a product lies in [1, 4)
  static constexpr unsigned kMagnitude = kTerm + index_width(N + 1);  // of the sum
  static constexpr unsigned kSum = kMagnitude + 1;

  static constexpr uint<kTerm> product_term(Bits a, Bits b) {
    const auto product =
        Number::with_hidden(Number::mantissa(a)) * Number::with_hidden(Number::mantissa(b));
    if constexpr (2 * M >= kKept) {
      return product.template bits<2 * M + 1, 2 * M - kKept>();
    } else {
      return concat(product, uint<kKept - 2 * M>(0));
    }
  }
  static constexpr uint<kTerm> addend_term(Bits addend) {
    return concat(Number::with_hidden(Number::mantissa(addend)), uint<kKept - M>(0))
        .template zext<kTerm>();
  }
  template <unsigned From, unsigned To>
  static constexpr Exponent greatest(const Exponent (&of)[N + 1]) {
    if constexpr (To - From == 1) {
      return of[From];
    } else {
      constexpr unsigned kMiddle = (From + To) / 2;
      const Exponent x = greatest<From, kMiddle>(of);
      const Exponent y = greatest<kMiddle, To>(of);
      return select(x < y, y, x);
    }
  }
  static constexpr uint<kSum> aligned(uint<kTerm> term, Exponent largest, Exponent exponent) {
    bool lost = false;
    const auto distance = (largest - exponent).as_unsigned().template trunc<E + 1>();
    return Wide::align(term, distance, lost).template zext<kSum>();
  }
  /// sum + term or sum - term, modulo 2^kSum: one addition with carry in.
  static constexpr uint<kSum> added(uint<kSum> sum, uint<kSum> term, bool subtract) {
    const uint<kSum> y = term ^ select(subtract, uint<kSum>::ones(), uint<kSum>(0));
    return (concat(sum, uint<1>(1)) + concat(y, uint<1>(subtract))).template bits<kSum, 1>();
  }
  /// Rounds the sum, of which 2^kKept is 2^(largest - 2 kBias).
  static constexpr Bits packed(uint<kSum> sum, Exponent largest, bool first_sign) {
    constexpr unsigned kX = max_width(E + 1, index_width(kMagnitude + 1)) + 2;
    const bool negative = sum.template bit<kSum - 1>();
    const auto magnitude = added(uint<kSum>(0), sum, negative).template trunc<kMagnitude>();
    const auto zeros = Number::leading_zeros(magnitude);
    const uint<kMagnitude> normal = Number::normalise(magnitude, zeros);
    const auto at_top = sint<kX>::of_raw(static_cast<int>(kMagnitude - 1 - kKept) - Number::kBias);
    const auto exponent = (sint<kX>(largest.to_signed()) + at_top) - zeros.to_signed();
    return Number::pack(first_sign != negative, exponent.template trunc<kX>(), uint<2>(0),
                        normal.template trunc<kMagnitude - 1>(), false,
                        !normal.template bit<kMagnitude - 1>());
  }
};

}  // namespace hls
