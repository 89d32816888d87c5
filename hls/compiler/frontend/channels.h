// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Turns port accesses into dataflow. Each value that a transaction reads becomes a pure source.
// Each value that it writes (tokens, rows, addresses, and whether it writes) becomes a local
// variable, set at the place of the access and passed to a sink in the exit block, so the branches
// of an `if` that write the same Out merge like any variable. Whether a port may be used twice
// becomes a variable too, a check that must fold to false: branches that exclude each other for a
// reason LLVM can see are allowed.
//
// Runs after unrolling (the port of each access must be known) and before passes that merge blocks.
#pragma once

#include "frontend/transaction.h"

namespace hlsc {

void lower_channels(Transaction& transaction, const SourceLines& lines);

/// Reports the first check that is not constant false, and removes the others.
void require_checks(Transaction& transaction);

}  // namespace hlsc
