// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The value of each operation: the reference for constant folding, for the interpreter and so for
// every test of the lowering.
#pragma once

#include <span>

#include "netlist/netlist.h"

namespace hlsc {

/// The value of an operation that is not a source. Division by zero gives all ones.
Bits evaluate(const Node& node, std::span<const Bits> operands);

Bits extract(const Bits& from, unsigned low, unsigned width);
/// Puts `value` into bits [low +: value.width()] of `into`.
void insert(Bits& into, unsigned low, const Bits& value);
Bits invert(const Bits& a);
Bits zero_extend(const Bits& a, unsigned width);
Bits sign_extend(const Bits& a, unsigned width);
/// Number of bits up to the highest one; 0 for zero.
unsigned active_bits(const Bits& a);

}  // namespace hlsc
