// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/scene_trees.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace dynrt::host {

namespace {

/// Leaves with the same list are one in the end, so that more may be made than there is room for.
constexpr std::size_t kMadePerKept = 4;
/// A cut tree that takes less than this part of its room is worth a second attempt with more,
constexpr double kWellUsed = 0.75;
/// of which so much is asked for.
constexpr double kAskedAgain = 0.95;
/// Parts of an item's cost that make smaller trees; the first that fits counts.
constexpr double kSmallerCosts[] = {0.5, 0.25};

std::size_t part_of(std::size_t whole, double part) {
  return static_cast<std::size_t>(static_cast<double>(whole) * part);
}

std::size_t less(std::size_t from, std::size_t what) { return from - std::min(from, what); }

TreeSize sum_of_sizes(const std::vector<Tree>& trees) {
  TreeSize sum;
  for (const Tree& tree : trees) {
    sum.nodes += tree.size().nodes;
    sum.items += tree.size().items;
  }
  return sum;
}

bool fits(const TreeSize& size, const TreeSize& limits) {
  return size.nodes <= limits.nodes && size.items <= limits.items;
}

/// Divides the room: trees that need little get it, the others equal parts by their weight.
std::vector<std::size_t> shares(std::size_t whole, std::span<const std::size_t> wanted,
                                std::span<const std::size_t> weights) {
  std::vector<std::pair<double, std::size_t>> order;  // room wanted per weight, its tree
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    order.emplace_back(static_cast<double>(wanted[k]) / static_cast<double>(weights[k]), k);
  }
  std::ranges::sort(order);
  std::size_t weight_left = std::reduce(weights.begin(), weights.end());
  std::vector<std::size_t> share(wanted.size());
  for (const auto& [ratio, k] : order) {
    const double part = static_cast<double>(weights[k]) / static_cast<double>(weight_left);
    share[k] = std::min(wanted[k], part_of(whole, part));
    whole -= share[k];
    weight_left -= weights[k];
  }
  return share;
}

Tree tree_of(const Mesh& object, const TreeOptions& options) {
  return options.make ? options.make(object, options) : build_triangle_tree(object, options);
}

class ObjectTrees {
 public:
  ObjectTrees(const Scene& scene, const TreeOptions& options, const TreeSize& limits,
              std::span<const double> margins)
      : scene_(scene), options_(options), margins_(margins) {
    options_.give_up_items = kMadePerKept * limits.items;
    trees_.resize(scene.objects.size());
    tbb::parallel_for(std::size_t{0}, trees_.size(),
                      [&](std::size_t k) { trees_[k] = tree_of(scene.objects[k], options_of(k)); });
    options_.give_up_items = options.give_up_items;
    for (const Tree& tree : trees_) {
      whole_.push_back({tree.given_up ? kTooLarge : tree.size(), tree.stats});
    }
  }

  const std::vector<Tree>& trees() const { return trees_; }

  bool fit(const TreeSize& limits) const {
    return std::ranges::none_of(trees_, &Tree::given_up) && fits(sum_of_sizes(trees_), limits);
  }

  void cut_to(const TreeSize& limits) {
    std::vector<std::size_t> nodes, items, weights;
    for (std::size_t k = 0; k < trees_.size(); ++k) {
      nodes.push_back(whole_[k].size.nodes);
      items.push_back(whole_[k].size.items);
      weights.push_back(scene_.objects[k].primitives());
    }
    nodes = shares(limits.nodes, nodes, weights);
    items = shares(limits.items, items, weights);
    tbb::parallel_for(std::size_t{0}, trees_.size(), [&](std::size_t k) {
      const TreeSize room{nodes[k], items[k]};
      if (!fits(whole_[k].size, room)) trees_[k] = cut(k, room);
    });
  }

  /// Sentences about the trees that are cut.
  std::vector<std::string> notes(const TreeSize& limits) const {
    std::vector<std::string> notes;
    for (std::size_t k = 0; k < trees_.size(); ++k) {
      if (!trees_[k].cut) continue;
      notes.push_back(fmt::format(
          "object '{}': its tree has only depth {}, to fit the board's {} tree nodes and {} list "
          "entries; {}; the whole tree fits if the triangles are fewer or smaller",
          scene_.objects[k].name, trees_[k].stats.depth, limits.nodes, limits.items,
          cost_of_cut(k)));
    }
    return notes;
  }

 private:
  TreeOptions options_of(std::size_t object) const {
    TreeOptions options = options_;
    if (!margins_.empty()) options.margin = margins_[object];
    return options;
  }

  /// The better of a tree that stops where its room ends, so that it is coarse in places, and of
  /// one that is coarser everywhere, as if items cost less.
  Tree cut(std::size_t object, const TreeSize& room) const {
    Tree best = stopped(object, room);
    for (const double part : kSmallerCosts) {
      TreeOptions options = options_of(object);
      options.costs.item *= part;
      Tree tree = tree_of(scene_.objects[object], options);
      if (tree.given_up || !fits(tree.size(), room)) continue;
      if (work(tree.stats) < work(best.stats)) {
        best = std::move(tree);
        best.cut = true;
      }
      break;
    }
    return best;
  }

  Tree stopped(std::size_t object, const TreeSize& room) const {
    TreeOptions options = options_of(object);
    options.room = room;
    Tree tree = tree_of(scene_.objects[object], options);
    const auto used = [](std::size_t size, std::size_t of) {
      return static_cast<double>(size) / static_cast<double>(of);
    };
    const double most_used =
        std::max(used(tree.size().nodes, room.nodes), used(tree.size().items, room.items));
    if (!tree.cut || most_used > kWellUsed) return tree;
    options.room = {part_of(room.nodes, kAskedAgain / most_used),
                    part_of(room.items, kAskedAgain / most_used)};
    Tree larger = tree_of(scene_.objects[object], options);
    return fits(larger.size(), room) ? larger : tree;
  }

  double work(const TreeStats& stats) const {
    return options_.costs.step * stats.expected_steps + options_.costs.item * stats.expected_items;
  }

  std::string cost_of_cut(std::size_t object) const {
    const TreeStats& now = trees_[object].stats;
    const Whole& whole = whole_[object];
    if (whole.size.items == kTooLarge.items) {
      return fmt::format("a ray across the object probably meets {:.0f} nodes and {:.0f} triangles",
                         now.expected_steps, now.expected_items);
    }
    return fmt::format(
        "a ray across the object probably makes {:.1f} times the work of the whole tree",
        work(now) / work(whole.stats));
  }

  static constexpr TreeSize kTooLarge{std::numeric_limits<std::size_t>::max(),
                                      std::numeric_limits<std::size_t>::max()};
  /// A tree that is not cut; the size of a tree that was given up is not known.
  struct Whole {
    TreeSize size;
    TreeStats stats;
  };

  const Scene& scene_;
  TreeOptions options_;
  std::span<const double> margins_;
  std::vector<Whole> whole_;
  std::vector<Tree> trees_;
};

}  // namespace

SceneTrees build_scene_trees(const Scene& scene, const TreeOptions& options, const TreeSize& limits,
                             std::span<const double> margins) {
  ObjectTrees objects(scene, options, limits, margins);
  std::vector<Aabb> boxes;
  for (const Tree& tree : objects.trees()) boxes.push_back(tree.box);
  SceneTrees trees;
  trees.instances = build_instance_tree(scene, boxes,
                                        {.grid = options.grid,
                                         .leaves = options.leaves,
                                         .main_first = options.main_first,
                                         .item = options.object_cost,
                                         .max_depth = options.max_top_depth});
  const TreeSize top = trees.instances.size();
  if (!objects.fit({less(limits.nodes, top.nodes), less(limits.items, top.items)})) {
    const TreeSize room = top_level_room(scene.instances.size());
    objects.cut_to({less(limits.nodes, room.nodes), less(limits.items, room.items)});
    trees.notes = objects.notes(limits);
  }
  trees.objects = objects.trees();
  return trees;
}

}  // namespace dynrt::host
