// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/build.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "host/tree/assemble.h"

namespace dynrt::host {

namespace {

/// Subtrees over more items than these are built as tasks of their own.
constexpr std::size_t kTaskItems = 2048;

/// Fewer rays than these tell less than the surface does; they are forgotten.
constexpr std::size_t kFewRays = 8;

class Builder {
 public:
  Builder(const TreeOptions& options, const CutItem& cut_item)
      : options_(options), cut_item_(cut_item) {}

  struct Subtree {
    std::uint32_t root = kNullNode;
    double cost = 0;  ///< expected, for a ray that meets its cell
  };

  /// Nodes and items that a subtree may take.
  struct Room {
    double nodes, items;
  };

  /// Appends the subtree over the items to a tree; nothing without items. `depth` and `patience`
  /// are how many levels are left, and how many of them may promise no gain by themselves.
  Subtree build(const CellContent& content, int depth, int patience, Room room, PlaneSearch& search,
                RawTree& out) const {
    const std::vector<ItemRef>& items = content.items;
    if (items.empty() || given_up()) return {};
    Plane plane = depth > 0 ? search.best(content) : Plane{};
    if (plane.axis >= 0 && !holds_split(room, plane)) {
      cut_ = true;
      plane = {};
    }
    const double leaf_cost = static_cast<double>(items.size()) * options_.costs.item;
    if (plane.cost >= leaf_cost) --patience;
    if (plane.axis < 0 || patience < 0) {
      items_made_ += items.size();
      return {out.add_leaf(items), leaf_cost};
    }

    CellContent left{content.cell, {}, {}};
    CellContent right{content.cell, {}, {}};
    left.cell.high[plane.axis] = right.cell.low[plane.axis] = plane.split;
    divide_items(items, plane, left, right);
    divide_rays(content.rays, plane, left, right);
    const double p_left = visit_likelihood(options_.grid, left, content, options_.costs);
    const double p_right = visit_likelihood(options_.grid, right, content, options_.costs);
    if (left.rays.size() < kFewRays) left.rays.clear();
    if (right.rays.size() < kFewRays) right.rays.clear();

    const TreeSize before = out.size();
    const std::uint32_t node = out.add_inner(plane.axis, plane.split);
    const auto [left_room, right_room] = divide(room, left, right, p_left, p_right);
    Subtree l, r;
    if (items.size() > kTaskItems) {
      RawTree left_tree, right_tree;
      const auto apart = [&](const CellContent& side, const Room& its, RawTree& tree) {
        PlaneSearch own(options_.grid, options_.costs);
        return build(side, depth - 1, patience, its, own, tree);
      };
      tbb::parallel_invoke([&] { l = apart(left, left_room, left_tree); },
                           [&] { r = apart(right, right_room, right_tree); });
      l.root = out.append(left_tree, l.root);
      r.root = out.append(right_tree, r.root);
    } else {
      l = build(left, depth - 1, patience, left_room, search, out);
      // The right side gets the room that the left side has not used.
      const TreeSize now = out.size();
      const auto used = [](std::size_t to, std::size_t from) {
        return static_cast<double>(to - from);
      };
      const Room rest{room.nodes - used(now.nodes, before.nodes),
                      room.items - used(now.items, before.items)};
      r = build(right, depth - 1, patience, rest, search, out);
    }
    const double cost = options_.costs.step + p_left * l.cost + p_right * r.cost;
    if (cost >= leaf_cost) {
      out.cut_back(before);
      return {out.add_leaf(items), leaf_cost};
    }
    out.nodes[node].left = l.root;
    out.nodes[node].right = r.root;
    return {node, cost};
  }

  bool given_up() const { return items_made_ > options_.give_up_items; }
  bool cut() const { return cut_; }

 private:
  static bool holds_split(const Room& room, const Plane& plane) {
    return room.nodes >= 3 && room.items >= static_cast<double>(plane.left + plane.right);
  }

  /// Each side gets the room of a leaf, and a part of the rest that grows faster than its expected
  /// work: halving a long list takes more splits.
  static std::pair<Room, Room> divide(const Room& room, const CellContent& left,
                                      const CellContent& right, double p_left, double p_right) {
    const auto n_left = static_cast<double>(left.items.size());
    const auto n_right = static_cast<double>(right.items.size());
    const double left_work = p_left * n_left * n_left;
    const double part = left_work / (left_work + p_right * n_right * n_right);
    const double nodes = room.nodes - 3;
    const double items = room.items - n_left - n_right;
    return {{1 + nodes * part, n_left + items * part},
            {1 + nodes * (1 - part), n_right + items * (1 - part)}};
  }

  void divide_items(const std::vector<ItemRef>& items, const Plane& plane, CellContent& left,
                    CellContent& right) const {
    left.items.reserve(plane.left);
    right.items.reserve(plane.right);
    const int axis = plane.axis;
    for (const ItemRef& item : items) {
      const Code low = item.box.low[axis];
      const Code high = item.box.high[axis];
      const bool flat = low == plane.split && high == plane.split;
      const bool to_left = low < plane.split || (flat && plane.flat_left);
      const bool to_right = high > plane.split || (flat && !plane.flat_left);
      if (to_left && to_right) {
        left.items.push_back({cut_to(item, left.cell, axis), item.item});
        right.items.push_back({cut_to(item, right.cell, axis), item.item});
      } else {
        (to_left ? left : right).items.push_back(item);
      }
    }
  }

  void divide_rays(const std::vector<RaySpan>& rays, const Plane& plane, CellContent& left,
                   CellContent& right) const {
    const int axis = plane.axis;
    const double split = options_.grid.value(plane.split);
    for (const RaySpan& ray : rays) {
      const double from = ray.from[axis];
      const double to = ray.to[axis];
      if (from <= split && to <= split) {
        left.rays.push_back(ray);
      } else if (from >= split && to >= split) {
        right.rays.push_back(ray);
      } else {
        glm::dvec3 at = ray.from + (ray.to - ray.from) * ((split - from) / (to - from));
        at[axis] = split;
        (from < split ? left : right).rays.push_back({ray.from, at});
        (from < split ? right : left).rays.push_back({at, ray.to});
      }
    }
  }

  /// Part of an item on one side. Where rounding leaves nothing of a part that is there, the
  /// item's box is cut instead: no item is lost.
  GridBox cut_to(const ItemRef& item, const GridBox& cell, int axis) const {
    ItemRef part = item;
    part.box.low[axis] = std::max(part.box.low[axis], cell.low[axis]);
    part.box.high[axis] = std::min(part.box.high[axis], cell.high[axis]);
    const GridBox exact = cut_item_(part, cell);
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
  const CutItem& cut_item_;
  /// In all leaves ever made, so that whether it passes the limit does not depend on threads.
  mutable std::atomic<std::size_t> items_made_ = 0;
  mutable std::atomic<bool> cut_ = false;
};

}  // namespace

Tree build_tree(const CellContent& content, const TreeOptions& options, const CutItem& cut) {
  const double levels =
      options.depth_factor * std::log2(static_cast<double>(content.items.size())) +
      options.depth_extra;
  const int depth = std::clamp(static_cast<int>(std::lround(levels)), 0, options.max_depth);
  RawTree raw;
  PlaneSearch search(options.grid, options.costs);
  const Builder builder(options, cut);
  const Builder::Room room{static_cast<double>(options.room.nodes) - kClippingNodes,
                           static_cast<double>(options.room.items)};
  const auto whole = builder.build(content, depth, options.patience, room, search, raw);
  if (builder.given_up()) {
    Tree tree;
    tree.box = real_box(options.grid, content.cell);
    tree.given_up = true;
    return tree;
  }
  Tree tree = assemble(options.grid, raw, whole.root, content.cell);
  tree.leaves = options.leaves;
  tree.cut = builder.cut();
  return tree;
}

}  // namespace dynrt::host
