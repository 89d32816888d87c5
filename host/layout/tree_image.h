// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A tree in the memory. A line of a cache is to hold what is read one after another. So nodes form
// treelets of as many nodes as a line has: from a treelet's root on, that node joins next which a
// ray reaches with the largest probability, by its surface (Yoon and Manocha, "Cache-efficient
// layouts of bounding volume hierarchies", 2006). Lists follow each other as the treelets lead to
// them. Nothing is left free between any of them: where one would lie across two lines, one that
// comes a little later and fits goes first.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/format/core_info.h"
#include "host/memory/memory.h"
#include "host/scene/scene.h"
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

/// Appends a tree, of an object's primitives or of instances; item i becomes the matrix
/// matrix_of[i]. Returns the pointers to the tree's nodes: addresses, or where nodes point to the
/// lists of leaves, such pointers (units/packet.h).
std::vector<std::uint32_t> add_tree(MemoryPart& part, const Tree& tree, const CoreInfo& core,
                                    std::span<const std::uint32_t> matrix_of, const Mesh* object);

}  // namespace dynrt::host
