// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Gives a local variable the type of its uses. SROA leaves the bytes of a copied struct's field as
// an array of bytes where the field is no whole number of bytes, and then no pass promotes it.
#pragma once

#include <llvm/IR/Function.h>

namespace hlsc {

/// Returns whether a variable got another type.
bool retype_locals(llvm::Function& function);

}  // namespace hlsc
