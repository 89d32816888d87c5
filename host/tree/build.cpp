// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/build.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

#include "host/tree/assemble.h"

namespace dynrt::host {

namespace {

/// Subtrees over more items than these are built as tasks of their own.
constexpr std::size_t kTaskItems = 2048;

double area_share(const GridBox& part, const GridBox& whole) {
  return half_area(real_box(part)) / half_area(real_box(whole));
}

class Builder {
 public:
  Builder(const TreeOptions& options, const CutItem& cut) : options_(options), cut_(cut) {}

  struct Subtree {
    uint32_t root = kNullNode;
    double cost = 0;  ///< expected, for a ray that meets its cell
  };

  /// Appends the subtree over the items to a tree; nothing without items. `depth` and `patience`
  /// are how many levels are left, and how many of them may promise no gain by themselves.
  Subtree build(std::vector<ItemRef> items, const GridBox& cell, int depth, int patience,
                PlaneSearch& search, RawTree& out) const {
    if (items.empty()) return {};
    const Plane plane = depth > 0 ? search.best(items, cell) : Plane{};
    const double leaf_cost =
        options_.costs.leaf + static_cast<double>(items.size()) * options_.costs.item;
    if (plane.cost >= leaf_cost) --patience;
    if (plane.axis < 0 || patience < 0) return {out.add_leaf(items), leaf_cost};

    GridBox left_cell = cell;
    GridBox right_cell = cell;
    left_cell.high[plane.axis] = right_cell.low[plane.axis] = plane.split;
    std::vector<ItemRef> left, right;
    divide(items, plane, left_cell, right_cell, left, right);

    const RawTree::Size before = out.size();
    const uint32_t node = out.add_inner(plane.axis, plane.split);
    Subtree l, r;
    if (items.size() > kTaskItems) {
      RawTree left_tree, right_tree;
      const auto apart = [&](std::vector<ItemRef>& side, const GridBox& side_cell, RawTree& tree) {
        PlaneSearch own(options_.costs);
        return build(std::move(side), side_cell, depth - 1, patience, own, tree);
      };
      tbb::parallel_invoke([&] { l = apart(left, left_cell, left_tree); },
                           [&] { r = apart(right, right_cell, right_tree); });
      l.root = out.append(left_tree, l.root);
      r.root = out.append(right_tree, r.root);
    } else {
      l = build(std::move(left), left_cell, depth - 1, patience, search, out);
      r = build(std::move(right), right_cell, depth - 1, patience, search, out);
    }
    const double cost = options_.costs.step + area_share(left_cell, cell) * l.cost +
                        area_share(right_cell, cell) * r.cost;
    if (cost >= leaf_cost) {
      out.cut_back(before);
      return {out.add_leaf(items), leaf_cost};
    }
    out.nodes[node].left = l.root;
    out.nodes[node].right = r.root;
    return {node, cost};
  }

 private:
  void divide(const std::vector<ItemRef>& items, const Plane& plane, const GridBox& left_cell,
              const GridBox& right_cell, std::vector<ItemRef>& left,
              std::vector<ItemRef>& right) const {
    left.reserve(plane.left);
    right.reserve(plane.right);
    const int axis = plane.axis;
    for (const ItemRef& item : items) {
      const Code low = item.box.low[axis];
      const Code high = item.box.high[axis];
      const bool flat = low == plane.split && high == plane.split;
      const bool to_left = low < plane.split || (flat && plane.flat_left);
      const bool to_right = high > plane.split || (flat && !plane.flat_left);
      if (to_left && to_right) {
        left.push_back({cut(item, left_cell, axis), item.item});
        right.push_back({cut(item, right_cell, axis), item.item});
      } else {
        (to_left ? left : right).push_back(item);
      }
    }
  }

  /// Part of an item on one side. Where rounding leaves nothing of a part that is there, the
  /// item's box is cut instead: no item is lost.
  GridBox cut(const ItemRef& item, const GridBox& cell, int axis) const {
    ItemRef part = item;
    part.box.low[axis] = std::max(part.box.low[axis], cell.low[axis]);
    part.box.high[axis] = std::min(part.box.high[axis], cell.high[axis]);
    const GridBox exact = cut_(part, cell);
    for (int k = 0; k < 3; ++k) {
      const Code low = std::max(part.box.low[k], exact.low[k]);
      const Code high = std::min(part.box.high[k], exact.high[k]);
      if (low > high) return part.box;
    }
    GridBox box;
    for (int k = 0; k < 3; ++k) {
      box.low[k] = std::max(part.box.low[k], exact.low[k]);
      box.high[k] = std::min(part.box.high[k], exact.high[k]);
    }
    return box;
  }

  const TreeOptions& options_;
  const CutItem& cut_;
};

}  // namespace

GridBox grid_box(const Aabb& box, int codes) {
  GridBox grid;
  for (int axis = 0; axis < 3; ++axis) {
    grid.low[axis] = std::max(floor_code(box.low[axis]) - codes, kMinCode);
    grid.high[axis] = std::min(ceil_code(box.high[axis]) + codes, kMaxCode);
  }
  return grid;
}

Aabb real_box(const GridBox& box) {
  Aabb real;
  for (int axis = 0; axis < 3; ++axis) {
    real.low[axis] = grid_value(box.low[axis]);
    real.high[axis] = grid_value(box.high[axis]);
  }
  return real;
}

Tree build_tree(std::vector<ItemRef> items, const GridBox& cell, const TreeOptions& options,
                const CutItem& cut) {
  const double levels =
      options.depth_factor * std::log2(static_cast<double>(items.size())) + options.depth_extra;
  const int depth = std::clamp(static_cast<int>(std::lround(levels)), 0, kMaxTreeDepth);
  RawTree raw;
  PlaneSearch search(options.costs);
  const Builder builder(options, cut);
  const auto whole = builder.build(std::move(items), cell, depth, options.patience, search, raw);
  return assemble(raw, whole.root, cell);
}

}  // namespace dynrt::host
