// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/assemble.h"

#include <algorithm>
#include <map>

#include "host/tree/build.h"

namespace dynrt::host {

std::uint32_t RawTree::add_inner(int axis, Code split) {
  nodes.push_back({axis, split, kNullNode, kNullNode});
  return static_cast<std::uint32_t>(nodes.size() - 1);
}

std::uint32_t RawTree::add_leaf(std::span<const ItemRef> leaf_items) {
  const auto first = static_cast<std::uint32_t>(items.size());
  for (const ItemRef& item : leaf_items) items.push_back(item.item);
  nodes.push_back({kLeafAxis, 0, first, static_cast<std::uint32_t>(leaf_items.size())});
  return static_cast<std::uint32_t>(nodes.size() - 1);
}

std::uint32_t RawTree::append(const RawTree& other, std::uint32_t root) {
  const auto node_base = static_cast<std::uint32_t>(nodes.size() - 1);
  const auto item_base = static_cast<std::uint32_t>(items.size());
  const auto moved = [&](std::uint32_t child) {
    return child == kNullNode ? kNullNode : child + node_base;
  };
  for (std::size_t i = 1; i < other.nodes.size(); ++i) {
    Node node = other.nodes[i];
    node.left = node.axis == kLeafAxis ? node.left + item_base : moved(node.left);
    if (node.axis != kLeafAxis) node.right = moved(node.right);
    nodes.push_back(node);
  }
  items.insert(items.end(), other.items.begin(), other.items.end());
  return moved(root);
}

namespace {

class Assembler {
 public:
  Assembler(const Grid& grid, const RawTree& raw, const GridBox& cell)
      : grid_(grid), raw_(raw), whole_(real_box(grid, cell)) {}

  Tree run(std::uint32_t root) {
    add_clipping_nodes(tree_, whole_);
    tree_.root = add(root, whole_, 0);
    return std::move(tree_);
  }

 private:
  std::uint32_t add(std::uint32_t raw_index, const Aabb& cell, int depth) {
    if (raw_index == kNullNode) {
      ++tree_.stats.empty_children;
      return kNullNode;
    }
    const RawTree::Node& raw = raw_.nodes[raw_index];
    TreeStats& stats = tree_.stats;
    stats.depth = std::max(stats.depth, depth);
    const double p = half_area(cell) / half_area(whole_);
    if (raw.axis == kLeafAxis) {
      ++stats.leaf_links;
      stats.expected_leaves += p;
      stats.expected_items += p * raw.right;
      return leaf(raw);
    }
    ++stats.inner_nodes;
    stats.expected_steps += p;
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    const double split = grid_.value(raw.split);
    tree_.nodes.push_back({static_cast<std::uint8_t>(raw.axis), split, kNullNode, kNullNode});
    Aabb left_cell = cell;
    Aabb right_cell = cell;
    left_cell.high[raw.axis] = right_cell.low[raw.axis] = split;
    const std::uint32_t left = add(raw.left, left_cell, depth + 1);
    const std::uint32_t right = add(raw.right, right_cell, depth + 1);
    tree_.nodes[index].left = left;
    tree_.nodes[index].right = right;
    return index;
  }

  std::uint32_t leaf(const RawTree::Node& raw) {
    std::vector<std::uint32_t> list(raw_.items.begin() + raw.left,
                                    raw_.items.begin() + raw.left + raw.right);
    std::sort(list.begin(), list.end());
    const auto [known, is_new] = leaves_.try_emplace(std::move(list), 0);
    if (!is_new) return known->second;
    const std::vector<std::uint32_t>& items = known->first;
    known->second = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.push_back({kLeafAxis, 0, static_cast<std::uint32_t>(tree_.items.size()),
                           static_cast<std::uint32_t>(items.size())});
    tree_.items.insert(tree_.items.end(), items.begin(), items.end());
    ++tree_.stats.leaves;
    tree_.stats.items += items.size();
    tree_.stats.list_places += list_places(items.size());
    tree_.stats.longest_list = std::max(tree_.stats.longest_list, items.size());
    return known->second;
  }

  const Grid grid_;
  const RawTree& raw_;
  const Aabb whole_;
  Tree tree_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> leaves_;
};

}  // namespace

Tree assemble(const Grid& grid, const RawTree& raw, std::uint32_t root, const GridBox& cell) {
  return Assembler(grid, raw, cell).run(root);
}

}  // namespace dynrt::host
