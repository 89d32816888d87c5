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

}  // namespace

std::uint32_t add_tree(MemoryPart& part, const Tree& tree, std::span<const std::uint32_t> matrix_of,
                       const Mesh* object, const glm::dmat4& to_space) {
  const std::uint32_t base = part.end_node() - 1;
  const std::uint32_t list_base = part.end_entry();
  const auto child = [&](std::uint32_t index) { return index == kNullNode ? 0 : base + index; };
  part.nodes.reserve(part.nodes.size() + tree.nodes.size());
  for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
    const TreeNode& from = tree.nodes[i];
    MemoryNode node;
    node.kind = static_cast<NodeKind>(from.axis);
    if (from.is_leaf()) {
      node.left = list_base + from.left;
    } else {
      const int k = from.axis;
      node.split = to_space[k][k] * from.split + to_space[3][k];
      node.left = child(from.left);
      node.right = child(from.right);
    }
    part.nodes.push_back(node);
  }
  const std::size_t first = part.entries.size();
  for (const std::uint32_t item : tree.items) {
    ListEntry entry;
    entry.matrix = MatrixIndex::from(matrix_of[item]);
    if (object != nullptr) entry.set_primitive(kind_of(*object, item));
    part.entries.push_back(entry);
  }
  for (const TreeNode& node : tree.nodes) {
    if (node.is_leaf() && node.right > 0) {
      part.entries[first + node.left + node.right - 1].last = true;
    }
  }
  return base;
}

}  // namespace dynrt::host
