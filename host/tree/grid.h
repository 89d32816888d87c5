// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The grid of numbers that a split can be: those of a float, numbered in ascending order. The tree
// builders work on these codes, so that every plane they try is already rounded and no triangle
// changes sides when the tree is written. Code c >= 0 is the positive number with the bits c, code
// c < 0 the negative number with the magnitude bits -1 - c; zero lies between -1 and 0.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "host/format/memory_format.h"

namespace dynrt::host {

using Code = std::int32_t;

class Grid {
 public:
  /// A float with more bits than these gets coarser splits than it could have: planes need no more,
  /// and the same scene keeps the same trees.
  static constexpr unsigned kMostExponentBits = 7;
  static constexpr unsigned kMostMantissaBits = 16;

  constexpr Grid() : Grid(kMostExponentBits, kMostMantissaBits) {}
  constexpr explicit Grid(const MemoryFormat& format)
      : Grid(std::min(format.exponent_bits, kMostExponentBits),
             std::min(format.mantissa_bits, kMostMantissaBits)) {}

  constexpr unsigned mantissa_bits() const { return mantissa_bits_; }
  constexpr Code max_code() const { return max_code_; }
  constexpr Code min_code() const { return -1 - max_code_; }
  /// The smallest and the largest magnitude.
  constexpr double smallest() const { return value(0); }
  constexpr double largest() const { return value(max_code_); }

  /// The number of a code, exactly.
  constexpr double value(Code code) const {
    const auto magnitude = static_cast<std::uint64_t>(code >= 0 ? code : -1 - code);
    const std::uint64_t bits = (magnitude << (52 - mantissa_bits_)) + lowest_ +
                               (code >= 0 ? std::uint64_t{0} : std::uint64_t{1} << 63);
    return std::bit_cast<double>(bits);
  }

  /// The largest number at or below x, and the smallest at or above it. x is finite and at most the
  /// largest magnitude; zero, and numbers closer to it than the smallest, have -1 below and 0
  /// above.
  constexpr Code floor(double x) const {
    if (x > 0) return static_cast<Code>(magnitude(x, false));
    if (x == 0) return -1;
    return -1 - static_cast<Code>(std::max<std::int64_t>(magnitude(-x, true), 0));
  }
  constexpr Code ceil(double x) const { return -1 - floor(-x); }

  friend constexpr bool operator==(const Grid&, const Grid&) = default;

 private:
  constexpr Grid(unsigned exponent_bits, unsigned mantissa_bits)
      : mantissa_bits_(mantissa_bits),
        max_code_(static_cast<Code>((1u << (exponent_bits + mantissa_bits)) - 1)),
        lowest_((1024 - (std::uint64_t{1} << (exponent_bits - 1))) << 52) {}

  /// Magnitude bits of a positive number, rounded up if asked; -1 below the smallest one.
  constexpr std::int64_t magnitude(double positive, bool up) const {
    const auto bits = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(positive));
    const std::int64_t based = bits - static_cast<std::int64_t>(lowest_);
    const unsigned shift = 52 - mantissa_bits_;
    const std::int64_t down = based >> shift;
    const std::int64_t rounded = up && based != (down << shift) ? down + 1 : down;
    return std::clamp<std::int64_t>(rounded, -1, max_code_);
  }

  unsigned mantissa_bits_;
  Code max_code_;
  std::uint64_t lowest_;  ///< bits of a double: the smallest number
};

}  // namespace dynrt::host
