// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The top-level tree: the instances of a scene by their boxes in the world (thesis 4.1). It is
// rebuilt for every frame.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "host/scene/scene.h"
#include "host/tree/box_tree.h"

namespace dynrt::host {

/// The box of a transformed box.
Aabb transformed_box(const Aabb& box, const glm::dmat4& transform);

/// What the tree over so many instances takes at most, wherever they are: its place in the board's
/// memory, which frames after one another share. Instances side by side take about three nodes and
/// one list entry each, those that stand in one another's boxes up to twelve; where they are many,
/// less is left to be wasted.
constexpr TreeSize top_level_room(std::size_t instances) {
  constexpr std::size_t kAlways = 256, kOfFew = 12, kOfMany = 4, kFew = 1u << 17;
  const std::size_t room =
      std::min(kOfFew * instances + kAlways, std::max(kOfMany * instances, kFew));
  return {room, room};
}

/// Item i of the tree is instance i of the scene; object_boxes[k] is the box of object k's tree.
/// It keeps to options.room and to top_level_room().
/// Throws UserError for a scene without instances, or with one that reaches beyond the core's
/// numbers.
Tree build_instance_tree(const Scene& scene, std::span<const Aabb> object_boxes,
                         const BoxTreeOptions& options = {});

}  // namespace dynrt::host
