// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/tree_needs.h"

#include <algorithm>

namespace dynrt::host {

TreeNeeds tree_needs(const Tree& tree) {
  struct Visit {
    std::uint32_t index;
    int pushes;
  };
  enum : std::uint8_t { kNever, kOnce, kAgain };
  TreeNeeds needs;
  std::vector<std::uint8_t> found;  // by item
  std::vector<Visit> open{{tree.clipped_root, 0}, {tree.main_leaf, 0}};
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    if (visit.index == kNullNode) continue;
    const TreeNode& node = tree.nodes[visit.index];
    if (!node.is_leaf()) {
      const int pushes = visit.pushes + (node.left != kNullNode && node.right != kNullNode);
      open.push_back({node.left, pushes});
      open.push_back({node.right, pushes});
      continue;
    }
    needs.pushes = std::max(needs.pushes, visit.pushes);
    for (std::uint32_t i = 0; i < node.right; ++i) {
      const std::uint32_t item = tree.items[node.left + i];
      if (item >= found.size()) found.resize(item + 1, kNever);
      if (found[item] < kAgain) ++found[item];
    }
  }
  for (const std::uint8_t times : found) {
    needs.items += times != kNever;
    needs.repeated += times == kAgain;
  }
  return needs;
}

}  // namespace dynrt::host
