// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The state of the lowering while the unit is LLVM IR: the function that is one transaction, the
// unit's members, and the meaning of the calls of "endpoint" functions in it. An endpoint is an
// undefined function through which a value enters (source) or leaves (sink) the transaction.
// Sources are pure; sinks are called once each, in the exit block.
#pragma once

#include <llvm/ADT/DenseMap.h>
#include <llvm/IR/Function.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <memory>
#include <string>
#include <vector>

#include "frontend/source_lines.h"
#include "frontend/unit_layout.h"

namespace hlsc {

enum class EndpointKind : std::uint8_t {
  kToken,         ///< source: bits of an In's token
  kConfig,        ///< source: bits of a Config
  kRow,           ///< source: bits of the row that a RAM port fetched
  kRegister,      ///< source: a register's value before the transaction
  kReadEnable,    ///< sink, 1 bit: the RAM port is read
  kReadAddress,   ///< sink
  kWriteEnable,   ///< sink, 1 bit: the Out or the RAM port is written
  kWriteAddress,  ///< sink
  kWriteBits,     ///< sink: bits of the token or row
  kNext,          ///< sink: a register's value after the transaction
  kCheck,  ///< sink, 1 bit: must turn out to be constant 0, otherwise checks[index] is an error
};

struct Endpoint {
  EndpointKind kind;
  unsigned index;    ///< of the port, the register or the check
  unsigned low = 0;  ///< lowest bit within the token, row or value
};

struct Check {
  SourceLine where;
  std::string message;
};

struct Transaction {
  std::unique_ptr<llvm::LLVMContext> context;
  std::unique_ptr<llvm::Module> module;
  llvm::Function* function = nullptr;  ///< the whole transaction; its argument is unused
  llvm::AllocaInst* unit = nullptr;    ///< the unit object within it, until it is promoted
  UnitLayout layout;
  std::vector<Check> checks;
  llvm::DenseMap<const llvm::Function*, Endpoint> endpoints;

  /// The endpoint that a call goes to, or null.
  const Endpoint* endpoint_of(const llvm::Instruction& instruction) const {
    const auto* call = llvm::dyn_cast<llvm::CallInst>(&instruction);
    const llvm::Function* callee = call ? call->getCalledFunction() : nullptr;
    const auto found = callee ? endpoints.find(callee) : endpoints.end();
    return found == endpoints.end() ? nullptr : &found->second;
  }
  /// A pure function without arguments that returns `width` bits; the same one for the same
  /// endpoint.
  llvm::Function* source(Endpoint endpoint, unsigned width);
  /// A function that takes `width` bits.
  llvm::Function* sink(Endpoint endpoint, unsigned width);
};

}  // namespace hlsc
