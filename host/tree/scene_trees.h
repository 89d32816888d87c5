// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Both levels of a scene's trees.
#pragma once

#include <vector>

#include "host/tree/instance_tree.h"
#include "host/tree/triangle_tree.h"

namespace dynrt::host {

struct SceneTrees {
  std::vector<Tree> objects;
  Tree instances;
};

SceneTrees build_scene_trees(const Scene& scene, const TreeOptions& options = {});

}  // namespace dynrt::host
