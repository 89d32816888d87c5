// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/box_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "host/tree/grid_box.h"

namespace dynrt::host {

namespace {

constexpr int kBins = 16;
constexpr std::size_t kSweepItems = 8;  ///< up to this many boxes every face is tried

/// x, y, z and a fourth lane that is not a coordinate: the three axes are one operation. Grid
/// numbers are exact in a float.
using Lanes = float __attribute__((vector_size(16)));
using IntLanes = std::int32_t __attribute__((vector_size(16)));

constexpr IntLanes kAxes{-1, -1, -1, 0};

Lanes all(float x) { return Lanes{} + x; }
/// The next axis's coordinate in each lane.
Lanes rotated(Lanes v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }

struct FloatBox {
  Lanes low, high;
};

/// A box, with its item's number in the mantissa of low's fourth lane, which so is a plain number
/// between 1 and 2.
using BoxRef = FloatBox;
constexpr std::uint32_t kOne = 0x3f800000;

BoxRef make_ref(const Grid& grid, const GridBox& box, std::uint32_t item) {
  BoxRef out{{0, 0, 0, std::bit_cast<float>(kOne | item)}, {0, 0, 0, 2}};
  for (int axis = 0; axis < 3; ++axis) {
    out.low[axis] = static_cast<float>(grid.value(box.low[axis]));
    out.high[axis] = static_cast<float>(grid.value(box.high[axis]));
  }
  return out;
}
std::uint32_t item_of(const BoxRef& ref) {
  return std::bit_cast<std::uint32_t>(float{ref.low[3]}) & ~kOne;
}

double half_area(const FloatBox& box) {
  const auto side = [&](int axis) { return double{box.high[axis]} - double{box.low[axis]}; };
  return side(0) * side(1) + side(1) * side(2) + side(2) * side(0);
}

/// The grid numbers next to x towards zero.
Lanes to_grid(const Grid& grid, Lanes x) {
  const std::int32_t below_grid = (1 << (23 - grid.mantissa_bits())) - 1;
  const Lanes cut = std::bit_cast<Lanes>(std::bit_cast<IntLanes>(x) & ~below_grid);
  const Lanes smallest = all(static_cast<float>(grid.smallest()));
  const Lanes near_zero = x < Lanes{} ? -smallest : smallest;
  return ((cut < smallest) & (cut > -smallest)) ? near_zero : cut;
}

struct Choice {
  float cost = std::numeric_limits<float>::infinity();
  int axis = -1;
  float split = 0;
};

/// The best plane of each axis so far.
struct Choices {
  Lanes cost = all(std::numeric_limits<float>::infinity());
  Lanes split{};

  Choice best() const {
    Choice choice;
    for (int axis = 0; axis < 3; ++axis) {
      if (cost[axis] < choice.cost) choice = {cost[axis], axis, split[axis]};
    }
    return choice;
  }
};

/// Weighs planes across a cell, one of each axis at a time.
class PlaneCost {
 public:
  PlaneCost(const FloatBox& cell, float item, float forgiven) : cell_(cell), forgiven_(forgiven) {
    const Lanes extent = cell.high - cell.low;
    const float unit = 1 / std::max({float{extent[0]}, float{extent[1]}, float{extent[2]}});
    const Lanes side = extent * unit;  // so that no product of huge sides is too large
    const Lanes y = rotated(side);
    const Lanes z = rotated(y);
    const Lanes scale = item / (y * z + side * (y + z));
    cap_ = y * z * scale;
    rim_ = (y + z) * scale * unit;
  }

  void consider(Lanes split, Lanes left, Lanes right, Choices& best) const {
    const Lanes cost = 1 + (cap_ + (split - cell_.low) * rim_) * left +
                       (cap_ + (cell_.high - split) * rim_) * right;
    const IntLanes one_empty = (left == Lanes{}) | (right == Lanes{});
    const Lanes weighed = one_empty ? cost * forgiven_ : cost;
    const IntLanes better =
        kAxes & (split > cell_.low) & (split < cell_.high) & (weighed < best.cost);
    best.cost = better ? weighed : best.cost;
    best.split = better ? split : best.split;
  }

 private:
  const FloatBox& cell_;
  float forgiven_;
  Lanes cap_, rim_;
};

class Builder {
 public:
  explicit Builder(const BoxTreeOptions& options)
      : grid_(options.grid),
        item_(static_cast<float>(options.item)),
        forgiven_(static_cast<float>(1 - options.empty_bonus)),
        room_(options.room) {}

  Tree run(std::span<const Aabb> boxes, const BoxTreeOptions& options) {
    refs_.reserve(4 * boxes.size());
    Aabb whole;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      whole.include(boxes[i]);
      refs_.push_back(make_ref(grid_, grid_box(grid_, boxes[i]), static_cast<std::uint32_t>(i)));
    }
    const GridBox cell = grid_box(grid_, whole, kBoxGrowth);
    const double levels =
        options.depth_factor * std::log2(static_cast<double>(boxes.size())) + options.depth_extra;
    depth_ = std::clamp(static_cast<int>(std::lround(levels)), 0, options.max_depth);
    while (!attempt(cell, boxes.size())) {
      --depth_;
      tree_ = Tree();
      tree_.cut = true;
    }
    return std::move(tree_);
  }

 private:
  /// False where the tree outgrows its room; one of a single leaf counts as none that does.
  bool attempt(const GridBox& cell, std::size_t count) {
    tree_.nodes.reserve(2 * count);
    add_clipping_nodes(tree_, real_box(grid_, cell));
    const FloatBox root_cell = make_ref(grid_, cell, 0);
    whole_area_ = half_area(root_cell);
    promised_ = {tree_.nodes.size(), count};
    outgrown_ = false;
    tree_.root = build(0, count, root_cell, 0);
    return !outgrown_;
  }

  std::uint32_t build(std::size_t begin, std::size_t end, const FloatBox& cell, int depth) {
    TreeStats& stats = tree_.stats;
    if (begin == end) {
      ++stats.empty_children;
      return kNullNode;
    }
    const std::size_t count = end - begin;
    stats.depth = std::max(stats.depth, depth);
    const double p = half_area(cell) / whole_area_;
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    Choice choice;
    if (depth < depth_ && count > 1 && !outgrown_) {
      choice = (count <= kSweepItems ? sweep(begin, end, cell) : bins(begin, end, cell)).best();
    }
    if (!(choice.cost < static_cast<float>(count) * item_)) return leaf(begin, end, p);
    const std::size_t left_begin = refs_.size();
    const std::size_t right_begin = divide(begin, end, choice);
    const std::size_t right_end = refs_.size();
    promise({std::size_t{right_begin > left_begin} + std::size_t{right_end > right_begin},
             right_end - left_begin - count});
    ++stats.inner_nodes;
    stats.expected_steps += p;
    tree_.nodes.push_back(
        {static_cast<std::uint8_t>(choice.axis), choice.split, kNullNode, kNullNode});
    FloatBox part = cell;
    part.high[choice.axis] = choice.split;
    const std::uint32_t left = build(left_begin, right_begin, part, depth + 1);
    refs_.resize(right_end);
    part = cell;
    part.low[choice.axis] = choice.split;
    const std::uint32_t right = build(right_begin, right_end, part, depth + 1);
    refs_.resize(left_begin);
    tree_.nodes[index].left = left;
    tree_.nodes[index].right = right;
    return index;
  }

  /// `p`: the part of the rays that come here.
  std::uint32_t leaf(std::size_t begin, std::size_t end, double p) {
    TreeStats& stats = tree_.stats;
    const std::size_t count = end - begin;
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.push_back({kLeafAxis, 0, static_cast<std::uint32_t>(tree_.items.size()),
                           static_cast<std::uint32_t>(count)});
    for (std::size_t i = begin; i < end; ++i) tree_.items.push_back(item_of(refs_[i]));
    ++stats.leaves;
    ++stats.leaf_links;
    stats.expected_leaves += p;
    stats.expected_items += p * static_cast<double>(count);
    stats.items += count;
    stats.list_places += list_places(count);
    stats.longest_list = std::max(stats.longest_list, count);
    return index;
  }

  /// Counts the additions of a split: its children and the boxes that are on both sides.
  void promise(const TreeSize& more) {
    promised_ = {promised_.nodes + more.nodes, promised_.items + more.items};
    outgrown_ |= promised_.nodes > room_.nodes || promised_.items > room_.items;
  }

  /// Appends the boxes left of the plane and then those right of it; returns where these begin.
  /// Every box is written to both and kept where it belongs: no branch to foresee.
  std::size_t divide(std::size_t begin, std::size_t end, const Choice& choice) {
    const std::size_t first = refs_.size();
    refs_.resize(first + end - begin);
    right_.resize(std::max(right_.size(), end - begin));
    const Lanes split = all(choice.split);
    std::size_t left = first, right = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const BoxRef ref = refs_[i];
      const IntLanes to_right = ref.high > split;
      const IntLanes to_left = (ref.low < split) | ~to_right;
      refs_[left] = ref;
      right_[right] = ref;
      left += to_left[choice.axis] & 1;
      right += to_right[choice.axis] & 1;
    }
    refs_.resize(left);
    refs_.insert(refs_.end(), right_.begin(), right_.begin() + static_cast<std::ptrdiff_t>(right));
    return left;
  }

  /// Counts where boxes begin and end; a plane lies between any two bins.
  Choices bins(std::size_t begin, std::size_t end, const FloatBox& cell) const {
    std::array<std::array<std::uint32_t, 4>, kBins> begins{}, ends{};
    const Lanes step = (cell.high - cell.low) / kBins;
    const Lanes scale = 1 / step;
    const auto bins_of = [&](Lanes x) {
      Lanes at = (x - cell.low) * scale;
      at = at > Lanes{} ? at : Lanes{};
      at = at < all(kBins - 1) ? at : all(kBins - 1);
      return __builtin_convertvector(at, IntLanes);
    };
    for (std::size_t i = begin; i < end; ++i) {
      const IntLanes low = bins_of(refs_[i].low);
      const IntLanes high = bins_of(refs_[i].high);
      for (int axis = 0; axis < 3; ++axis) {
        ++begins[low[axis]][axis];
        ++ends[high[axis]][axis];
      }
    }
    const auto lanes = [](const std::array<std::uint32_t, 4>& counts) {
      return __builtin_convertvector(std::bit_cast<IntLanes>(counts), Lanes);
    };
    const PlaneCost cost(cell, item_, forgiven_);
    Choices best;
    Lanes left{};
    Lanes right = all(static_cast<float>(end - begin));
    for (int i = 1; i < kBins; ++i) {
      left += lanes(begins[i - 1]);
      right -= lanes(ends[i - 1]);
      cost.consider(to_grid(grid_, cell.low + static_cast<float>(i) * step), left, right, best);
    }
    return best;
  }

  Choices sweep(std::size_t begin, std::size_t end, const FloatBox& cell) const {
    const PlaneCost cost(cell, item_, forgiven_);
    Choices best;
    const auto consider = [&](Lanes split) {
      IntLanes left{}, right{};  // each comparison that holds is -1
      for (std::size_t k = begin; k < end; ++k) {
        left -= (refs_[k].low < split) | (refs_[k].high <= split);
        right -= refs_[k].high > split;
      }
      cost.consider(split, __builtin_convertvector(left, Lanes),
                    __builtin_convertvector(right, Lanes), best);
    };
    for (std::size_t i = begin; i < end; ++i) {
      consider(refs_[i].low);
      consider(refs_[i].high);
    }
    return best;
  }

  const Grid grid_;
  const float item_, forgiven_;
  const TreeSize room_;
  TreeSize promised_;  ///< size of the tree if all open nodes become leaves
  bool outgrown_ = false;
  int depth_ = 0;
  double whole_area_ = 0;
  std::vector<BoxRef> refs_;   ///< a stack: the boxes of the open nodes
  std::vector<BoxRef> right_;  ///< room for divide()
  Tree tree_;
};

}  // namespace

Tree build_box_tree(std::span<const Aabb> boxes, const BoxTreeOptions& options) {
  Tree tree = Builder(options).run(boxes, options);
  tree.leaves = options.leaves;
  return tree;
}

}  // namespace dynrt::host
