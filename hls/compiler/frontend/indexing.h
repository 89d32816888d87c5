// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Accesses to local arrays and constant tables with an index that is not known at compile time
// become accesses to every element and a selection by the index's bits: a read is a balanced tree
// of muxes, a write keeps or replaces each element. After that the array is promoted like any
// local.
#pragma once

#include "frontend/transaction.h"

namespace hlsc {

/// Rewrites one variable index of every such access; true if there was any.
bool expand_indexing(Transaction& transaction, const SourceLines& lines);

}  // namespace hlsc
