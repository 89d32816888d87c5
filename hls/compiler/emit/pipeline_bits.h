// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The bits of a cell that exist in each stage, and their way there: registers, one a stage, or, if
// they are not used for many stages, a delay (rtl/lib/hls_delay.v), which a device can hold in LUT
// RAM.
#pragma once

#include <vector>

#include "schedule/schedule.h"

namespace hlsc {

/// A step on a value's way: bits [low, high] of a cell, from one stage to another.
struct Carry {
  CellId cell;
  int from;
  int to;  ///< from + 1: a register; more: a delay
  unsigned low;
  unsigned high;
  unsigned bits;  ///< of them in use
};

/// A delay, with its counter, pays from this number of bits that go the same way.
inline constexpr unsigned kNarrowestDelay = 8;

/// Ordered by stage of arrival, then by cell.
/// Bits that are not used for more than `longest_shift` stages go through a delay, which lies
/// between two registers.
std::vector<Carry> carries(const Circuit& circuit, const Schedule& schedule, int longest_shift);

/// Of each cell: whether it is still and a cell that is not still takes it, so that a register has
/// it.
std::vector<bool> held_still(const Circuit& circuit);

}  // namespace hlsc
