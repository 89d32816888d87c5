// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Compares two boards to the last bit: every hit record, every pixel, every counter that does not
// depend on the order of the packets. A counter that one board lacks is a difference, and so is a
// frame without pixels or without such counters. If the boards have two configurations, or one
// without counters, only hit records and pixels are compared.
#pragma once

#include <optional>
#include <string>

#include "host/render/frame.h"

namespace dynrt::host {

/// The first difference in reading order: pixels row by row, hits before colours, then counters.
struct Difference {
  std::optional<unsigned> x, y;  ///< of a pixel; none for a counter
  std::string field;             ///< "hit", "t", .. "colour", a counter's name, or what is lacking
  std::string left, right;       ///< both values, as text

  /// One sentence, the boards named by the frames' boards.
  std::string text(const std::string& left_board, const std::string& right_board) const;
};

struct Comparison {
  std::uint64_t hits = 0;      ///< pixels hit on the left board
  std::uint64_t pixels = 0;    ///< compared
  std::uint64_t counters = 0;  ///< that both boards have
  std::uint64_t different_hits = 0;
  std::uint64_t different_pixels = 0;
  std::uint64_t different_counters = 0;  ///< or on one board only
  std::optional<Difference> first;

  bool identical() const { return !first; }
};

/// Frames of the same size; otherwise the size is the difference.
Comparison compare(const Frame& left, const Frame& right);

}  // namespace dynrt::host
