// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/scene_trees.h"

#include <cmath>

namespace dynrt::host {

namespace {

constexpr std::size_t kMadePerKept = 4;
constexpr double kShallowest = -17;  // no tree at all, for as many triangles as there are matrices

SceneTrees build(const Scene& scene, const TreeOptions& options) {
  SceneTrees trees;
  std::vector<Aabb> boxes;
  for (const Mesh& object : scene.objects) {
    trees.objects.push_back(build_triangle_tree(object, options));
    boxes.push_back(trees.objects.back().box);
  }
  trees.instances = build_instance_tree(scene, boxes);
  return trees;
}

bool fits(const SceneTrees& trees, const TreeLimits& limits) {
  std::size_t nodes = trees.instances.nodes.size() - 1;
  std::size_t items = trees.instances.items.size();
  for (const Tree& tree : trees.objects) {
    if (tree.cut_short) return false;
    nodes += tree.nodes.size() - 1;
    items += tree.items.size();
  }
  return nodes <= limits.nodes && items <= limits.items;
}

}  // namespace

SceneTrees build_scene_trees(const Scene& scene, const TreeOptions& options,
                             const TreeLimits& limits) {
  TreeOptions tried = options;
  // Leaves with the same list are one in the end, so that more may be made than there is room for.
  tried.most_items = kMadePerKept * limits.items;
  SceneTrees trees = build(scene, tried);
  if (fits(trees, limits)) return trees;

  double fitting = kShallowest;
  double too_deep = options.depth_extra;
  while (too_deep - fitting > 1) {
    tried.depth_extra = std::floor((fitting + too_deep) / 2);
    trees = build(scene, tried);
    (fits(trees, limits) ? fitting : too_deep) = tried.depth_extra;
  }
  if (tried.depth_extra != fitting) {
    tried.depth_extra = fitting;
    trees = build(scene, tried);
  }
  return trees;
}

}  // namespace dynrt::host
