// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Small facts about the netlist's operations, and constants as text.
#pragma once

#include <string>

#include "netlist/netlist.h"

namespace hlsc {

/// "add", "mux" ...: stem of the names of unnamed signals.
const char* op_name(Op op);
/// The number of operands; -1: one or more.
int operand_count(Op op);
/// A value that is not computed from others: constant, port, register or row.
bool is_source(Op op);
/// Only regroups bits: costs neither time nor area.
bool is_wiring(Op op);
/// Has rows: a RAM, a register file or the end of a RAM.
bool is_ram(PortKind kind);
/// Bits of the address of a RAM (at least one).
unsigned address_width(unsigned rows);
/// Digits of a constant in base 16, without a prefix.
std::string to_hex(const Bits& bits);

}  // namespace hlsc
