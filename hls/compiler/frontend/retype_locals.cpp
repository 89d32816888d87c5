// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/retype_locals.h"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>

#include <vector>

namespace hlsc {
namespace {

/// The one type that all loads and stores of a variable have, if there is nothing else to it.
llvm::Type* type_of_uses(const llvm::AllocaInst& local) {
  llvm::Type* type = nullptr;
  for (const llvm::User* user : local.users()) {
    llvm::Type* here = nullptr;
    if (const auto* load = llvm::dyn_cast<llvm::LoadInst>(user)) {
      here = load->getType();
    } else if (const auto* store = llvm::dyn_cast<llvm::StoreInst>(user)) {
      if (store->getValueOperand() != &local) here = store->getValueOperand()->getType();
    }
    if (!here || (type && here != type)) return nullptr;
    type = here;
  }
  return type;
}

}  // namespace

bool retype_locals(llvm::Function& function) {
  std::vector<llvm::AllocaInst*> locals;
  for (llvm::Instruction& instruction : llvm::instructions(function)) {
    if (auto* local = llvm::dyn_cast<llvm::AllocaInst>(&instruction)) locals.push_back(local);
  }
  bool changed = false;
  for (llvm::AllocaInst* local : locals) {
    llvm::Type* type = type_of_uses(*local);
    if (!type || type == local->getAllocatedType()) continue;
    llvm::IRBuilder<> builder(local);
    llvm::AllocaInst* same = builder.CreateAlloca(type);
    same->takeName(local);
    local->replaceAllUsesWith(same);
    local->eraseFromParent();
    changed = true;
  }
  return changed;
}

}  // namespace hlsc
