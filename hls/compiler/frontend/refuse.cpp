// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <llvm/ADT/SmallPtrSet.h>
#include <llvm/Demangle/Demangle.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>

#include "error.h"
#include "frontend/compile_unit.h"
#include "frontend/port_access.h"
#include "frontend/prepare.h"
#include "frontend/refusal_messages.h"

namespace hlsc {
namespace {

std::string readable_name(const llvm::Function& function) {
  if (const llvm::DISubprogram* subprogram = function.getSubprogram()) {
    return subprogram->getName().str() + "()";
  }
  return llvm::demangle(function.getName().str());
}

/// Walks the calls from step(); a function met again on the way down calls itself.
class CallWalk {
 public:
  explicit CallWalk(const SourceLines& lines) : lines_(lines) {}

  void visit(const llvm::Function& function) {
    if (function.isDeclaration() || !done_.insert(&function).second) return;
    active_.insert(&function);
    for (const llvm::Instruction& instruction : llvm::instructions(function)) check(instruction);
    active_.erase(&function);
  }

 private:
  void check(const llvm::Instruction& instruction) {
    if (instruction.isVolatile()) throw Error(lines_.of(instruction), messages::kVolatile);
    if (instruction.isAtomic()) throw Error(lines_.of(instruction), messages::kAtomic);
    if (llvm::isa<llvm::InvokeInst, llvm::LandingPadInst, llvm::ResumeInst>(instruction)) {
      throw Error(lines_.of(instruction), messages::kExceptions);
    }
    const auto* call = llvm::dyn_cast<llvm::CallBase>(&instruction);
    if (!call) return;
    if (call->isInlineAsm()) throw Error(lines_.of(instruction), messages::kAssembly);
    const llvm::Function* callee = call->getCalledFunction();
    if (!callee) return;
    if (active_.contains(callee)) {
      throw Error(lines_.of(instruction),
                  fmt::format(messages::kRecursion, readable_name(*callee)));
    }
    visit(*callee);
  }

  const SourceLines& lines_;
  llvm::SmallPtrSet<const llvm::Function*, 32> done_;
  llvm::SmallPtrSet<const llvm::Function*, 32> active_;
};

const char* float_name(const llvm::Type* type) {
  type = type->getScalarType();
  if (type->isFloatTy()) return "float";
  if (type->isDoubleTy()) return "double";
  return type->isFloatingPointTy() ? "floating-point" : nullptr;
}

void refuse_call(const llvm::CallInst& call, const Transaction& transaction,
                 const SourceLines& lines) {
  if (transaction.endpoint_of(call) || llvm::isa<llvm::IntrinsicInst>(call)) return;
  const llvm::Function* callee = call.getCalledFunction();
  if (!callee) throw Error(lines.of(call), messages::kIndirectCall);
  if (port_access(*callee)) return;
  const llvm::StringRef name = callee->getName();
  if (name.starts_with("_Zn") || name.starts_with("_Zd") || name == "malloc" || name == "free" ||
      name == "calloc" || name == "realloc") {
    throw Error(lines.of(call), messages::kAllocation);
  }
  throw Error(lines.of(call), fmt::format(messages::kExternalCall, readable_name(*callee)));
}

void refuse_global(const llvm::Instruction& instruction, const llvm::Value& operand,
                   const SourceLines& lines) {
  const auto* global = llvm::dyn_cast<llvm::GlobalVariable>(operand.stripInBoundsOffsets());
  if (!global || global->isConstant()) return;
  llvm::SmallVector<llvm::DIGlobalVariableExpression*, 1> debug;
  global->getDebugInfo(debug);
  const std::string name = debug.empty() ? llvm::demangle(global->getName().str())
                                         : debug.front()->getVariable()->getName().str();
  throw Error(lines.of(instruction), fmt::format(messages::kGlobal, name));
}

}  // namespace

void refuse_before_inlining(const llvm::Module& module, const SourceLines& lines) {
  CallWalk(lines).visit(*module.getFunction(kStepFunction));
}

void refuse_uninitialised(const Transaction& transaction, const SourceLines& lines) {
  for (const llvm::Instruction& instruction : llvm::instructions(*transaction.function)) {
    const llvm::Value* condition = nullptr;
    if (const auto* branch = llvm::dyn_cast<llvm::BranchInst>(&instruction)) {
      if (branch->isConditional()) condition = branch->getCondition();
    } else if (const auto* choice = llvm::dyn_cast<llvm::SwitchInst>(&instruction)) {
      condition = choice->getCondition();
    }
    if (condition && llvm::isa<llvm::UndefValue>(condition)) {
      throw Error(lines.of(instruction), messages::kUninitialised);
    }
  }
}

void refuse_after_inlining(const Transaction& transaction, const SourceLines& lines) {
  for (const llvm::Instruction& instruction : llvm::instructions(*transaction.function)) {
    const char* name = float_name(instruction.getType());
    for (const llvm::Value* operand : instruction.operand_values()) {
      refuse_global(instruction, *operand, lines);
      if (!name) name = float_name(operand->getType());
    }
    if (name) throw Error(lines.of(instruction), fmt::format(messages::kFloat, name));
    if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&instruction)) {
      refuse_call(*call, transaction, lines);
    }
  }
}

}  // namespace hlsc
