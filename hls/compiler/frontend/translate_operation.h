// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One LLVM instruction as nodes: arithmetic, comparisons, casts, selects, and the intrinsics that
// LLVM's passes leave behind.
#pragma once

#include <llvm/IR/Instruction.h>

#include <functional>
#include <optional>

#include "netlist/builder.h"

namespace hlsc {

using Operand = std::function<NodeId(const llvm::Value*)>;

/// The instruction's value; nothing if the netlist has no such operation.
std::optional<NodeId> translate_operation(const llvm::Instruction& instruction, Builder& builder,
                                          const Operand& operand);

/// Calls of intrinsics and of the functions that stand for divisions.
std::optional<NodeId> translate_call(const llvm::Instruction& call, Builder& builder,
                                     const Operand& operand);

}  // namespace hlsc
