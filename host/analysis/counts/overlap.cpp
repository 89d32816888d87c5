// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/counts/overlap.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace dynrt::host {

namespace {

/// Expected intersections with each instance below a node, times the area of the root's cell.
using Costs = std::map<std::uint32_t, double>;

class Hierarchy {
 public:
  explicit Hierarchy(const Tree& plain) : plain_(plain), lists_(plain.nodes.size()) {
    // The cell of the real root is the box that the clipping nodes cut out.
    choose(plain.root, plain.box);
    Tree& tree = top_.tree;
    add_clipping_nodes(tree, plain.box);
    top_.inner.resize(tree.nodes.size());
    tree.root = static_cast<std::uint32_t>(tree.nodes.size());
    copy(plain.root, {});  // holds an instance, so it is no empty child
  }

  TopLevel take() { return std::move(top_); }

 private:
  /// Decides bottom up where each instance is cheapest; the highest such node will have it.
  Costs choose(std::uint32_t index, const Aabb& cell) {
    Costs costs;
    if (index == kNullNode) return costs;
    const TreeNode& node = plain_.nodes[index];
    const double area = half_area(cell);
    if (node.is_leaf()) {
      for (std::uint32_t i = 0; i < node.right; ++i) costs[plain_.items[node.left + i]] = area;
      return costs;
    }
    Aabb left = cell, right = cell;
    left.high[node.axis] = right.low[node.axis] = node.split;
    costs = choose(node.left, left);
    for (const auto& [item, cost] : choose(node.right, right)) costs[item] += cost;
    for (auto& [item, cost] : costs) {
      if (cost <= area) continue;
      cost = area;
      lists_[index].push_back(item);
    }
    return costs;
  }

  /// Copies a subtree without the instances in `placed`, which are in lists above; returns its
  /// node.
  std::uint32_t copy(std::uint32_t index, std::set<std::uint32_t> placed) {
    if (index == kNullNode) return kNullNode;
    const TreeNode& node = plain_.nodes[index];
    std::vector<std::uint32_t> items;
    if (node.is_leaf()) {
      const auto first = plain_.items.begin() + node.left;
      std::copy_if(first, first + node.right, std::back_inserter(items),
                   [&](std::uint32_t item) { return !placed.contains(item); });
      return items.empty() ? kNullNode : add_leaf(items);
    }
    for (const std::uint32_t item : lists_[index]) {
      if (placed.insert(item).second) items.push_back(item);
    }
    Tree& tree = top_.tree;
    const auto here = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.push_back(node);
    top_.inner.push_back(items);
    const std::uint32_t left = copy(node.left, placed);
    const std::uint32_t right = copy(node.right, placed);
    if (left == kNullNode && right == kNullNode) {
      tree.nodes.pop_back();
      top_.inner.pop_back();
      return items.empty() ? kNullNode : add_leaf(items);
    }
    tree.nodes[here].left = left;
    tree.nodes[here].right = right;
    return here;
  }

  std::uint32_t add_leaf(const std::vector<std::uint32_t>& items) {
    Tree& tree = top_.tree;
    const auto here = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.push_back({kLeafAxis, 0, static_cast<std::uint32_t>(tree.items.size()),
                          static_cast<std::uint32_t>(items.size())});
    tree.items.insert(tree.items.end(), items.begin(), items.end());
    top_.inner.emplace_back();
    return here;
  }

  const Tree& plain_;
  std::vector<std::vector<std::uint32_t>> lists_;  ///< by node of the plain tree
  TopLevel top_;
};

}  // namespace

TopLevel hierarchical_top_level(const Tree& plain) { return Hierarchy(plain).take(); }

TopLevel main_scene_first(const Scene& scene, std::span<const Aabb> object_boxes) {
  std::vector<Aabb> boxes;
  for (const Instance& instance : scene.instances) {
    boxes.push_back(transformed_box(object_boxes[instance.object], instance.transform));
  }
  const auto largest = std::ranges::max_element(boxes, {}, half_area);
  const auto main = static_cast<std::uint32_t>(largest - boxes.begin());
  return {build_beside_main(std::move(boxes), main), {}};
}

}  // namespace dynrt::host
