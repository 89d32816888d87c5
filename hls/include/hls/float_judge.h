// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The judge of the floats: the right result of an operation on the patterns of a Float<E, M>, by
// MPFR and without float.h. MPFR rounds to M + 1 bits with an unbounded exponent; the judge takes
// the pattern apart and puts it together, saturating. For tests only.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace hls::testing {

class FloatJudge {
 public:
  FloatJudge(unsigned exponent_bits, unsigned mantissa_bits, bool nearest)
      : e_(exponent_bits),
        m_(mantissa_bits),
        bias_((1L << (exponent_bits - 1)) - 1),
        rounding_(nearest ? MPFR_RNDN : MPFR_RNDZ) {
    mpfr_inits2(static_cast<mpfr_prec_t>(m_ + 1), a_, b_, result_, nullptr);
    mpfr_inits2(kSumBits, sum_, term_, cut_, nullptr);
  }
  ~FloatJudge() { mpfr_clears(a_, b_, result_, sum_, term_, cut_, nullptr); }
  FloatJudge(const FloatJudge&) = delete;
  FloatJudge& operator=(const FloatJudge&) = delete;

  std::uint64_t add(std::uint64_t a, std::uint64_t b) { return binary(mpfr_add, a, b); }
  std::uint64_t sub(std::uint64_t a, std::uint64_t b) { return binary(mpfr_sub, a, b); }
  std::uint64_t mul(std::uint64_t a, std::uint64_t b) { return binary(mpfr_mul, a, b); }
  std::uint64_t div(std::uint64_t a, std::uint64_t b) { return binary(mpfr_div, a, b); }
  /// Of the magnitude.
  std::uint64_t sqrt(std::uint64_t a) {
    decode(a, a_);
    mpfr_abs(a_, a_, MPFR_RNDN);
    mpfr_sqrt(result_, a_, rounding_);
    return encode();
  }
  /// Of numbers in another format.
  std::uint64_t product_of(FloatJudge& other, std::uint64_t a, std::uint64_t b) {
    return binary_of(other, mpfr_mul, a, b);
  }
  std::uint64_t difference_of(FloatJudge& other, std::uint64_t a, std::uint64_t b) {
    return binary_of(other, mpfr_sub, a, b);
  }
  /// a[0] b[0] + ... and, if there is one, the addend, as Float::of_dot defines it: each term cut
  /// towards zero to a multiple of 2^(x - kept).
  std::uint64_t dot(const std::uint64_t* a, const std::uint64_t* b, unsigned terms,
                    const std::uint64_t* addend, unsigned kept) {
    sum_terms(a, b, terms, addend, largest_exponent(a, b, terms, addend) - kept);
    mpfr_set(result_, sum_, rounding_);
    return encode();
  }
  /// Whether a pattern is off the exact sum by at most a rounding (half a unit of its last place,
  /// or one where results are cut) and terms + 1 multiples of 2^(x - kept), or is saturated.
  bool dot_is_near(std::uint64_t bits, const std::uint64_t* a, const std::uint64_t* b,
                   unsigned terms, const std::uint64_t* addend, unsigned kept) {
    const std::uint64_t magnitude = bits % (1ull << (e_ + m_));
    if (magnitude == 0 || magnitude + 1 == 1ull << (e_ + m_)) return true;
    sum_terms(a, b, terms, addend, kExact);
    decode(bits, a_);
    mpfr_sub(sum_, sum_, a_, MPFR_RNDN);
    const long rounding = mpfr_get_exp(a_) - 1 - static_cast<long>(m_);
    mpfr_set_ui_2exp(term_, 1, rounding_ == MPFR_RNDN ? rounding - 1 : rounding, MPFR_RNDN);
    mpfr_set_ui_2exp(cut_, terms + 1,
                     largest_exponent(a, b, terms, addend) - static_cast<long>(kept), MPFR_RNDN);
    mpfr_add(term_, term_, cut_, MPFR_RNDN);
    return mpfr_cmpabs(sum_, term_) <= 0;
  }
  /// Less than, equal to or greater than 0 as a is to b.
  int compare(std::uint64_t a, std::uint64_t b) {
    decode(a, a_);
    decode(b, b_);
    return mpfr_cmp(a_, b_);
  }
  /// Not for infinities and NaNs.
  std::uint64_t from_double(double value) {
    mpfr_set_d(result_, value, rounding_);
    return encode();
  }
  std::uint64_t from_uint(std::uint64_t value) {
    mpfr_set_uj(result_, value, rounding_);
    return encode();
  }
  /// From a pattern of another format.
  std::uint64_t convert(FloatJudge& other, std::uint64_t bits) {
    other.decode(bits, other.a_);
    mpfr_set(result_, other.a_, rounding_);
    return encode();
  }
  double to_double(std::uint64_t bits) {
    decode(bits, a_);
    return mpfr_get_d(a_, MPFR_RNDN);
  }

 private:
  using Function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
  std::uint64_t binary(Function f, std::uint64_t a, std::uint64_t b) {
    decode(a, a_);
    decode(b, b_);
    f(result_, a_, b_, rounding_);
    return encode();
  }
  template <class F>
  std::uint64_t binary_of(FloatJudge& other, F f, std::uint64_t a, std::uint64_t b) {
    other.decode(a, other.a_);
    other.decode(b, other.b_);
    f(result_, other.a_, other.b_, rounding_);
    return encode();
  }
  long exponent_of(std::uint64_t bits) const {
    return static_cast<long>((bits >> m_) % (1ull << e_)) - bias_;
  }
  long largest_exponent(const std::uint64_t* a, const std::uint64_t* b, unsigned terms,
                        const std::uint64_t* addend) const {
    long largest = addend != nullptr ? exponent_of(*addend) : -2 * bias_;
    for (unsigned i = 0; i < terms; ++i) {
      largest = std::max(largest, exponent_of(a[i]) + exponent_of(b[i]));
    }
    return largest;
  }
  /// Into sum_, of terms cut to multiples of 2^unit.
  void sum_terms(const std::uint64_t* a, const std::uint64_t* b, unsigned terms,
                 const std::uint64_t* addend, long unit) {
    const auto add_term = [&] {
      if (unit != kExact) {
        mpfr_mul_2si(term_, term_, -unit, MPFR_RNDN);
        mpfr_trunc(term_, term_);
        mpfr_mul_2si(term_, term_, unit, MPFR_RNDN);
      }
      mpfr_add(sum_, sum_, term_, MPFR_RNDN);
    };
    mpfr_set_zero(sum_, 1);
    for (unsigned i = 0; i < terms; ++i) {
      decode(a[i], a_);
      decode(b[i], b_);
      mpfr_mul(term_, a_, b_, MPFR_RNDN);
      add_term();
    }
    if (addend == nullptr) return;
    decode(*addend, a_);
    mpfr_set(term_, a_, MPFR_RNDN);
    add_term();
  }
  void decode(std::uint64_t bits, mpfr_ptr value) const {
    const std::uint64_t significand = (bits % (1ull << m_)) + (1ull << m_);
    mpfr_set_uj_2exp(value, significand, exponent_of(bits) - static_cast<long>(m_), MPFR_RNDN);
    if ((bits >> (e_ + m_)) & 1) mpfr_neg(value, value, MPFR_RNDN);
  }
  std::uint64_t encode() {
    if (mpfr_zero_p(result_)) return 0;
    const std::uint64_t sign = mpfr_signbit(result_) ? 1ull << (e_ + m_) : 0;
    const long exponent = mpfr_get_exp(result_) - 1 + bias_;  // MPFR's significand is below one
    if (exponent < 0) return sign;
    if (exponent >= 1L << e_) return sign + (1ull << (e_ + m_)) - 1;
    mpfr_abs(result_, result_, MPFR_RNDN);
    mpfr_set_exp(result_, static_cast<mpfr_exp_t>(m_ + 1));
    const std::uint64_t significand = mpfr_get_uj(result_, MPFR_RNDN);
    return sign + (static_cast<std::uint64_t>(exponent) << m_) + (significand - (1ull << m_));
  }

  static constexpr long kExact = std::numeric_limits<long>::min();  ///< a unit that cuts nothing
  static constexpr mpfr_prec_t kSumBits = 4096;  ///< of a sum of products of any exponents

  unsigned e_, m_;
  long bias_;
  mpfr_rnd_t rounding_;
  mpfr_t a_, b_, result_, sum_, term_, cut_;
};

}  // namespace hls::testing
