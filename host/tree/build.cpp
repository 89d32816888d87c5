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
  Builder(const TreeOptions& options, const CutItem& cut) : options_(options), cut_(cut) {}

  struct Subtree {
    std::uint32_t root = kNullNode;
    double cost = 0;  ///< expected, for a ray that meets its cell
  };

  /// Appends the subtree over the items to a tree; nothing without items. `depth` and `patience`
  /// are how many levels are left, and how many of them may promise no gain by themselves.
  Subtree build(const CellContent& content, int depth, int patience, PlaneSearch& search,
                RawTree& out) const {
    const std::vector<ItemRef>& items = content.items;
    if (items.empty()) return {};
    const bool split = depth > 0 && items_made_ <= options_.most_items;
    const Plane plane = split ? search.best(content) : Plane{};
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
    const double p_left = visit_likelihood(left, content, options_.costs);
    const double p_right = visit_likelihood(right, content, options_.costs);
    if (left.rays.size() < kFewRays) left.rays.clear();
    if (right.rays.size() < kFewRays) right.rays.clear();

    const RawTree::Size before = out.size();
    const std::uint32_t node = out.add_inner(plane.axis, plane.split);
    Subtree l, r;
    if (items.size() > kTaskItems) {
      RawTree left_tree, right_tree;
      const auto apart = [&](const CellContent& side, RawTree& tree) {
        PlaneSearch own(options_.costs);
        return build(side, depth - 1, patience, own, tree);
      };
      tbb::parallel_invoke([&] { l = apart(left, left_tree); },
                           [&] { r = apart(right, right_tree); });
      l.root = out.append(left_tree, l.root);
      r.root = out.append(right_tree, r.root);
    } else {
      l = build(left, depth - 1, patience, search, out);
      r = build(right, depth - 1, patience, search, out);
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

  bool cut_short() const { return items_made_ > options_.most_items; }

 private:
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
        left.items.push_back({cut(item, left.cell, axis), item.item});
        right.items.push_back({cut(item, right.cell, axis), item.item});
      } else {
        (to_left ? left : right).items.push_back(item);
      }
    }
  }

  static void divide_rays(const std::vector<RaySpan>& rays, const Plane& plane, CellContent& left,
                          CellContent& right) {
    const int axis = plane.axis;
    const double split = grid_value(plane.split);
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
  /// In all leaves ever made, so that whether it passes the limit does not depend on threads.
  mutable std::atomic<std::size_t> items_made_ = 0;
};

}  // namespace

Tree build_tree(const CellContent& content, const TreeOptions& options, const CutItem& cut) {
  const double levels =
      options.depth_factor * std::log2(static_cast<double>(content.items.size())) +
      options.depth_extra;
  const int depth = std::clamp(static_cast<int>(std::lround(levels)), 0, kMaxTreeDepth);
  RawTree raw;
  PlaneSearch search(options.costs);
  const Builder builder(options, cut);
  const auto whole = builder.build(content, depth, options.patience, search, raw);
  Tree tree = assemble(raw, whole.root, content.cell);
  tree.cut_short = builder.cut_short();
  return tree;
}

}  // namespace dynrt::host
