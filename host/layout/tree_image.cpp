// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/tree_image.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace dynrt::host {

namespace {

using Treelet = std::vector<std::uint32_t>;

/// Of treelets and lists, those among which one is sought that fits into the rest of a line.
constexpr std::size_t kAhead = 64;

bool has_node(const Tree& tree, std::uint32_t index) {
  return tree.leaves == Leaves::kNodes || !tree.nodes[index].is_leaf();
}

/// Divides a tree into treelets.
class Treelets {
 public:
  Treelets(const Tree& tree, unsigned nodes)
      : tree_(tree), nodes_(nodes), taken_(tree.nodes.size()) {}

  /// A treelet is followed by the one below that is reached most probably, with all below that.
  std::vector<Treelet> all() {
    std::vector<Treelet> treelets;
    std::vector<Reached> next;
    for (const std::uint32_t root : {tree_.main_leaf, tree_.clipped_root}) {
      reach(next, root, tree_.box);
    }
    while (!next.empty()) {
      const Reached root = next.back();
      next.pop_back();
      if (taken_[root.node]) continue;
      std::vector<Reached> below;
      treelets.push_back(grow(root, below));
      std::ranges::sort(below, {}, [](const Reached& at) { return std::pair(at.area, at.node); });
      next.insert(next.end(), below.begin(), below.end());
    }
    return treelets;
  }

 private:
  struct Reached {
    std::uint32_t node;
    Aabb cell;
    double area;  ///< of a convex cell, as to the probability that a ray meets it
  };

  void reach(std::vector<Reached>& front, std::uint32_t node, const Aabb& cell) const {
    if (node == kNullNode || taken_[node] || !has_node(tree_, node)) return;
    front.push_back({node, cell, half_area(cell)});
  }

  /// Leaves in `below` what the treelet leads to.
  Treelet grow(const Reached& root, std::vector<Reached>& below) {
    Treelet treelet;
    below = {root};
    while (treelet.size() < nodes_ && !below.empty()) {
      const auto best = std::ranges::max_element(below, {}, &Reached::area);
      const Reached joins = *best;
      below.erase(best);
      if (taken_[joins.node]) continue;  // a leaf that two nodes lead to
      taken_[joins.node] = true;
      treelet.push_back(joins.node);
      const TreeNode& node = tree_.nodes[joins.node];
      if (node.is_leaf()) continue;
      Aabb left = joins.cell;
      Aabb right = joins.cell;
      left.high[node.axis] = right.low[node.axis] = node.split;
      reach(below, node.left, left);
      reach(below, node.right, right);
    }
    return treelet;
  }

  const Tree& tree_;
  const unsigned nodes_;
  std::vector<bool> taken_;
};

/// The order of groups of these sizes, from `end` on, in which few lie across more lines than they
/// must: of the next groups the first that does not, else the next.
std::vector<std::size_t> order_in_lines(const std::vector<std::uint32_t>& sizes, std::uint32_t end,
                                        std::uint32_t line) {
  const auto lines = [line](std::uint32_t size) { return (size + line - 1) / line; };
  std::vector<std::size_t> order;
  std::size_t seen = 0;
  std::deque<std::size_t> ahead;
  while (order.size() < sizes.size()) {
    while (ahead.size() < kAhead && seen < sizes.size()) ahead.push_back(seen++);
    auto next = std::ranges::find_if(ahead, [&](std::size_t group) {
      return lines(end % line + sizes[group]) == lines(sizes[group]);
    });
    if (next == ahead.end()) next = ahead.begin();
    order.push_back(*next);
    end += sizes[*next];
    ahead.erase(next);
  }
  return order;
}

std::vector<std::uint32_t> nodes_in_lines(const std::vector<Treelet>& treelets, std::uint32_t end,
                                          unsigned line) {
  std::vector<std::uint32_t> sizes;
  for (const Treelet& treelet : treelets) {
    sizes.push_back(static_cast<std::uint32_t>(treelet.size()));
  }
  std::vector<std::uint32_t> nodes;
  for (const std::size_t k : order_in_lines(sizes, end, line)) {
    nodes.insert(nodes.end(), treelets[k].begin(), treelets[k].end());
  }
  return nodes;
}

/// The leaves as the treelets reach them.
std::vector<std::uint32_t> leaves_below(const Tree& tree, const std::vector<Treelet>& treelets) {
  std::vector<std::uint32_t> leaves;
  std::vector<bool> taken(tree.nodes.size());
  const auto reach = [&](std::uint32_t node) {
    if (node == kNullNode || !tree.nodes[node].is_leaf() || taken[node]) return;
    taken[node] = true;
    leaves.push_back(node);
  };
  for (const std::uint32_t root : {tree.main_leaf, tree.clipped_root}) reach(root);
  for (const Treelet& treelet : treelets) {
    for (const std::uint32_t node : treelet) {
      if (tree.nodes[node].is_leaf()) continue;
      reach(tree.nodes[node].left);
      reach(tree.nodes[node].right);
    }
  }
  return leaves;
}

std::vector<std::uint32_t> leaves_in_lines(const Tree& tree,
                                           const std::vector<std::uint32_t>& leaves,
                                           std::uint32_t end, std::uint32_t line) {
  const bool pointers = tree.leaves == Leaves::kPointers;
  std::vector<std::uint32_t> sizes;
  for (const std::uint32_t leaf : leaves) {
    const std::uint32_t items = tree.nodes[leaf].right;
    sizes.push_back(pointers ? static_cast<std::uint32_t>(list_places(items)) : items);
  }
  if (pointers) end = static_cast<std::uint32_t>(list_places(end));
  std::vector<std::uint32_t> order;
  for (const std::size_t k : order_in_lines(sizes, end, line)) order.push_back(leaves[k]);
  return order;
}

MemoryOrder order_of_tree(const Tree& tree) {
  MemoryOrder order;
  for (std::uint32_t i = 1; i < tree.nodes.size(); ++i) {
    if (has_node(tree, i)) order.nodes.push_back(i);
    if (tree.nodes[i].is_leaf()) order.leaves.push_back(i);
  }
  return order;
}

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

MemoryOrder memory_order(const Tree& tree, unsigned line_nodes, const MemoryPlace& place) {
  if (line_nodes == 1) return order_of_tree(tree);
  const std::vector<Treelet> treelets = Treelets(tree, line_nodes).all();
  return {nodes_in_lines(treelets, place.node, line_nodes),
          leaves_in_lines(tree, leaves_below(tree, treelets), place.entry,
                          entries_of_line(line_nodes))};
}

std::vector<std::uint32_t> add_tree(MemoryPart& part, const Tree& tree, const CoreInfo& core,
                                    std::span<const std::uint32_t> matrix_of, const Mesh* object) {
  const MemoryOrder order =
      memory_order(tree, core.line_nodes, {part.end_node(), part.end_entry()});
  const std::vector<std::uint32_t> list = add_lists(part, tree, order, matrix_of, object);
  std::vector<std::uint32_t> pointer =
      pointers_to(tree, order, list, part.end_node(), core.address_bits);
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
