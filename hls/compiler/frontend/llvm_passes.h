// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs LLVM's own passes by their names, as opt -passes=... does, and hands out analyses.
#pragma once

#include <llvm/Passes/PassBuilder.h>

namespace hlsc {

class LlvmPasses {
 public:
  LlvmPasses();
  /// A pipeline of module passes in LLVM's syntax.
  void run(llvm::Module& module, llvm::StringRef pipeline);
  /// A pipeline of function passes in LLVM's syntax.
  void run(llvm::Function& function, llvm::StringRef pipeline);

  /// Analyses of a function in its current state; call forget() after changing the function.
  llvm::FunctionAnalysisManager& analyses() { return functions_; }
  void forget(llvm::Function& function);

 private:
  llvm::LoopAnalysisManager loops_;
  llvm::FunctionAnalysisManager functions_;
  llvm::CGSCCAnalysisManager components_;
  llvm::ModuleAnalysisManager modules_;
  llvm::PassBuilder builder_;
};

}  // namespace hlsc
