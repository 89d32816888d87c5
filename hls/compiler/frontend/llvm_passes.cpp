// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/llvm_passes.h"

#include <llvm/IR/Verifier.h>

#include <stdexcept>

namespace hlsc {
namespace {

/// Pass names are written in hlsc itself: one that LLVM does not know is a mistake there.
void require(llvm::Error error) {
  if (error) throw std::logic_error(llvm::toString(std::move(error)));
}

}  // namespace

LlvmPasses::LlvmPasses() {
  builder_.registerModuleAnalyses(modules_);
  builder_.registerCGSCCAnalyses(components_);
  builder_.registerFunctionAnalyses(functions_);
  builder_.registerLoopAnalyses(loops_);
  builder_.crossRegisterProxies(loops_, functions_, components_, modules_);
}

void LlvmPasses::run(llvm::Module& module, llvm::StringRef pipeline) {
  llvm::ModulePassManager manager;
  require(builder_.parsePassPipeline(manager, pipeline));
  manager.run(module, modules_);
  functions_.clear();
}

void LlvmPasses::run(llvm::Function& function, llvm::StringRef pipeline) {
  llvm::FunctionPassManager manager;
  require(builder_.parsePassPipeline(manager, pipeline));
  forget(function);
  manager.run(function, functions_);
  forget(function);
  assert(!llvm::verifyFunction(function, &llvm::errs()));
}

void LlvmPasses::forget(llvm::Function& function) {
  functions_.invalidate(function, llvm::PreservedAnalyses::none());
}

}  // namespace hlsc
