// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/instance_tree.h"

#include <algorithm>
#include <cmath>

#include "host/error.h"
#include "host/tree/grid.h"
#include "host/tree/tree_messages.h"

namespace dynrt::host {

Aabb transformed_box(const Aabb& box, const glm::dmat4& transform) {
  // Each coordinate is a sum whose terms are smallest and largest on their own.
  Aabb out{glm::dvec3(transform[3]), glm::dvec3(transform[3])};
  for (int column = 0; column < 3; ++column) {
    const glm::dvec3 a = glm::dvec3(transform[column]) * box.low[column];
    const glm::dvec3 b = glm::dvec3(transform[column]) * box.high[column];
    out.low += glm::min(a, b);
    out.high += glm::max(a, b);
  }
  return out;
}

Tree build_instance_tree(const Scene& scene, std::span<const Aabb> object_boxes,
                         const BoxTreeOptions& options) {
  if (scene.instances.empty()) refuse(messages::kNoInstances, scene.name);
  const double limit = options.grid.largest() / 2;
  std::vector<Aabb> boxes(scene.instances.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Aabb& box = boxes[i] = transformed_box(object_boxes[instance.object], instance.transform);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double x : {box.low[axis], box.high[axis]}) {
        if (!(std::abs(x) <= limit)) {
          refuse(messages::kInstanceBox, instance.name, static_cast<char>('x' + axis), x, limit,
                 limit);
        }
      }
    }
  }
  const TreeSize most = top_level_room(boxes.size());
  BoxTreeOptions within = options;
  within.room = {std::min(options.room.nodes, most.nodes),
                 std::min(options.room.items, most.items)};
  return build_box_tree(boxes, within);
}

}  // namespace dynrt::host
