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

/// Trees that are too large are made again with less depth, as often as that helps; what is too
/// large even then is left to the memory image to refuse.
SceneTrees build_scene_trees(const Scene& scene, const TreeOptions& options = {},
                             const TreeLimits& limits = {});

}  // namespace dynrt::host
