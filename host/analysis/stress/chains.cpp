// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/chains.h"

#include <utility>

#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

constexpr int kColumns = 8;
constexpr double kApart = 0.25;     ///< of the rays' directions
constexpr double kRadius = 0.0625;  ///< of a target, in directions
constexpr double kFirst = -0.875;

/// The direction of ray k, whose x is 1.
glm::dvec3 direction(int k) {
  if (k < 0) return {1, 4, 4};
  return {1, kFirst + kApart * (k % kColumns), kFirst + kApart * (k / kColumns)};
}

void add_node(Tree& tree, const TreeNode& node, unsigned unused) {
  tree.nodes.push_back(node);
  tree.nodes.resize(tree.nodes.size() + unused);
}

SceneTrees trees_of(const MemoryFormat& numbers, std::vector<Tree> objects, const Scene& scene) {
  std::vector<Aabb> boxes;
  for (const Tree& tree : objects) boxes.push_back(tree.box);
  Tree instances = build_instance_tree(scene, boxes, {.grid = Grid(numbers)});
  return {std::move(objects), std::move(instances), {}};
}

}  // namespace

Tree chain_tree(int splits, double spacing, const Aabb& box, unsigned unused) {
  Tree tree;
  add_clipping_nodes(tree, box);
  tree.root = static_cast<std::uint32_t>(tree.nodes.size());
  const std::uint32_t apart = unused + 1;
  for (int k = splits; k > 0; --k) {
    const auto here = static_cast<std::uint32_t>(tree.nodes.size());
    // Its far side's leaf, then the next plane, or the nearest leaf.
    add_node(tree, {0, spacing * k, here + 2 * apart, here + apart}, unused);
    add_node(tree, {kLeafAxis, 0, static_cast<std::uint32_t>(k), 1}, unused);
  }
  add_node(tree, {kLeafAxis, 0, 0, 1}, unused);
  for (int k = 0; k <= splits; ++k) tree.items.push_back(static_cast<std::uint32_t>(k));
  tree.stats.depth = splits;
  return tree;
}

Shot at_targets() {
  return pencil({-1, 0, 0}, direction(0), {0, kApart, 0}, {0, 0, kApart}, kColumns, kColumns);
}

void add_target(Mesh& mesh, double x, int k) {
  const double distance = x + 1;
  const auto at = [&](double y, double z) {
    return glm::dvec3(-1, 0, 0) + distance * (direction(k) + glm::dvec3(0, y, z) * kRadius);
  };
  add_triangle(mesh, at(-1, -1), at(1, -1), at(0, 1.5));
}

Aabb box_of_targets(double to) {
  const double reach = 8 * (to + 1);
  return {{0, -reach, -reach}, {to, reach, reach}};
}

Trial lower_chain(const MemoryFormat& numbers, int splits, unsigned unused) {
  Mesh mesh;
  for (int k = 0; k <= splits; ++k) add_target(mesh, k + 0.5, k);
  Trial trial{.scene = scene_of(std::move(mesh)), .shots = {at_targets()}};
  trial.trees =
      trees_of(numbers, {chain_tree(splits, 1, box_of_targets(splits + 1), unused)}, trial.scene);
  return trial;
}

Trial upper_chain(const MemoryFormat& numbers, int splits) {
  Trial trial{.scene = {}, .shots = {at_targets()}};
  std::vector<Tree> objects;
  for (int k = 0; k <= splits; ++k) {
    Mesh mesh;
    add_target(mesh, k + 0.5, k);
    objects.push_back(build_triangle_tree(mesh, {.grid = Grid(numbers)}));
    add(trial.scene, std::move(mesh));
  }
  trial.trees = {std::move(objects), chain_tree(splits, 1, box_of_targets(splits + 1)), {}};
  return trial;
}

Trial nested_chains(int upper, int lower) {
  constexpr int kRays = kColumns * kColumns;
  Trial trial{.scene = {}, .shots = {at_targets()}};
  const int each = lower + 1;
  const int all = each * (upper + 1);
  std::vector<Tree> objects;
  int next = 0;  // the ray that is given a target
  for (int j = 0; j <= upper; ++j) {
    Mesh mesh;
    for (int k = 0; k <= lower; ++k) {
      const bool aimed_at = (j * each + k) * kRays >= next * all && next < kRays;
      add_target(mesh, j * each + k + 0.5, aimed_at ? next++ : -1);
    }
    // The object's own planes are at whole numbers from its beginning.
    objects.push_back(chain_tree(lower, 1, box_of_targets(all)));
    Tree& tree = objects.back();
    for (std::size_t i = tree.root; i < tree.nodes.size(); ++i) tree.nodes[i].split += j * each;
    add(trial.scene, std::move(mesh));
  }
  trial.trees = {std::move(objects), chain_tree(upper, each, box_of_targets(all)), {}};
  return trial;
}

}  // namespace dynrt::host::stress
