// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Both levels of a scene's trees, made to fit the board's memory.
#pragma once

#include <vector>

#include "host/tree/instance_tree.h"
#include "host/tree/triangle_tree.h"
#include "units/memory_format.h"

namespace dynrt::host {

struct SceneTrees {
  std::vector<Tree> objects;
  Tree instances;
};

/// What the trees of both levels may take together.
struct TreeLimits {
  std::size_t nodes = kMaxNodes - 1;
  std::size_t items = kMaxListEntries;
};

/// Where the trees are too large they are made with the greatest depth at which they fit; what is
/// too large without any depth is left to the memory image to refuse.
SceneTrees build_scene_trees(const Scene& scene, const TreeOptions& options = {},
                             const TreeLimits& limits = {});

}  // namespace dynrt::host
