// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The top-level tree: the instances of a scene by their boxes in the world (thesis 4.1). It is
// rebuilt for every frame.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/scene/scene.h"
#include "host/tree/box_tree.h"

namespace dynrt::host {

/// The box of a transformed box.
Aabb transformed_box(const Aabb& box, const glm::dmat4& transform);

/// The most memory that the tree over this many instances may take; all frames share this place in
/// the board's memory. Instances side by side take about three nodes and one list entry each,
/// instances whose boxes overlap up to twelve; a scene with many instances gets less spare room.
constexpr TreeSize top_level_room(std::size_t instances) {
  constexpr std::size_t kAlways = 256, kOfFew = 12, kOfMany = 4, kFew = 1u << 17;
  const std::size_t room =
      std::min(kOfFew * instances + kAlways, std::max(kOfMany * instances, kFew));
  return {room, room};
}

/// Item i of the tree is instance i of the scene; object_boxes[k] is the box of object k's tree. If
/// the options ask for it, the instance with the largest box is the main scene, which rays enter
/// first (4.3.3), provided that most of the rays that meet the scene's box meet its box.
/// The tree respects options.room and top_level_room(). Throws UserError for a scene without
/// instances, or with an instance that reaches outside the core's numbers.
Tree build_instance_tree(const Scene& scene, std::span<const Aabb> object_boxes,
                         const BoxTreeOptions& options = {});

/// The tree over all boxes but the main item's, which has the tree's main leaf; without other boxes
/// there is nothing else.
Tree build_beside_main(std::vector<Aabb> boxes, std::uint32_t main,
                       const BoxTreeOptions& options = {});

}  // namespace dynrt::host
