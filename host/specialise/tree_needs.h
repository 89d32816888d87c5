// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a tree asks of the core that traverses it, whatever the ray: entries of the stack, and
// whether a packet may find an item again in another leaf, which is what a mailbox is for.
#pragma once

#include "host/tree/tree.h"

namespace dynrt::host {

struct TreeNeeds {
  /// Entries that are on the stack at once, at most: nodes with two children on one path, as the
  /// farther of them waits while the nearer is traversed.
  int pushes = 0;
  std::size_t items = 0;     ///< different ones
  std::size_t repeated = 0;  ///< of them, those that more than one path leads to
};

TreeNeeds tree_needs(const Tree& tree);

}  // namespace dynrt::host
