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

/// The memory that the trees of both levels may take together.
inline constexpr TreeSize kMemoryForTrees{kMaxNodes - 1, kMaxListEntries};

/// If the trees are too large together, those of the largest objects are rebuilt with less room,
/// hence less deep; the top level keeps room to grow in later frames. No tree is built more than
/// three times. The memory image refuses a scene that is too large even with one leaf for each
/// object. Object k's triangles count as larger by margins[k], if margins are given. Throws
/// UserError as the builders do.
SceneTrees build_scene_trees(const Scene& scene, const TreeOptions& options = {},
                             const TreeSize& limits = kMemoryForTrees,
                             std::span<const double> margins = {});

}  // namespace dynrt::host
