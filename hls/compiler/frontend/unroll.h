// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Unrolls every loop completely. A loop whose exact number of iterations is known goes first; then
// those of which only the largest number is known (a `break` or a bound of few bits). LLVM's own
// passes unroll by cost, so they leave loops rolled that hardware must not have.
#pragma once

#include "frontend/llvm_passes.h"
#include "frontend/transaction.h"

namespace hlsc {

inline constexpr unsigned kMaxIterations = 1024;

/// Throws Error at the loop that has no known bound.
void unroll_loops(Transaction& transaction, LlvmPasses& passes, const SourceLines& lines);

}  // namespace hlsc
