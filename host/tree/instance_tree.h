// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The top-level tree: the instances of a scene by their boxes in the world (thesis 4.1). It is
// rebuilt for every frame.
#pragma once

#include <span>

#include "host/scene/scene.h"
#include "host/tree/box_tree.h"

namespace dynrt::host {

/// The box of a transformed box.
Aabb transformed_box(const Aabb& box, const glm::dmat4& transform);

/// What the tree over so many instances takes at most, wherever they are: its place in the board's
/// memory, which frames after one another share.
constexpr TreeSize top_level_room(std::size_t instances) {
  constexpr std::size_t kPerInstance = 3;
  constexpr std::size_t kAlways = 256;
  return {kPerInstance * instances + kAlways, kPerInstance * instances + kAlways};
}

/// Item i of the tree is instance i of the scene; object_boxes[k] is the box of object k's tree.
/// It keeps to options.room and to top_level_room().
/// Throws UserError for a scene without instances, or with one that reaches beyond the core's
/// numbers.
Tree build_instance_tree(const Scene& scene, std::span<const Aabb> object_boxes,
                         const BoxTreeOptions& options = {});

}  // namespace dynrt::host
