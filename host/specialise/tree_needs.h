// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The needs of a tree for any ray: the stack entries, and the items that a packet may find again in
// another leaf, which the mailbox drops.
#pragma once

#include "host/tree/tree.h"

namespace dynrt::host {

struct TreeNeeds {
  /// The largest number of entries on the stack: the nodes with two children on one path, as the
  /// farther child waits while the nearer is traversed.
  int pushes = 0;
  std::size_t items = 0;     ///< different ones
  std::size_t repeated = 0;  ///< of them, those that more than one path leads to
};

TreeNeeds tree_needs(const Tree& tree);

}  // namespace dynrt::host
