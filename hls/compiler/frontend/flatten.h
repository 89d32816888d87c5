// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// If-conversion (J. Allen, K. Kennedy, C. Porterfield, J. Warren, "Conversion of Control Dependence
// to Data Dependence", POPL 1983): the acyclic control flow of the transaction becomes one block.
// Every phi turns into selects, one per branch between its block's dominator and itself, shared
// where paths share, so that the depth is that of the branches and not of the incoming edges. They
// are selects and not and/or, so that poison of an untaken branch cannot leak. A `switch` becomes a
// balanced tree.
//
// Only phis, pure operations and sinks in the exit block may be left; a division, which would be
// undefined on an untaken path, has become an opaque pure call (see hide_divisions).
#pragma once

#include <llvm/IR/Function.h>

namespace hlsc {

/// Replaces udiv, sdiv, urem and srem, which trap on zero, by calls of pure functions
/// hls.udiv.iN...
void hide_divisions(llvm::Function& function);

/// Removes assumptions, which only inform LLVM: with a single path they would claim to hold always.
void drop_hints(llvm::Function& function);

void flatten(llvm::Function& function);

}  // namespace hlsc
