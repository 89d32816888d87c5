// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Reciprocals of significands by a table of 16 rows, a line in each row and one Newton step: three
// small products, which run while a dividend is still on its way. A quotient is then a product, and
// the remainder, a second one, says by how much it is too small (P. Markstein, "Computation of
// Elementary Functions on the IBM RISC System/6000 Processor", 1990, has the principle).
#pragma once

#include <array>
#include <cstdint>

#include "hls/int.h"

namespace hls {

/// Bits of the mantissas for which the widths below are made.
inline constexpr unsigned kLeastReciprocal = 6;
inline constexpr unsigned kMostReciprocal = 16;

/// For significands y in [1, 2) with M bits behind the point, for which all products fit a signed
/// 18x18 multiplier.
template <unsigned M>
struct SignificandReciprocal {
  static_assert(M >= kLeastReciprocal && M <= kMostReciprocal);

  static constexpr unsigned kFractionBits = M + 2;  ///< of the result

  /// r < 1 in units of 2^-kFractionBits with 0 < 1 - r y < kError 2^-(M + 1).
  static constexpr double kError = 1.25;
  static constexpr uint<kFractionBits> below(uint<M + 1> y) {
    const uint<kStartBits> start = line(y);
    // y start - 1 lies within 2^-(kHalf + 1) of zero, so the product's low bits say it. Ones in
    // place of those that are dropped, and the one that is taken from the step, keep the result
    // below 1 / y.
    const uint<M + 4> product = (y * start).template trunc<M + 4>();
    const auto error = concat(product.template bits<M + 3, kHalf>(), uint<kOnes>::ones());
    const auto step = (start.to_signed() * error.as_signed()).as_unsigned();
    constexpr unsigned kDropped = kHalf + 6 + kOnes;
    const auto kept = step.template bits<decltype(step)::kWidth - 1, kDropped>();
    const auto before = concat(start, uint<M - kHalf - 1>(0)).to_signed();
    const auto taken = concat(kept, uint<1>(1)).as_signed();
    return (before - taken).as_unsigned().template bits<kFractionBits, 1>();
  }

 private:
  static constexpr unsigned kHalf = (M + 1) / 2;
  static constexpr unsigned kIndexBits = 4;
  static constexpr unsigned kOnes = 6;
  static constexpr unsigned kStartBits = kHalf + 4;
  static constexpr unsigned kSlopeBits = kHalf - 1;
  static constexpr unsigned kAlongBits = kHalf - 1 < M - 4 ? kHalf - 1 : M - 4;

  /// The reciprocal to about kHalf + 1 bits: of the row's line, which crosses 1 / y twice, less
  /// about half of what is lost with the bits of y behind kAlongBits.
  static constexpr uint<kStartBits> line(uint<M + 1> y) {
    const auto row = y.template bits<M - 1, M - kIndexBits>();
    const auto along = y.template bits<M - kIndexBits - 1, M - kIndexBits - kAlongBits>();
    const auto fall = column<kSlopeBits>(kSlopes, row) * along;
    // The fall has units of 2^-(kHalf + 2 + kAlongBits).
    const auto fallen = fall.template bits<kSlopeBits + kAlongBits - 1, kAlongBits - 2>();
    return (column<kStartBits>(kHeights, row) - fallen).as_unsigned().template trunc<kStartBits>();
  }

  using Rows = std::array<unsigned, 1u << kIndexBits>;
  /// Of row i, which begins at a = (16 + i) / 16 and ends at b = (17 + i) / 16: what the line
  /// through (a, 1 / a) and (b, 1 / b) falls, in units of 2^-(kHalf + 2).
  static constexpr Rows kSlopes = [] {
    Rows rows{};
    for (unsigned i = 0; i < rows.size(); ++i) {
      const unsigned ab = (16 + i) * (17 + i);
      rows[i] = ((32u << (kHalf + 2)) + ab) / (2 * ab);
    }
    return rows;
  }();
  /// Its height at a, rounded down, in units of 2^-kStartBits. The line through both ends lies
  /// above 1 / y; half its greatest distance, about 1 / (1024 a b (a + b)), is taken away.
  static constexpr Rows kHeights = [] {
    Rows rows{};
    for (unsigned i = 0; i < rows.size(); ++i) {
      const std::int64_t a = 16 + i, b = 17 + i;
      const std::int64_t below = a * b * (a + b) << kAlongBits;
      const std::int64_t above = ((16 * b * (a + b) - 4) << kAlongBits) - 8 * (a + b);
      rows[i] = static_cast<unsigned>((above << kStartBits) / below);
    }
    return rows;
  }();

  /// A row's number, each bit of which is a table of 16 bits: one LUT.
  template <unsigned W>
  static constexpr uint<W> column(const Rows& rows, uint<kIndexBits> row) {
    if constexpr (W == 1) {
      return uint<1>(column_bit(rows, 0, row));
    } else {
      return concat(uint<1>(column_bit(rows, W - 1, row)), column<W - 1>(rows, row));
    }
  }
  static constexpr bool column_bit(const Rows& rows, unsigned bit, uint<kIndexBits> row) {
    unsigned table = 0;
    for (unsigned i = 0; i < rows.size(); ++i) table |= (rows[i] >> bit & 1) << i;
    return (uint<16>::from(table) >> row).template bit<0>();
  }
};

}  // namespace hls
