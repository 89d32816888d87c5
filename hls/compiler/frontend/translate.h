// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// From one block of pure LLVM IR to the netlist: every instruction becomes nodes, every sink a
// write, a row access or a register's next value. Undefined values become zero.
#pragma once

#include <string>

#include "frontend/source_lines.h"
#include "frontend/transaction.h"
#include "netlist/netlist.h"

namespace hlsc {

Netlist translate(const Transaction& transaction, const std::vector<llvm::APInt>& resets,
                  const SourceLines& lines);

}  // namespace hlsc
