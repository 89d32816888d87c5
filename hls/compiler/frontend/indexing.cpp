// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "frontend/indexing.h"

namespace hlsc {

bool expand_indexing(Transaction&, const SourceLines&) { return false; }

}  // namespace hlsc
