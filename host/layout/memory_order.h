// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The order of a tree's nodes and of its leaves' lists in the memory. A cache line should hold data
// that are read one after another. So nodes form treelets of as many nodes as a line has: starting
// from a treelet's root, the node joins next that a ray reaches with the largest probability, by
// its surface (Yoon and Manocha, "Cache-efficient layouts of bounding volume hierarchies", 2006).
// Lists follow each other in the order of the treelets. There are no gaps: where a treelet or list
// would lie across two lines, a later one that fits goes first.
#pragma once

#include <cstdint>
#include <vector>

#include "host/tree/tree.h"

namespace dynrt::host {

struct MemoryOrder {
  std::vector<std::uint32_t> nodes;   ///< of the tree, those that the memory holds
  std::vector<std::uint32_t> leaves;  ///< nodes of the tree too, as their lists follow each other
};

/// Where a tree goes.
struct MemoryPlace {
  std::uint32_t node = 0;
  std::uint32_t entry = 0;
};

/// A line has `line_nodes` nodes or twice as many entries. With one node the order is the tree's.
MemoryOrder memory_order(const Tree& tree, unsigned line_nodes, const MemoryPlace& place);

}  // namespace dynrt::host
