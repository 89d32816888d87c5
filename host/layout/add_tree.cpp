// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/add_tree.h"

#include <algorithm>

namespace dynrt::host {

namespace {

Primitive kind_of(const Mesh& object, std::size_t primitive) {
  return object.is_ellipsoid(primitive)   ? Primitive::kSphere
         : object.is_rectangle(primitive) ? Primitive::kRectangle
                                          : Primitive::kTriangle;
}

/// Appends the lists of leaves. Returns, by node, the address of a leaf's.
std::vector<std::uint32_t> add_lists(MemoryPart& part, const Tree& tree, const MemoryOrder& order,
                                     std::span<const std::uint32_t> matrix_of, const Mesh* object) {
  const unsigned step = tree.leaves == Leaves::kPointers ? kListStep : 1;
  std::vector<std::uint32_t> address(tree.nodes.size());
  for (const std::uint32_t i : order.leaves) {
    const TreeNode& leaf = tree.nodes[i];
    while (part.end_entry() % step != 0) part.entries.emplace_back();
    address[i] = part.end_entry();
    for (std::uint32_t k = 0; k < leaf.right; ++k) {
      const std::uint32_t item = tree.items[leaf.left + k];
      ListEntry entry;
      entry.matrix = MatrixIndex::from(matrix_of[item]);
      if (object != nullptr) entry.set_primitive(kind_of(*object, item));
      entry.last = k + 1 == leaf.right;
      part.entries.push_back(entry);
    }
  }
  return address;
}

/// By node, where it lies, or the pointer to the list of a leaf that has no node.
std::vector<std::uint32_t> pointers_to(const Tree& tree, const MemoryOrder& order,
                                       const std::vector<std::uint32_t>& list, std::uint32_t first,
                                       unsigned address_bits) {
  std::vector<std::uint32_t> pointer(tree.nodes.size());
  for (const std::uint32_t leaf : order.leaves) {
    pointer[leaf] = 1u << (address_bits - 1) | list[leaf] / kListStep;
  }
  for (const std::uint32_t node : order.nodes) pointer[node] = first++;
  return pointer;
}

}  // namespace

std::vector<std::uint32_t> add_tree(MemoryPart& part, const Tree& tree, const MemoryOrder& order,
                                    unsigned address_bits, std::span<const std::uint32_t> matrix_of,
                                    const Mesh* object) {
  const std::vector<std::uint32_t> list = add_lists(part, tree, order, matrix_of, object);
  std::vector<std::uint32_t> pointer =
      pointers_to(tree, order, list, part.end_node(), address_bits);
  part.nodes.reserve(part.nodes.size() + order.nodes.size());
  for (const std::uint32_t i : order.nodes) {
    const TreeNode& from = tree.nodes[i];
    MemoryNode node;
    node.kind = static_cast<NodeKind>(from.axis);
    if (from.is_leaf()) {
      node.left = list[i];
    } else {
      node.split = from.split + 0.0;  // a zero of either sign is the positive one
      node.left = pointer[from.left];
      node.right = pointer[from.right];
    }
    part.nodes.push_back(node);
  }
  return pointer;
}

}  // namespace dynrt::host
