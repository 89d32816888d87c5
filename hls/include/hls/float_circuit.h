// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// FloatCircuit<E, M, R>: the operations of Float<E, M, R> as the hardware has them, from bits to
// bits. Plain integer arithmetic, no branches, in widths that are the least that round correctly.
// Float<7, 16>'s significand fits a signed 18x18 multiplier.
#pragma once

#include <bit>
#include <cstdint>

#include "hls/int.h"
#include "hls/reciprocal.h"

// hlsc says 0 for a device without hard multipliers. The bits of a result are the same.
#ifndef HLS_HARD_MULTIPLIERS
#define HLS_HARD_MULTIPLIERS 1
#endif

namespace hls {

enum class Rounding : std::uint8_t {
  kNearestEven,
  kTruncate,  ///< towards zero
};

template <unsigned E, unsigned M, Rounding R>
struct FloatCircuit {
  static constexpr int kBias = (1 << (E - 1)) - 1;
  using Bits = uint<1 + E + M>;
  /// The format that holds every product of two numbers exactly.
  using Product = FloatCircuit<E + 2, 2 * M + 1, R>;

  static constexpr bool sign(Bits f) { return f.template bit<E + M>(); }
  static constexpr uint<E> exponent(Bits f) { return f.template bits<E + M - 1, M>(); }
  static constexpr uint<M> mantissa(Bits f) { return f.template trunc<M>(); }
  /// Exponent and mantissa; magnitudes order as these integers do.
  static constexpr uint<E + M> magnitude(Bits f) { return f.template trunc<E + M>(); }
  static constexpr Bits assemble(bool sign, uint<E + M> magnitude) {
    return concat(uint<1>(sign), magnitude);
  }

  static constexpr Bits sum(Bits a, Bits b) { return sum_to<FloatCircuit>(a, b); }

  /// The sum rounded once to another format, which has no more mantissa bits.
  template <class To>
  static constexpr typename To::Bits sum_to(Bits a, Bits b) {
    // The significands are 1.M with kGuard bits behind them; `lost` says whether the smaller one
    // had more. The sum has one bit before them for the carry.
    constexpr unsigned kGuard = R == Rounding::kNearestEven ? 2 : 1;
    constexpr unsigned kN = M + 1 + kGuard;
    constexpr unsigned kX = max_width(E, index_width(kN + 2)) + 2;
    const bool swap = magnitude(a) < magnitude(b);
    const uint<E> ab = (exponent(a) - exponent(b)).as_unsigned().template trunc<E>();
    const uint<E> ba = (exponent(b) - exponent(a)).as_unsigned().template trunc<E>();
    const uint<E> distance = select(swap, ba, ab);
    const Bits larger = select(swap, b, a);
    const uint<M> smaller = select(swap, mantissa(a), mantissa(b));
    const bool subtract = sign(a) != sign(b);

    bool lost = false;
    const uint<kN> aligned = align(concat(with_hidden(smaller), uint<kGuard>(0)), distance, lost);
    // One addition with carry in, the smaller one's bits inverted to subtract it.
    const uint<kN + 2> x = concat(with_hidden(mantissa(larger)), uint<kGuard + 1>(0));
    const uint<kN + 2> y = concat(aligned, uint<1>(lost));
    const uint<kN + 2> added = y ^ select(subtract, uint<kN + 2>::ones(), uint<kN + 2>(0));
    const uint<kN + 2> sum =
        (concat(x, uint<1>(1)) + concat(added, uint<1>(subtract))).template bits<kN + 2, 1>();

    // The last bit, `lost`, is zero wherever more than two places are cancelled: it need not be
    // shifted.
    const uint<kN + 1> upper = sum.template bits<kN + 1, 1>();
    const auto zeros = leading_zeros(upper);
    const uint<kN + 1> normal = normalise(upper, zeros);
    const bool nonzero = normal.template bit<kN>();
    const auto own = sint<kX>(exponent(larger).to_signed()) - sint<kX>(zeros.to_signed());
    const sint<kX> result = rebias<To, kX>(own.template trunc<kX>());
    return To::pack(sign(larger), result, uint<2>(uint<1>(nonzero)), normal.template trunc<kN>(),
                    sum.template bit<0>(), !nonzero);
  }

  static constexpr Bits product(Bits a, Bits b) {
    constexpr unsigned kX = E + 2;
    const auto product = with_hidden(mantissa(a)) * with_hidden(mantissa(b));
    const bool top = product.template bit<2 * M + 1>();
    // The leading one drops out at the top, in whichever of two places it is.
    const uint<M + 2> fraction = product.template bits<2 * M, M - 1>() << uint<1>(!top);
    const bool sticky = product.template trunc<M - 1>() != uint<M - 1>(0);
    // The exponent is a + b - bias + top; the bias's 1 comes in with `top`.
    const auto result = (exponent(a) + exponent(b)).to_signed() - sint<kX>(1 << (E - 1));
    return pack(sign(a) != sign(b), result.template trunc<kX>(),
                concat(uint<1>(top), uint<1>(!top)), fraction, sticky, false);
  }

  static constexpr uint<E + 2 * M + 4> exact_product(Bits a, Bits b) {
    const auto product = with_hidden(mantissa(a)) * with_hidden(mantissa(b));
    const bool top = product.template bit<2 * M + 1>();
    const uint<2 * M + 1> fraction = product.template trunc<2 * M + 1>() << uint<1>(!top);
    const auto biased = (exponent(a) + exponent(b)) + uint<E + 2>((1u << E) + 1);
    const auto result = biased + uint<1>(top);
    return Product::assemble(sign(a) != sign(b), concat(result.template trunc<E + 2>(), fraction));
  }

  static constexpr Bits quotient(Bits a, Bits b) {
    // Nearest-even needs one quotient bit behind the mantissa and no remainder: M + 1 bits over
    // M + 1 bits never lie half way between two numbers.
    if constexpr (kQuotientOfProducts) return quotient_by_products(a, b);
    constexpr unsigned kX = E + 2;
    constexpr unsigned kK = R == Rounding::kNearestEven ? M + 2 : M + 1;
    const auto quotient = concat(with_hidden(mantissa(a)), uint<kK>(0)) / with_hidden(mantissa(b));
    const bool top = quotient.template bit<kK>();
    const uint<kK - 1> fraction =
        select(top, quotient.template bits<kK - 1, 1>(), quotient.template bits<kK - 2, 0>());
    const auto result = (exponent(a) - exponent(b)) + sint<kX>(kBias - 1);
    return pack(sign(a) != sign(b), result.template trunc<kX>(), uint<2>(uint<1>(top)), fraction,
                true, false);
  }

  /// The square root of the magnitude, digit by digit.
  static constexpr Bits root(Bits a) {
    // As with a quotient one bit behind the mantissa rounds, and nothing lies half way: the square
    // of such a number would have more bits than there are.
    constexpr unsigned kX = E + 2;
    constexpr unsigned kK = R == Rounding::kNearestEven ? M + 2 : M + 1;
    // The bias is odd, so under an even exponent lies an odd power of two, half of which is rooted.
    const bool odd = !exponent(a).template bit<0>();
    const uint<M + 1> significand = with_hidden(mantissa(a));
    const uint<M + 2> radicand =
        select(odd, concat(significand, uint<1>(0)), concat(uint<1>(0), significand));
    uint<2 * kK> digits = concat(radicand, uint<2 * kK - M - 2>(0));
    uint<kK> root;
    uint<kK + 2> rest;
    for (unsigned i = 0; i < kK; ++i) {
      rest = concat(rest.template trunc<kK>(), digits.template bits<2 * kK - 1, 2 * kK - 2>());
      digits = digits.template shl<2>();
      const auto less = (rest - concat(root, uint<2>(1))).as_unsigned();
      const bool fits = !less.template bit<kK + 2>();
      rest = select(fits, less.template trunc<kK + 2>(), rest);
      root = concat(root.template trunc<kK - 1>(), uint<1>(fits));
    }
    const auto twice = exponent(a) + uint<E>::of_raw(kBias);
    const auto result = sint<kX>(twice.template bits<E, 1>().to_signed());
    return pack(false, result, uint<2>(0), root.template trunc<kK - 1>(), true, false);
  }

  static constexpr bool less(Bits a, Bits b) {
    // As unsigned integers the patterns order rightly if both are positive, in reverse if any is
    // negative; a last bit turns the reversed >= into >.
    const uint<1> reverse = uint<1>(sign(a)) | uint<1>(sign(b));
    return (concat(a, uint<1>(0)) < concat(b, reverse)) != bool(reverse);
  }

  /// The positive number that lies `Steps` of the mantissa above a magnitude, or below it;
  /// saturated.
  template <unsigned Steps>
  static constexpr Bits moved_up(Bits a) {
    const auto sum = magnitude(a) + uint<E + M>(Steps);
    const bool over = sum.template bit<E + M>();
    return assemble(false, select(over, uint<E + M>::ones(), sum.template trunc<E + M>()));
  }
  template <unsigned Steps>
  static constexpr Bits moved_down(Bits a) {
    const auto less = (magnitude(a) - uint<E + M>(Steps)).as_unsigned();
    const bool under = less.template bit<E + M>();
    return assemble(false, select(under, uint<E + M>(0), less.template trunc<E + M>()));
  }
  template <unsigned W>
  static constexpr Bits moved(Bits a, sint<W> steps) {
    const auto sum = (magnitude(a).to_signed() + steps).as_unsigned();
    const bool under = sum.template bit<E + M + 1>();
    const bool over = sum.template bit<E + M>();
    const uint<E + M> within = select(over, uint<E + M>::ones(), sum.template trunc<E + M>());
    return assemble(false, select(under, uint<E + M>(0), within));
  }

  /// From the bits of another format.
  template <unsigned E2, unsigned M2, Rounding R2>
  static constexpr Bits convert(uint<1 + E2 + M2> bits) {
    using Other = FloatCircuit<E2, M2, R2>;
    constexpr unsigned kX = max_width(E, E2) + 2;
    const auto rebias = sint<kX>::of_raw(kBias - Other::kBias);
    const auto result = (Other::exponent(bits).to_signed() + rebias).template trunc<kX>();
    return pack(Other::sign(bits), result, uint<2>(0), Other::mantissa(bits), false, false);
  }
  /// Both zeros give the smallest positive number, infinities and NaNs the largest magnitude.
  static constexpr Bits from_double(double value) {
    const auto bits = uint<64>::of_raw(std::bit_cast<std::uint64_t>(value));
    const uint<11> exponent = bits.bits<62, 52>();
    const uint<52> mantissa = bits.bits<51, 0>();
    const auto rebias = sint<12>::of_raw(kBias - 1023);
    const bool zero = bits.trunc<63>() == uint<63>(0);
    return pack(bits.bit<63>(), exponent.to_signed() + rebias, uint<2>(0), mantissa, false, zero);
  }
  template <unsigned W>
  static constexpr Bits from_uint(uint<W> integer) {
    constexpr unsigned kW = max_width(W, 2);
    constexpr unsigned kX = max_width(E, index_width(kW + 1)) + 2;
    const uint<kW> wide = integer.template zext<kW>();
    const auto zeros = leading_zeros(wide);
    const auto result = sint<kX>::of_raw(kBias + static_cast<int>(kW) - 1) - zeros.to_signed();
    const uint<kW> normal = normalise(wide, zeros);
    return pack(false, result.template trunc<kX>(), uint<2>(0), normal.template trunc<kW - 1>(),
                false, !normal.template bit<kW - 1>());
  }

 private:
  template <unsigned E2, unsigned M2, Rounding R2>
  friend struct FloatCircuit;
  template <unsigned E2, unsigned M2, Rounding R2, unsigned N>
  friend struct DotCircuit;

  static constexpr bool kQuotientOfProducts =
      HLS_HARD_MULTIPLIERS != 0 && M >= kLeastReciprocal && M <= kMostReciprocal;

  /// The quotient as a product with the divisor's reciprocal, which is too small by a few units of
  /// its last place; the remainder says by how many. The divisor's part needs three products, and
  /// the dividend's two.
  static constexpr Bits quotient_by_products(Bits a, Bits b) {
    using Reciprocal = SignificandReciprocal<M>;
    constexpr bool kNearest = R == Rounding::kNearestEven;
    constexpr unsigned kX = E + 2;
    constexpr unsigned kF = kNearest ? M + 1 : M;  // bits of the quotient behind the point
    const uint<M + 1> x = with_hidden(mantissa(a));
    const uint<M + 1> y = with_hidden(mantissa(b));
    const auto reciprocal = Reciprocal::below(y);
    // Of a dividend in [y, 2 y) the quotient lies in [1, 2).
    const bool below = x < y;
    const uint<M + 2> dividend = select(below, concat(x, uint<1>(0)), concat(uint<1>(0), x));
    constexpr unsigned kPoint = M + Reciprocal::kFractionBits;
    const auto estimate = (dividend * reciprocal).template bits<kPoint, kPoint - kF>();
    static_assert(2 * Reciprocal::kError + 1 < 4, "less than four units are missing");

    // The remainder is less than four times the divisor: its low bits say it, and its sign after a
    // multiple was taken away. An odd estimate to nearest is rounded up anyway, as a quotient never
    // lies half way; up again if two units are missing. An even one goes up if one is, twice if
    // three are.
    constexpr unsigned kRest = M + 4;
    const uint<kRest> whole = concat(dividend.template trunc<kRest - kF>(), uint<kF>(0));
    const uint<kRest> product = (estimate * y).template trunc<kRest>();
    const bool odd = kNearest && estimate.template bit<0>();
    const uint<kRest> once = y;
    const uint<kRest> twice = concat(y, uint<1>(0));
    const uint<kRest> more =
        kNearest ? select(odd, twice, (once + twice).template trunc<kRest>()) : twice;
    const bool first = odd || reaches(whole, product, once);
    const bool second = reaches(whole, product, more);

    const auto bias = sint<kX>(kBias - 1) + uint<1>(!below).to_signed();
    const auto exponents = (exponent(a) - exponent(b)) + bias;
    return assemble(sign(a) != sign(b),
                    rounded_quotient(exponents.template trunc<kX>(), estimate, first, second));
  }
  /// The magnitude of estimate * 2^(exponent - bias) rounded up by a unit, and by one more, with
  /// which the estimate lies in [1, 2]. So the exponent alone says whether the result is in range,
  /// but for two cases: what reaches the smallest number from below is zero either way, and what
  /// reaches the largest number, or goes beyond, becomes the largest.
  template <unsigned X, unsigned F1>
  static constexpr uint<E + M> rounded_quotient(sint<X> exponent, uint<F1> estimate, bool once,
                                                bool twice) {
    constexpr unsigned kF = F1 - 1;
    const uint<X> result = exponent.as_unsigned();
    const bool under = result.template bit<X - 1>();
    const bool beyond = result.template bit<E>();
    const bool last = result.template trunc<E>() == uint<E>::ones();
    const bool leading = estimate.template bit<kF>();
    const uint<M> kept = estimate.template bits<kF - 1, kF - M>();
    const bool nearly = leading && kept.template bits<M - 1, 1>() == uint<M - 1>::ones();
    const bool over = beyond || (last && nearly && (kept.template bit<0>() || once));

    // One addition takes both up, the second as a carry: no logic is before it.
    const auto base =
        concat(concat(result.template trunc<E>(), uint<1>(once).template zext<M>()), uint<1>(1));
    const auto above = select(leading, uint<E>(0), uint<E>::ones());
    const auto added = concat(concat(above, kept), uint<1>(twice));
    const auto total = (base + added).template bits<E + M, 1>();
    const uint<E + M> clamped = select(over, uint<E + M>::ones(), total);
    return select(under, uint<E + M>(0), clamped);
  }
  /// Whether whole - product is at least `multiple`; it is known modulo 2^W and the difference lies
  /// within half of that. The sign of product + multiple - whole - 1 says so without an inverter.
  template <unsigned W>
  static constexpr bool reaches(uint<W> whole, uint<W> product, uint<W> multiple) {
    const auto below = (multiple + ~whole).template trunc<W>();
    return (product + below).template bit<W - 1>();
  }

  /// An exponent as another format's.
  template <class To, unsigned X>
  static constexpr sint<X> rebias(sint<X> exponent) {
    if constexpr (To::kBias == kBias) {
      return exponent;
    } else {
      return (exponent + sint<X>::of_raw(To::kBias - kBias)).template trunc<X>();
    }
  }

  static constexpr uint<M + 1> with_hidden(uint<M> mantissa) {
    return concat(uint<1>(1), mantissa);
  }

  /// Leading zeros, and the value without them. The one appended to the value tells LLVM that
  /// neither the count nor the shift can exceed the width, so no logic handles that case.
  template <unsigned N>
  static constexpr auto leading_zeros(uint<N> value) {
    return count_leading_zeros(concat(value, uint<1>(1)));
  }
  template <unsigned N, unsigned Z>
  static constexpr uint<N> normalise(uint<N> value, uint<Z> zeros) {
    return (concat(value, uint<1>(0)) << zeros).template bits<N, 1>();
  }

  /// value >> distance; `lost` if a one was shifted out. The value is not zero.
  template <unsigned N>
  static constexpr uint<N> align(uint<N> value, uint<E> distance, bool& lost) {
    return align_stage<N, index_width(N)>(value, distance, lost);
  }
  /// The stages of weight 2^(S-1) and less, S = 0 being the clearing of everything beyond them.
  template <unsigned N, unsigned S>
  static constexpr uint<N> align_stage(uint<N> value, uint<E> distance, bool& lost) {
    if constexpr (S == 0) {
      if constexpr (index_width(N) < E) {
        const bool far =
            distance.template bits<E - 1, index_width(N)>() != uint<E - index_width(N)>(0);
        lost = lost || far;
        value = select(far, uint<N>(0), value);
      }
      return value;
    } else if constexpr (S > E) {
      return align_stage<N, S - 1>(value, distance, lost);
    } else {
      constexpr unsigned kBy = 1u << (S - 1);
      const bool shift = distance.template bit<S - 1>();
      const bool ones = value.template trunc<kBy>() != uint<kBy>(0);
      lost = lost || (shift && ones);
      value = select(shift, value.template shr<kBy>(), value);
      return align_stage<N, S - 1>(value, distance, lost);
    }
  }

  /// Rounds and saturates 1.fraction * 2^(exponent + late - bias). `late` is the part of the
  /// exponent that is known only with the fraction; the rounding addition adds it. `sticky` says
  /// whether the exact number has further bits behind the fraction.
  template <unsigned X, unsigned F>
  static constexpr Bits pack(bool sign, sint<X> exponent, uint<2> late, uint<F> fraction,
                             bool sticky, bool zero) {
    uint<M> kept;
    bool up = false;
    if constexpr (F <= M) {
      kept = uint<M>::of_raw(
          static_cast<typename uint<M>::Raw>(fraction.template zext<M>().raw() << (M - F)));
    } else {
      kept = fraction.template bits<F - 1, F - M>();
      if constexpr (R == Rounding::kNearestEven) {
        bool beyond = sticky;
        if constexpr (F >= M + 2) {
          const bool ones = fraction.template trunc<F - M - 1>() != uint<F - M - 1>(0);
          beyond = beyond || ones;
        }
        const bool half = fraction.template bit<F - M - 1>();
        up = half && (beyond || kept.template bit<0>());
      }
    }
    const auto base = concat(exponent.as_unsigned(), uint<1>(up).template zext<M>());
    const auto total = (base + concat(late, kept)).template trunc<X + M>();
    const bool negative = total.template bit<X + M - 1>();
    const bool under = negative || zero;
    const bool over = total.template bits<X + M - 2, E + M>() != uint<X - 1 - E>(0);
    const uint<E + M> clamped = select(over, uint<E + M>::ones(), total.template trunc<E + M>());
    return assemble(sign && !zero, select(under, uint<E + M>(0), clamped));
  }
};

}  // namespace hls
