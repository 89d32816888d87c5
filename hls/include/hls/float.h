// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Float<E, M, R>: sign, E exponent bits (bias 2^(E-1) - 1), M stored mantissa bits under a hidden
// one. Always normalised: every bit pattern is the number (-1)^sign * 2^(exponent - bias) *
// (1 + mantissa / 2^M); there is no zero, no infinity, no NaN (thesis, 3.1.2 and 7). An operation
// computes the exact result, rounds it once and saturates: what is too large becomes the largest
// magnitude, what is too small the smallest one, both with their sign; an exact zero becomes the
// smallest positive number.
//
// One source for the model and for hlsc: plain integer arithmetic, no tables, no branches. Widths
// are the least that round correctly. Float<7, 16>'s significand fits a signed 18x18 multiplier.
#pragma once

#include <bit>
#include <cstdint>

#include "hls/int.h"

namespace hls {

enum class Rounding : std::uint8_t {
  kNearestEven,
  kTruncate,  ///< towards zero
};

template <unsigned E, unsigned M, Rounding R = Rounding::kNearestEven>
class Float {
  static_assert(E >= 2 && E <= 10, "a Float has 2 to 10 exponent bits, so that a double holds it");
  static_assert(M >= 2 && M <= 52, "a Float has 2 to 52 mantissa bits, so that a double holds it");

 public:
  static constexpr unsigned kExponentBits = E;
  static constexpr unsigned kMantissaBits = M;
  static constexpr Rounding kRounding = R;
  static constexpr unsigned kLeafWidth = 1 + E + M;
  static constexpr int kBias = (1 << (E - 1)) - 1;
  using Bits = uint<kLeafWidth>;

  /// The smallest positive number: all bits zero.
  constexpr Float() = default;
  static constexpr Float from_bits(Bits bits) {
    Float f;
    f.bits_ = bits;
    return f;
  }
  static constexpr Float smallest() { return Float{}; }
  static constexpr Float one() {
    return assemble(false, concat(uint<E>::of_raw(kBias), uint<M>(0)));
  }
  /// The largest positive number.
  static constexpr Float largest() { return assemble(false, uint<E + M>::ones()); }

  /// Conversion from another format, rounded and saturated as this one's results are.
  template <unsigned E2, unsigned M2, Rounding R2>
  constexpr explicit Float(Float<E2, M2, R2> other) {
    constexpr unsigned kX = max_width(E, E2) + 2;
    const auto rebias = sint<kX>::of_raw(kBias - Float<E2, M2, R2>::kBias);
    const auto exponent = (other.exponent().to_signed() + rebias).template trunc<kX>();
    *this = pack(other.sign(), exponent, uint<2>(0), other.mantissa(), false, false);
  }
  /// Both zeros give the smallest positive number, infinities and NaNs the largest magnitude.
  static constexpr Float from_double(double value) {
    const auto bits = uint<64>::of_raw(std::bit_cast<std::uint64_t>(value));
    const uint<11> exponent = bits.bits<62, 52>();
    const uint<52> mantissa = bits.bits<51, 0>();
    const auto rebias = sint<12>::of_raw(kBias - 1023);
    const bool zero = bits.trunc<63>() == uint<63>(0);
    return pack(bits.bit<63>(), exponent.to_signed() + rebias, uint<2>(0), mantissa, false, zero);
  }
  static constexpr Float from_float(float value) { return from_double(value); }
  /// An unsigned integer; 0 gives the smallest positive number.
  template <unsigned W>
  static constexpr Float from_uint(uint<W> integer) {
    constexpr unsigned kW = max_width(W, 2);
    constexpr unsigned kX = max_width(E, index_width(kW + 1)) + 2;
    const uint<kW> wide = integer.template zext<kW>();
    const auto zeros = leading_zeros(wide);
    const auto exponent = sint<kX>::of_raw(kBias + static_cast<int>(kW) - 1) - zeros.to_signed();
    const uint<kW> normal = normalise(wide, zeros);
    return pack(false, exponent.template trunc<kX>(), uint<2>(0), normal.template trunc<kW - 1>(),
                false, !normal.template bit<kW - 1>());
  }

  constexpr Bits bits() const { return bits_; }
  constexpr bool sign() const { return bits_.template bit<E + M>(); }
  constexpr uint<E> exponent() const { return bits_.template bits<E + M - 1, M>(); }
  constexpr uint<M> mantissa() const { return bits_.template trunc<M>(); }
  /// Exponent and mantissa; magnitudes order as these integers do.
  constexpr uint<E + M> magnitude() const { return bits_.template trunc<E + M>(); }
  /// Exact.
  constexpr double to_double() const {
    const std::uint64_t exponent64 = exponent().to_u64() + (1023 - kBias);
    return std::bit_cast<double>(std::uint64_t{sign()} << 63 | exponent64 << 52 |
                                 mantissa().to_u64() << (52 - M));
  }
  constexpr Bits leaf_bits() const { return bits_; }
  static constexpr Float from_leaf_bits(Bits bits) { return from_bits(bits); }

  friend constexpr Float abs(Float a) { return assemble(false, a.magnitude()); }
  constexpr Float operator-() const { return assemble(!sign(), magnitude()); }

  friend constexpr Float operator+(Float a, Float b) {
    // The significands are 1.M with kGuard bits behind them; `lost` says whether the smaller one
    // had more. The sum has one bit before them for the carry.
    constexpr unsigned kGuard = R == Rounding::kNearestEven ? 2 : 1;
    constexpr unsigned kN = M + 1 + kGuard;
    constexpr unsigned kX = max_width(E, index_width(kN + 2)) + 2;
    const bool swap = a.magnitude() < b.magnitude();
    const uint<E> ab = (a.exponent() - b.exponent()).as_unsigned().template trunc<E>();
    const uint<E> ba = (b.exponent() - a.exponent()).as_unsigned().template trunc<E>();
    const uint<E> distance = select(swap, ba, ab);
    const Float larger = from_bits(select(swap, b.bits_, a.bits_));
    const uint<M> smaller = select(swap, a.mantissa(), b.mantissa());
    const bool subtract = a.sign() != b.sign();

    bool lost = false;
    const uint<kN> aligned = align(concat(with_hidden(smaller), uint<kGuard>(0)), distance, lost);
    // One addition with carry in, the smaller one's bits inverted to subtract it.
    const uint<kN + 2> x = concat(with_hidden(larger.mantissa()), uint<kGuard + 1>(0));
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
    const auto exponent = sint<kX>(larger.exponent().to_signed()) - sint<kX>(zeros.to_signed());
    return pack(larger.sign(), exponent.template trunc<kX>(), uint<2>(uint<1>(nonzero)),
                normal.template trunc<kN>(), sum.template bit<0>(), !nonzero);
  }
  friend constexpr Float operator-(Float a, Float b) { return a + -b; }

  friend constexpr Float operator*(Float a, Float b) {
    constexpr unsigned kX = E + 2;
    const auto product = with_hidden(a.mantissa()) * with_hidden(b.mantissa());
    const bool top = product.template bit<2 * M + 1>();
    // The leading one drops out at the top, in whichever of two places it is.
    const uint<M + 2> fraction = product.template bits<2 * M, M - 1>() << uint<1>(!top);
    const bool sticky = product.template trunc<M - 1>() != uint<M - 1>(0);
    // The exponent is a + b - bias + top; the bias's 1 comes in with `top`.
    const auto exponent = (a.exponent() + b.exponent()).to_signed() - sint<kX>(1 << (E - 1));
    return pack(a.sign() != b.sign(), exponent.template trunc<kX>(),
                concat(uint<1>(top), uint<1>(!top)), fraction, sticky, false);
  }

  friend constexpr Float operator/(Float a, Float b) {
    // Nearest-even needs one quotient bit behind the mantissa and no remainder: M + 1 bits over
    // M + 1 bits never lie half way between two numbers.
    constexpr unsigned kX = E + 2;
    constexpr unsigned kK = R == Rounding::kNearestEven ? M + 2 : M + 1;
    const auto quotient =
        concat(with_hidden(a.mantissa()), uint<kK>(0)) / with_hidden(b.mantissa());
    const bool top = quotient.template bit<kK>();
    const uint<kK - 1> fraction =
        select(top, quotient.template bits<kK - 1, 1>(), quotient.template bits<kK - 2, 0>());
    const auto exponent = (a.exponent() - b.exponent()) + sint<kX>(kBias - 1);
    return pack(a.sign() != b.sign(), exponent.template trunc<kX>(), uint<2>(uint<1>(top)),
                fraction, true, false);
  }

  /// Different bits are different numbers, so all comparisons are exact and total.
  friend constexpr bool operator==(Float a, Float b) { return a.bits_ == b.bits_; }
  friend constexpr bool operator<(Float a, Float b) {
    // As unsigned integers the patterns order rightly if both are positive, in reverse if any is
    // negative; a last bit turns the reversed >= into >.
    const uint<1> reverse = uint<1>(a.sign()) | uint<1>(b.sign());
    return (concat(a.bits_, uint<1>(0)) < concat(b.bits_, reverse)) != bool(reverse);
  }
  friend constexpr bool operator>(Float a, Float b) { return b < a; }
  friend constexpr bool operator<=(Float a, Float b) { return !(b < a); }
  friend constexpr bool operator>=(Float a, Float b) { return !(a < b); }

 private:
  static constexpr Float assemble(bool sign, uint<E + M> magnitude) {
    return from_bits(concat(uint<1>(sign), magnitude));
  }
  static constexpr uint<M + 1> with_hidden(uint<M> mantissa) {
    return concat(uint<1>(1), mantissa);
  }

  /// Leading zeros, and the value without them. The one counted behind the value says to LLVM that
  /// neither the count nor the shift can exceed the width: nothing is computed for that case.
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

  /// Rounds and saturates 1.fraction * 2^(exponent + late - bias). `late` is what becomes known of
  /// the exponent together with the fraction: it joins in the addition that rounds. `sticky` says
  /// whether the exact number goes on behind the fraction.
  template <unsigned X, unsigned F>
  static constexpr Float pack(bool sign, sint<X> exponent, uint<2> late, uint<F> fraction,
                              bool sticky, bool zero) {
    uint<M> kept;
    uint<1> up(0);
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
        const uint<1> half(fraction.template bit<F - M - 1>());
        up = half & (uint<1>(beyond) | kept.template trunc<1>());
      }
    }
    const auto base = concat(concat(exponent.as_unsigned(), uint<M - 1>(0)), up);
    const auto total = (base + concat(late, kept)).template trunc<X + M>();
    const bool negative = total.template bit<X + M - 1>();
    const bool under = negative || zero;
    const bool over = total.template bits<X + M - 2, E + M>() != uint<X - 1 - E>(0);
    const uint<E + M> clamped = select(over, uint<E + M>::ones(), total.template trunc<E + M>());
    return assemble(sign && !zero, select(under, uint<E + M>(0), clamped));
  }

  Bits bits_;
};

}  // namespace hls
