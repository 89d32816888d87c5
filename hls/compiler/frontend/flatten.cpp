// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/flatten.h"

#include <llvm/ADT/DenseMap.h>
#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Module.h>

#include <algorithm>
#include <vector>

namespace hlsc {
namespace {

constexpr unsigned kMaxDenseBits = 6;  ///< of a selector whose values are all enumerated

/// Builds the value that a phi has, as selects over the branches from its dominator on.
class PhiSelects {
 public:
  PhiSelects(llvm::PHINode& phi, llvm::IRBuilder<>& builder)
      : phi_(phi), builder_(builder), layout_(phi.getModule()->getDataLayout()) {}

  llvm::Value* from(llvm::BasicBlock* dominator) {
    llvm::Value* value = leaving(dominator);
    return value ? value : llvm::PoisonValue::get(phi_.getType());
  }

 private:
  /// The phi's value when control is at the end of `block`; null where the phi is not reached.
  llvm::Value* leaving(llvm::BasicBlock* block) {
    const auto known = values_.find(block);
    if (known != values_.end()) return known->second;
    llvm::Value* value = nullptr;
    llvm::Instruction* terminator = block->getTerminator();
    if (auto* branch = llvm::dyn_cast<llvm::BranchInst>(terminator)) {
      value = along(block, branch->getSuccessor(0));
      if (branch->isConditional()) {
        value = select(branch->getCondition(), value, along(block, branch->getSuccessor(1)));
      }
    } else if (auto* choice = llvm::dyn_cast<llvm::SwitchInst>(terminator)) {
      value = switch_value(*choice);
    }
    values_[block] = value;
    return value;
  }

  llvm::Value* along(llvm::BasicBlock* block, llvm::BasicBlock* successor) {
    return successor == phi_.getParent() ? phi_.getIncomingValueForBlock(block)
                                         : leaving(successor);
  }

  /// A value that is never needed may be any value, so the other one stands for both.
  llvm::Value* select(llvm::Value* condition, llvm::Value* yes, llvm::Value* no) {
    if (!yes || yes == no) return no;
    if (!no) return yes;
    return builder_.CreateSelect(condition, yes, no);
  }

  using Case = std::pair<llvm::APInt, llvm::Value*>;

  llvm::Value* switch_value(llvm::SwitchInst& choice) {
    llvm::BasicBlock* block = choice.getParent();
    llvm::Value* otherwise = along(block, choice.getDefaultDest());
    std::vector<Case> cases;
    for (const auto& entry : choice.cases()) {
      cases.emplace_back(entry.getCaseValue()->getValue(), along(block, entry.getCaseSuccessor()));
    }
    std::sort(cases.begin(), cases.end(),
              [](const Case& a, const Case& b) { return a.first.ult(b.first); });
    llvm::Value& condition = *choice.getCondition();
    const unsigned bits =
        std::max(1u, llvm::computeKnownBits(&condition, layout_).countMaxActiveBits());
    const bool dense = bits <= kMaxDenseBits && cases.size() * 2 >= (std::size_t{1} << bits);
    return dense ? dense_tree(condition, otherwise, cases, bits)
                 : sparse_tree(condition, otherwise, cases);
  }

  /// Muxes on the selector's bits, the lowest at the leaves, over all of its values.
  llvm::Value* dense_tree(llvm::Value& value, llvm::Value* otherwise, llvm::ArrayRef<Case> cases,
                          unsigned bits) {
    std::vector<llvm::Value*> values(std::size_t{1} << bits, otherwise);
    for (const Case& c : cases) {
      if (c.first.ult(values.size())) values[c.first.getZExtValue()] = c.second;
    }
    for (unsigned bit = 0; bit < bits; ++bit) {
      llvm::Value* chosen = builder_.CreateTrunc(builder_.CreateLShr(&value, bit),
                                                 llvm::Type::getInt1Ty(phi_.getContext()));
      for (std::size_t i = 0; i < values.size() / 2; ++i) {
        values[i] = select(chosen, values[2 * i + 1], values[2 * i]);
      }
      values.resize(values.size() / 2);
    }
    return values.front();
  }

  /// Halves the sorted cases by comparisons until one is left, which is compared for equality.
  llvm::Value* sparse_tree(llvm::Value& value, llvm::Value* otherwise, llvm::ArrayRef<Case> cases) {
    if (cases.size() == 1) {
      if (!otherwise || !cases.front().second)
        return select(nullptr, cases.front().second, otherwise);
      return select(builder_.CreateICmpEQ(&value, constant(value, cases.front().first)),
                    cases.front().second, otherwise);
    }
    const std::size_t half = cases.size() / 2;
    llvm::Value* low = sparse_tree(value, otherwise, cases.take_front(half));
    llvm::Value* high = sparse_tree(value, otherwise, cases.drop_front(half));
    if (!low || !high || low == high) return select(nullptr, low, high);
    return select(builder_.CreateICmpULT(&value, constant(value, cases[half].first)), low, high);
  }

  static llvm::Constant* constant(const llvm::Value& like, const llvm::APInt& value) {
    return llvm::ConstantInt::get(like.getType(), value);
  }

  llvm::PHINode& phi_;
  llvm::IRBuilder<>& builder_;
  const llvm::DataLayout& layout_;
  llvm::DenseMap<llvm::BasicBlock*, llvm::Value*> values_;
};

bool is_division(const llvm::Instruction& instruction) {
  switch (instruction.getOpcode()) {
    case llvm::Instruction::UDiv:
    case llvm::Instruction::SDiv:
    case llvm::Instruction::URem:
    case llvm::Instruction::SRem:
      return true;
    default:
      return false;
  }
}

}  // namespace

void hide_divisions(llvm::Function& function) {
  llvm::Module& module = *function.getParent();
  for (llvm::Instruction& instruction : llvm::make_early_inc_range(llvm::instructions(function))) {
    if (!is_division(instruction)) continue;
    llvm::Type* type = instruction.getType();
    const std::string name = ("hls." + llvm::Twine(instruction.getOpcodeName()) + ".i" +
                              llvm::Twine(type->getIntegerBitWidth()))
                                 .str();
    auto callee = module.getOrInsertFunction(name, type, type, type);
    auto* made = llvm::cast<llvm::Function>(callee.getCallee());
    made->setMemoryEffects(llvm::MemoryEffects::none());
    made->setDoesNotThrow();
    made->setWillReturn();
    made->addFnAttr(llvm::Attribute::Speculatable);
    llvm::IRBuilder<> builder(&instruction);
    auto* call = builder.CreateCall(callee, {instruction.getOperand(0), instruction.getOperand(1)});
    call->takeName(&instruction);
    instruction.replaceAllUsesWith(call);
    instruction.eraseFromParent();
  }
}

void drop_hints(llvm::Function& function) {
  for (llvm::Instruction& instruction : llvm::make_early_inc_range(llvm::instructions(function))) {
    const auto* call = llvm::dyn_cast<llvm::IntrinsicInst>(&instruction);
    if (!call) continue;
    switch (call->getIntrinsicID()) {
      case llvm::Intrinsic::assume:
      case llvm::Intrinsic::sideeffect:
      case llvm::Intrinsic::donothing:
      case llvm::Intrinsic::experimental_noalias_scope_decl:
        instruction.eraseFromParent();
        break;
      default:
        break;
    }
  }
}

void flatten(llvm::Function& function) {
  const llvm::ReversePostOrderTraversal<llvm::Function*> traversal(&function);
  const std::vector<llvm::BasicBlock*> order(traversal.begin(), traversal.end());
  llvm::DominatorTree dominators(function);
  auto* flat = llvm::BasicBlock::Create(function.getContext(), "", &function);

  for (llvm::BasicBlock* block : order) {
    if (llvm::isa<llvm::UnreachableInst>(block->getTerminator())) continue;
    llvm::IRBuilder<> builder(flat);
    while (auto* phi = llvm::dyn_cast<llvm::PHINode>(&block->front())) {
      if (phi->getDebugLoc()) builder.SetCurrentDebugLocation(phi->getDebugLoc());
      llvm::Value* value = PhiSelects(*phi, builder).from(dominators[block]->getIDom()->getBlock());
      if (llvm::isa<llvm::Instruction>(value) && !value->hasName()) value->takeName(phi);
      phi->replaceAllUsesWith(value);
      phi->eraseFromParent();
    }
    flat->splice(flat->end(), block, block->begin(), block->getTerminator()->getIterator());
  }
  llvm::IRBuilder<>(flat).CreateRetVoid();
  for (llvm::BasicBlock& block : function) {
    if (&block != flat) block.dropAllReferences();
  }
  flat->moveBefore(&function.getEntryBlock());
  while (&function.back() != flat) function.back().eraseFromParent();
}

}  // namespace hlsc
