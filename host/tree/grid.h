// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The grid of numbers that a split can be: those of Float<7, 16>, numbered in ascending order. The
// tree builders work on these codes, so that every plane they try is already rounded and no
// triangle changes sides when the tree is written. Code c >= 0 is the positive number with the bits
// c, code c < 0 the negative number with the magnitude bits -1 - c; zero lies between -1 and 0.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace dynrt::host {

using Code = std::int32_t;

inline constexpr int kGridMantissaBits = 16;
inline constexpr int kGridBias = 63;
inline constexpr Code kMaxCode = (1 << 23) - 1;
inline constexpr Code kMinCode = -1 - kMaxCode;

/// The number of a code, exactly.
inline double grid_value(Code code) {
  const auto magnitude = static_cast<std::uint64_t>(code >= 0 ? code : -1 - code);
  const std::uint64_t bits = (magnitude << (52 - kGridMantissaBits)) +
                             (static_cast<std::uint64_t>(1023 - kGridBias) << 52) +
                             (code >= 0 ? std::uint64_t{0} : std::uint64_t{1} << 63);
  return std::bit_cast<double>(bits);
}

/// The smallest and the largest magnitude of the grid.
inline double grid_smallest() { return grid_value(0); }
inline double grid_largest() { return grid_value(kMaxCode); }

namespace detail {
/// Magnitude bits of a positive number, rounded up if asked; -1 below the smallest one.
inline std::int64_t grid_magnitude(double positive, bool up) {
  const auto bits = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(positive));
  const std::int64_t based = bits - (static_cast<std::int64_t>(1023 - kGridBias) << 52);
  const int shift = 52 - kGridMantissaBits;
  const std::int64_t floor = based >> shift;
  const std::int64_t rounded = up && based != (floor << shift) ? floor + 1 : floor;
  return rounded < -1 ? -1 : rounded > kMaxCode ? kMaxCode : rounded;
}
}  // namespace detail

/// The largest grid number at or below x, and the smallest at or above it. x is finite and at most
/// the largest magnitude; zero and what is closer to it than 2^-63 has -1 below and 0 above.
inline Code floor_code(double x) {
  if (x > 0) return static_cast<Code>(detail::grid_magnitude(x, false));
  if (x == 0) return -1;
  return -1 - static_cast<Code>(std::max<std::int64_t>(detail::grid_magnitude(-x, true), 0));
}
inline Code ceil_code(double x) { return -1 - floor_code(-x); }

}  // namespace dynrt::host
