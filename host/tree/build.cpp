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

class Builder {
 public:
  Builder(const TreeOptions& options, const CutItem& cut) : options_(options), cut_(cut) {}

  /// Appends the subtree over the items to `out` and returns its root; kNullNode without items.
  uint32_t build(std::vector<ItemRef> items, const GridBox& cell, int depth, PlaneSearch& search,
                 RawTree& out) const {
    if (items.empty()) return kNullNode;
    const Plane plane = depth > 0 ? search.best(items, cell) : Plane{};
    const double as_leaf =
        options_.costs.leaf + static_cast<double>(items.size()) * options_.costs.item;
    if (plane.axis < 0 || plane.cost >= as_leaf) return out.add_leaf(items);

    GridBox left_cell = cell;
    GridBox right_cell = cell;
    left_cell.high[plane.axis] = right_cell.low[plane.axis] = plane.split;
    std::vector<ItemRef> left, right;
    divide(items, plane, left_cell, right_cell, left, right);
    const bool tasks = items.size() > kTaskItems;
    std::vector<ItemRef>().swap(items);

    const uint32_t node = out.add_inner(plane.axis, plane.split);
    uint32_t left_root, right_root;
    if (tasks) {
      RawTree left_tree, right_tree;
      uint32_t l = 0, r = 0;
      tbb::parallel_invoke(
          [&] {
            PlaneSearch own(options_.costs);
            l = build(std::move(left), left_cell, depth - 1, own, left_tree);
          },
          [&] {
            PlaneSearch own(options_.costs);
            r = build(std::move(right), right_cell, depth - 1, own, right_tree);
          });
      left_root = out.append(left_tree, l);
      right_root = out.append(right_tree, r);
    } else {
      left_root = build(std::move(left), left_cell, depth - 1, search, out);
      right_root = build(std::move(right), right_cell, depth - 1, search, out);
    }
    out.nodes[node].left = left_root;
    out.nodes[node].right = right_root;
    return node;
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
  const double levels = options.depth_factor * std::log2(static_cast<double>(items.size())) +
                        options.depth_extra;
  const int depth = std::clamp(static_cast<int>(std::lround(levels)), 0, kMaxTreeDepth);
  RawTree raw;
  PlaneSearch search(options.costs);
  const uint32_t root = Builder(options, cut).build(std::move(items), cell, depth, search, raw);
  return assemble(raw, root, cell);
}

}  // namespace dynrt::host
