// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The passes of the back end: each takes a netlist and returns one that computes the same. Their
// order is in pipeline.cpp.
#pragma once

#include "netlist/netlist.h"
#include "schedule/delay_model.h"

namespace hlsc {

/// Chains of and, or, xor, and of muxes whose first true condition decides, become trees that
/// combine the earliest values first. A loop with `break` makes such chains.
Netlist balance_chains(const Netlist& netlist);

/// Divisions become digit recurrences, one subtraction a digit, without the digits that are known
/// to be zero: restoring, or non-restoring where the device adds and subtracts in one carry chain
/// (M. Ercegovac, T. Lang, "Division and Square Root: Digit-Recurrence Algorithms and
/// Implementations", 1994).
Netlist expand_divisions(const Netlist& netlist, const DelayModel& delay);

/// Products that fit no hard multiplier become sums of smaller ones or of shifted rows; products by
/// constants of few digits become additions, in the canonical signed digits of G. Reitwiesner
/// ("Binary Arithmetic", Advances in Computers 1, 1960).
Netlist split_products(const Netlist& netlist, const DelayModel& delay);

/// Shifts by a variable and leading-zero counts become layers of muxes, so that a stage can end
/// between two layers. A value shifted by its own leading zeros shares the layers of the count.
Netlist expand_shifts(const Netlist& netlist);

/// An addition of a selected negation, into which optimisers turn `s ? a - b : a + b`, becomes
/// kAddSub: one carry chain instead of two. This pass is the last, as the builder does not know
/// kAddSub.
Netlist merge_add_sub(const Netlist& netlist);

}  // namespace hlsc
