// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/unroll.h"

#include <fmt/format.h>
#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/OptimizationRemarkEmitter.h>
#include <llvm/Analysis/ScalarEvolution.h>
#include <llvm/Analysis/TargetTransformInfo.h>
#include <llvm/IR/Dominators.h>
#include <llvm/Transforms/Utils/UnrollLoop.h>

#include <vector>

#include "error.h"
#include "frontend/refusal_messages.h"

namespace hlsc {
namespace {

constexpr char kCanonical[] =
    "loop-simplify,lcssa,loop(loop-rotate),instcombine<no-verify-fixpoint>,"
    "loop-simplify,lcssa,loop(indvars)";
constexpr char kCleanUp[] =
    "sroa,early-cse,instcombine<no-verify-fixpoint>,simplifycfg<no-sink-common-insts>,"
    "instcombine<no-verify-fixpoint>";

/// Iterations after which the loop is certainly left through one of its exits, or 0.
unsigned exact_count(llvm::ScalarEvolution& evolution, const llvm::Loop& loop) {
  llvm::SmallVector<llvm::BasicBlock*> exiting;
  loop.getExitingBlocks(exiting);
  unsigned least = 0;
  for (llvm::BasicBlock* block : exiting) {
    const unsigned count = evolution.getSmallConstantTripCount(&loop, block);
    if (count != 0 && (least == 0 || count < least)) least = count;
  }
  return least;
}

bool unroll_once(llvm::Function& function, LlvmPasses& passes, bool only_exact) {
  auto& analyses = passes.analyses();
  auto& loops = analyses.getResult<llvm::LoopAnalysis>(function);
  auto& evolution = analyses.getResult<llvm::ScalarEvolutionAnalysis>(function);
  auto& dominators = analyses.getResult<llvm::DominatorTreeAnalysis>(function);
  auto& assumptions = analyses.getResult<llvm::AssumptionAnalysis>(function);
  auto& target = analyses.getResult<llvm::TargetIRAnalysis>(function);
  auto& remarks = analyses.getResult<llvm::OptimizationRemarkEmitterAnalysis>(function);

  auto order = loops.getLoopsInPreorder();
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    unsigned count = exact_count(evolution, **it);
    if (count == 0 && !only_exact) count = evolution.getSmallConstantMaxTripCount(*it);
    if (count == 0 || count > kMaxIterations) continue;
    llvm::UnrollLoopOptions options{};
    options.Count = count;
    options.Force = true;
    options.AllowExpensiveTripCount = true;
    options.ForgetAllSCEV = true;
    const auto result = llvm::UnrollLoop(*it, options, &loops, &evolution, &dominators,
                                         &assumptions, &target, &remarks, true);
    if (result == llvm::LoopUnrollResult::FullyUnrolled) return true;
  }
  return false;
}

SourceLine loop_line(const llvm::Loop& loop, const SourceLines& lines) {
  if (const llvm::DebugLoc start = loop.getStartLoc()) return lines.of(start.get());
  return lines.of(*loop.getHeader()->getTerminator());
}

}  // namespace

void unroll_loops(Transaction& transaction, LlvmPasses& passes, const SourceLines& lines) {
  llvm::Function& function = *transaction.function;
  for (;;) {
    passes.run(function, kCanonical);
    auto& loops = passes.analyses().getResult<llvm::LoopAnalysis>(function);
    if (loops.empty()) return;
    const bool done = unroll_once(function, passes, true) || unroll_once(function, passes, false);
    if (!done) {
      const llvm::Loop& loop = **loops.getLoopsInPreorder().begin();
      throw Error(loop_line(loop, lines), fmt::format(messages::kUnbounded, kMaxIterations));
    }
    passes.forget(function);
    passes.run(function, kCleanUp);
  }
}

}  // namespace hlsc
