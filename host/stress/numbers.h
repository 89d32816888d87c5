// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of a core as the host meets them: a sign, exponent bits, mantissa bits under a hidden
// one, no zero (hls/float.h). For putting vertices and rays exactly where the core has numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace dynrt::host::stress {

struct Numbers {
  int exponent_bits = 7;
  int mantissa_bits = 16;

  int bias() const { return (1 << (exponent_bits - 1)) - 1; }
  double smallest() const { return std::ldexp(1.0, -bias()); }
  double largest() const {
    return std::ldexp(2.0 - std::ldexp(1.0, -mantissa_bits), (1 << exponent_bits) - 1 - bias());
  }
  /// To the nearest number, saturated; zero becomes the smallest.
  double rounded(double x) const {
    if (x == 0) return smallest();
    int exponent = 0;
    const double fraction = std::frexp(std::abs(x), &exponent);
    const double digits = std::nearbyint(std::ldexp(fraction, mantissa_bits + 1));
    const double magnitude = std::ldexp(digits, exponent - mantissa_bits - 1);
    return std::copysign(std::clamp(magnitude, smallest(), largest()), x);
  }
  /// The nearest number, but zero stays zero.
  double on_grid(double x) const { return x == 0 ? 0 : rounded(x); }
  glm::dvec3 on_grid(const glm::dvec3& p) const { return {on_grid(p.x), on_grid(p.y), on_grid(p.z)}; }
  /// Of the bits of a number.
  double number(std::uint32_t bits) const {
    const std::uint32_t mantissa = bits & ((1u << mantissa_bits) - 1);
    const std::uint32_t exponent = (bits >> mantissa_bits) & ((1u << exponent_bits) - 1);
    const double magnitude = std::ldexp(1.0 + std::ldexp(mantissa, -mantissa_bits),
                                        static_cast<int>(exponent) - bias());
    return (bits >> (mantissa_bits + exponent_bits)) != 0 ? -magnitude : magnitude;
  }
  /// One step of the mantissa, of 1.
  double step() const { return std::ldexp(1.0, -mantissa_bits); }
};

}  // namespace dynrt::host::stress
