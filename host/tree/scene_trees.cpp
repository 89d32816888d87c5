// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/scene_trees.h"

namespace dynrt::host {

namespace {

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
    nodes += tree.nodes.size() - 1;
    items += tree.items.size();
  }
  return nodes <= limits.nodes && items <= limits.items;
}

}  // namespace

SceneTrees build_scene_trees(const Scene& scene, const TreeOptions& options,
                             const TreeLimits& limits) {
  constexpr double kShallower = 2;
  constexpr double kShallowest = -6;
  TreeOptions tried = options;
  SceneTrees trees = build(scene, tried);
  while (!fits(trees, limits) && tried.depth_extra > kShallowest) {
    tried.depth_extra -= kShallower;
    trees = build(scene, tried);
  }
  return trees;
}

}  // namespace dynrt::host
