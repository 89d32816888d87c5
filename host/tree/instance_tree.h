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

/// Item i of the tree is instance i of the scene; object_boxes[k] is the box of object k's tree.
/// Throws UserError for a scene without instances, or with one that reaches beyond the core's
/// numbers.
Tree build_instance_tree(const Scene& scene, std::span<const Aabb> object_boxes,
                         const BoxTreeOptions& options = {});

}  // namespace dynrt::host
