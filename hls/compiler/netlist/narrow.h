// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Rebuilds a netlist with only the bits of each node that are used, and without unused nodes. LLVM
// keeps widths of the source (an i17 sum may be an i32 one); additions, products, logic and muxes
// do not need high result bits that are never used.
#pragma once

#include "netlist/netlist.h"

namespace hlsc {

/// Also makes registers narrower whose high bits are always zero (an `unsigned` counter to 10, an
/// enum), and drops row reads whose rows are never used.
Netlist narrow(const Netlist& netlist);

}  // namespace hlsc
