// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Float<E, M, R>: sign, E exponent bits (bias 2^(E-1) - 1), M stored mantissa bits under a hidden
// one. Always normalised: every bit pattern is the number (-1)^sign * 2^(exponent - bias) *
// (1 + mantissa / 2^M); there is no zero, no infinity, no NaN (thesis, 3.1.2 and 7). An operation
// computes the exact result, rounds it once and saturates: a magnitude that is too large becomes
// the largest, one that is too small the smallest, and the sign stays; an exact zero becomes the
// smallest positive number.
//
// In hardware a Float is its bits, and FloatCircuit computes with them. The native model holds it
// as the double of the same value and computes in double if that provably gives the same bits: this
// is several times faster, and it checks the circuit independently.
#pragma once

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "hls/dot_circuit.h"
#include "hls/float_circuit.h"
#include "hls/int.h"
#include "hls/target.h"

namespace hls {

template <unsigned E, unsigned M, Rounding R = Rounding::kNearestEven>
class Float {
  static_assert(E >= 2 && E <= 10, "a Float has 2 to 10 exponent bits, so that a double holds it");
  static_assert(M >= 2 && M <= 52, "a Float has 2 to 52 mantissa bits, so that a double holds it");
  static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
                "the native model computes in IEEE doubles, each operation rounded to 53 bits");

 public:
  using Circuit = FloatCircuit<E, M, R>;
  using Bits = typename Circuit::Bits;
  static constexpr unsigned kExponentBits = E;
  static constexpr unsigned kMantissaBits = M;
  static constexpr Rounding kRounding = R;
  static constexpr unsigned kLeafWidth = 1 + E + M;
  static constexpr int kBias = Circuit::kBias;
  /// The format that holds every product of two of these numbers exactly.
  using Product = Float<E + 2, 2 * M + 1, R>;

  /// The smallest positive number: all bits zero.
  constexpr Float() = default;
  static constexpr Float from_bits(Bits bits) {
    if constexpr (kLowered) {
      return Float(bits);
    } else {
      return Float(to_double(bits));
    }
  }
  static constexpr Float smallest() { return Float{}; }
  static constexpr Float one() {
    return from_bits(Circuit::assemble(false, concat(uint<E>::of_raw(kBias), uint<M>(0))));
  }
  /// The largest positive number.
  static constexpr Float largest() {
    return from_bits(Circuit::assemble(false, uint<E + M>::ones()));
  }

  /// Conversion from another format, rounded and saturated like a result of this one.
  template <unsigned E2, unsigned M2, Rounding R2>
  constexpr explicit Float(Float<E2, M2, R2> other) {
    if constexpr (kLowered) {
      value_ = Circuit::template convert<E2, M2, R2>(other.bits());
    } else {
      value_ = rounded(other.to_double());
    }
  }
  /// Both zeros give the smallest positive number, infinities and NaNs the largest magnitude. In
  /// hardware for constants only.
  static constexpr Float from_double(double value) {
    return from_bits(Circuit::from_double(value));
  }
  static constexpr Float from_float(float value) { return from_double(value); }
  /// An unsigned integer; 0 gives the smallest positive number.
  template <unsigned W>
  static constexpr Float from_uint(uint<W> integer) {
    if constexpr (!kLowered && W <= 53) {
      return Float(rounded(static_cast<double>(integer.to_u64())));
    } else {
      return from_bits(Circuit::from_uint(integer));
    }
  }

  constexpr Bits bits() const {
    if constexpr (kLowered) {
      return value_;
    } else {
      return to_bits(value_);
    }
  }
  constexpr bool sign() const { return kLowered ? Circuit::sign(bits()) : to_double() < 0; }
  constexpr uint<E> exponent() const { return Circuit::exponent(bits()); }
  constexpr uint<M> mantissa() const { return Circuit::mantissa(bits()); }
  /// Exponent and mantissa; magnitudes order as these integers do.
  constexpr uint<E + M> magnitude() const { return Circuit::magnitude(bits()); }
  /// Exact.
  constexpr double to_double() const {
    if constexpr (kLowered) {
      return to_double(value_);
    } else {
      return value_;
    }
  }
  constexpr Bits leaf_bits() const { return bits(); }
  static constexpr Float from_leaf_bits(Bits bits) { return from_bits(bits); }

  friend constexpr Float abs(Float a) { return from_bits(Circuit::assemble(false, a.magnitude())); }
  constexpr Float operator-() const {
    if constexpr (kLowered) {
      return from_bits(Circuit::assemble(!sign(), magnitude()));
    } else {
      return Float(-value_);
    }
  }

  friend constexpr Float operator+(Float a, Float b) {
    if constexpr (kInDouble) {
      return Float(rounded(a.value_ + b.value_));
    } else {
      return from_bits(Circuit::sum(a.bits(), b.bits()));
    }
  }
  friend constexpr Float operator-(Float a, Float b) { return a + -b; }
  friend constexpr Float operator*(Float a, Float b) {
    if constexpr (kInDouble) {
      return Float(rounded(a.value_ * b.value_));
    } else {
      return from_bits(Circuit::product(a.bits(), b.bits()));
    }
  }
  friend constexpr Float operator/(Float a, Float b) {
    if constexpr (kInDouble) {
      return Float(rounded(a.value_ / b.value_));
    } else {
      return from_bits(Circuit::quotient(a.bits(), b.bits()));
    }
  }
  /// The square root of the magnitude: never negative.
  friend Float sqrt(Float a) {
    if constexpr (kInDouble) {
      return Float(rounded(std::sqrt(std::abs(a.value_))));
    } else {
      return from_bits(Circuit::root(a.bits()));
    }
  }

  friend constexpr Product exact_product(Float a, Float b) {
    if constexpr (kLowered) {
      return Product::from_bits(Circuit::exact_product(a.bits(), b.bits()));
    } else {
      return Product(a.value_ * b.value_);
    }
  }
  /// a - b of a longer format, rounded once to this one.
  template <unsigned E2, unsigned M2, Rounding R2>
  static constexpr Float of_difference(Float<E2, M2, R2> a, Float<E2, M2, R2> b) {
    static_assert(M2 > M, "the format of the operands is the longer one");
    if constexpr (kLowered) {
      return from_bits(FloatCircuit<E2, M2, R2>::template sum_to<Circuit>(a.bits(), (-b).bits()));
    } else {
      return Float(rounded(to_odd(a.value_, -b.value_)));
    }
  }
  /// a[0] b[0] + ... + a[N - 1] b[N - 1], and `addend` where `adds`, rounded once. Each term is cut
  /// towards zero to a multiple of 2^(x - kKept) (hls/dot_circuit.h), x being the largest sum of
  /// two factors' exponents, or the addend's exponent. The result is off by at most one rounding
  /// and N + 1 such multiples, unless it saturates.
  template <unsigned N>
  static constexpr Float of_dot(const Float (&a)[N], const Float (&b)[N], Float addend, bool adds) {
    using Dot = DotCircuit<E, M, R, N>;
    if constexpr (kInDouble && E <= 9) {  // so that doubles hold the scales too
      return of_dot_in_double<Dot::kKept>(a, b, addend, adds);
    } else {
      Bits x[N], y[N];
      for (unsigned i = 0; i < N; ++i) x[i] = a[i].bits(), y[i] = b[i].bits();
      return from_bits(Dot::dot(x, y, addend.bits(), adds));
    }
  }

  /// The positive number that lies `Steps` of the mantissa above a magnitude, or below it;
  /// saturated.
  template <unsigned Steps>
  constexpr Float moved_up() const {
    if constexpr (kLowered) {
      return from_bits(Circuit::template moved_up<Steps>(bits()));
    } else {
      return Float(std::bit_cast<double>(
          std::min(pattern() + (std::uint64_t{Steps} << kDropped), kHighest)));
    }
  }
  template <unsigned Steps>
  constexpr Float moved_down() const {
    if constexpr (kLowered) {
      return from_bits(Circuit::template moved_down<Steps>(bits()));
    } else {
      return Float(
          std::bit_cast<double>(std::max(pattern() - (std::uint64_t{Steps} << kDropped), kLowest)));
    }
  }

  /// The same by a number of steps that is known only to the circuit: up where it is positive.
  template <unsigned W>
    requires(W < E + M)
  constexpr Float moved(sint<W> steps) const {
    if constexpr (kLowered) {
      return from_bits(Circuit::moved(bits(), steps));
    } else {
      const auto sum = static_cast<std::int64_t>(pattern()) +
                       static_cast<std::int64_t>(steps.to_s64()) * (std::int64_t{1} << kDropped);
      return Float(
          std::bit_cast<double>(std::clamp(static_cast<std::uint64_t>(sum), kLowest, kHighest)));
    }
  }

  /// Different bits are different numbers, so all comparisons are exact and total.
  friend constexpr bool operator==(Float a, Float b) { return a.value_ == b.value_; }
  friend constexpr bool operator<(Float a, Float b) {
    if constexpr (kLowered) {
      return Circuit::less(a.value_, b.value_);
    } else {
      return a.value_ < b.value_;
    }
  }
  friend constexpr bool operator>(Float a, Float b) { return b < a; }
  friend constexpr bool operator<=(Float a, Float b) { return !(b < a); }
  friend constexpr bool operator>=(Float a, Float b) { return !(a < b); }

 private:
  template <unsigned E2, unsigned M2, Rounding R2>
  friend class Float;

  using Value = std::conditional_t<kLowered, Bits, double>;
  /// Whether an operation in double, rounded a second time to M + 1 bits, gives the result of a
  /// single rounding: to nearest it does if 2 (M + 1) + 2 <= 53 (Figueroa, "When is double rounding
  /// innocuous?", 1995).
  static constexpr bool kInDouble =
      !kLowered && R == Rounding::kNearestEven && 2 * (M + 1) + 2 <= 53;

  // Bits of a double's pattern: those behind our mantissa, the sign, and what our smallest and our
  // largest number are.
  static constexpr unsigned kDropped = 52 - M;
  static constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;
  static constexpr std::uint64_t kLowest = std::uint64_t{1023 - kBias} << 52;
  static constexpr std::uint64_t kHighest =
      kLowest + (((std::uint64_t{1} << (E + M)) - 1) << kDropped);

  constexpr explicit Float(Value value) : value_(value) {}

  static constexpr double to_double(Bits bits) {
    const std::uint64_t sign = bits.to_u64() >> (E + M) << 63;
    return std::bit_cast<double>(sign |
                                 ((Circuit::magnitude(bits).to_u64() << kDropped) + kLowest));
  }
  static constexpr Bits to_bits(double value) {
    const auto pattern = std::bit_cast<std::uint64_t>(value);
    return Bits::of_raw(static_cast<typename Bits::Raw>(
        pattern >> 63 << (E + M) | ((pattern & ~kSignBit) - kLowest) >> kDropped));
  }
  /// Of the magnitude's double.
  constexpr std::uint64_t pattern() const {
    return std::bit_cast<std::uint64_t>(value_) & ~kSignBit;
  }
  /// Multiples of 2^(x - Kept) as integers, whose sum is exact.
  template <unsigned Kept, unsigned N>
  static constexpr Float of_dot_in_double(const Float (&a)[N], const Float (&b)[N], Float addend,
                                          bool adds) {
    int largest = adds ? addend.unbiased() : 2 * -kBias;
    for (unsigned i = 0; i < N; ++i) {
      largest = std::max(largest, a[i].unbiased() + b[i].unbiased());
    }
    const double scale = power_of_two(static_cast<int>(Kept) - largest);
    std::int64_t sum = adds ? static_cast<std::int64_t>(addend.value_ * scale) : 0;
    for (unsigned i = 0; i < N; ++i) {
      sum += static_cast<std::int64_t>(a[i].value_ * b[i].value_ * scale);
    }
    return Float(
        rounded(static_cast<double>(sum) * power_of_two(largest - static_cast<int>(Kept))));
  }
  constexpr int unbiased() const { return static_cast<int>(pattern() >> 52) - 1023; }
  static constexpr double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  }
  /// a + b in a double whose last bit is set if the sum is not exact: rounded again to less, this
  /// gives what rounding the exact sum would (Boldo, Melquiond, "Emulation of FMA and correctly
  /// rounded sums: proved algorithms using rounding to odd", 2008). What is lost is found by
  /// Knuth's TwoSum.
  static constexpr double to_odd(double a, double b) {
    const double sum = a + b;
    const double from_b = sum - a;
    const double lost = (a - (sum - from_b)) + (b - from_b);
    const auto bits = std::bit_cast<std::uint64_t>(sum);
    if (lost == 0 || (bits & 1) != 0) return sum;
    return std::bit_cast<double>((lost < 0) == (sum < 0) ? bits + 1 : bits - 1);
  }
  /// To M + 1 bits, saturated; a positive zero becomes the smallest number.
  static constexpr double rounded(double value) {
    auto pattern = std::bit_cast<std::uint64_t>(value);
    if constexpr (R == Rounding::kNearestEven && kDropped > 0) {
      // A carry out of the mantissa is the next exponent.
      pattern += (std::uint64_t{1} << (kDropped - 1)) - 1 + (pattern >> kDropped & 1);
    }
    const auto magnitude = std::bit_cast<double>(pattern >> kDropped << kDropped & ~kSignBit);
    const double low = std::bit_cast<double>(kLowest);
    const double high = std::bit_cast<double>(kHighest);
    return __builtin_copysign(std::min(std::max(magnitude, low), high), value);
  }

  Value value_ = from_bits(Bits{}).value_;
};

}  // namespace hls
