// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Makes one function of the unit: removes all parts of the IR that depend on a processor, makes all
// functions internal and always inlined, and writes the transaction itself: registers are loaded
// into a local unit object, step() is called on it, registers are stored.
#pragma once

#include "frontend/transaction.h"

namespace hlsc {

/// Refuses recursion, assembly, volatile and atomic accesses, and exceptions anywhere in what
/// step() reaches: these leave no trace or no line after inlining.
void refuse_before_inlining(const llvm::Module& module, const SourceLines& lines);

/// Drops native integer widths, target attributes, lifetime markers; marks every body alwaysinline
/// and every port access unmergeable.
void detach_from_target(llvm::Module& module);

/// Fills in transaction.function and transaction.unit.
void build_transaction(Transaction& transaction);

/// The registers' values out of the constant unit `hls_initial`, in layout order.
std::vector<llvm::APInt> read_reset_values(const Transaction& transaction);

/// Refuses conditions of variables that were never set, once locals are values.
void refuse_uninitialised(const Transaction& transaction, const SourceLines& lines);

/// Refuses everything that inlining leaves and that is neither dataflow nor a port access: calls
/// without a body, calls through pointers, floating point, global variables.
void refuse_after_inlining(const Transaction& transaction, const SourceLines& lines);

}  // namespace hlsc
