// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/scene_trees.h"

namespace dynrt::host {

SceneTrees build_scene_trees(const Scene& scene, const TreeOptions& options) {
  SceneTrees trees;
  std::vector<Aabb> boxes;
  for (const Mesh& object : scene.objects) {
    trees.objects.push_back(build_triangle_tree(object, options));
    boxes.push_back(trees.objects.back().box);
  }
  trees.instances = build_instance_tree(scene, boxes);
  return trees;
}

}  // namespace dynrt::host
