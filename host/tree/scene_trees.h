// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Both levels of a scene's trees, made to fit the board's memory.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/tree/instance_tree.h"
#include "host/tree/triangle_tree.h"
#include "units/memory_format.h"

namespace dynrt::host {

struct SceneTrees {
  std::vector<Tree> objects;
  Tree instances;
  std::vector<std::string> notes;  ///< sentences for the user: which trees were cut, and the cost
};

/// What the trees of both levels may take together.
inline constexpr TreeSize kMemoryForTrees{kMaxNodes - 1, kMaxListEntries};

/// Where the trees are too large together, those of the largest objects are built again with less
/// room and so cut; the top level keeps room to grow in the frames to come. No tree is built more
/// than three times. What is too large even as one leaf per object is left to the memory image to
/// refuse. Object k's triangles count as larger by margins[k], if there are any. Throws UserError
/// as the builders do.
SceneTrees build_scene_trees(const Scene& scene, const TreeOptions& options = {},
                             const TreeSize& limits = kMemoryForTrees,
                             std::span<const double> margins = {});

}  // namespace dynrt::host
