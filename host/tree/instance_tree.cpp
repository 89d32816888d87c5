// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/instance_tree.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "host/error.h"
#include "host/tree/grid.h"

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

namespace {

/// Of the rays that meet the scene's box, the part that meets the main instance's, at least.
constexpr double kMainPart = 0.5;

/// Of convex bodies, as many rays meet each as it has surface.
std::optional<std::uint32_t> main_instance(std::span<const Aabb> boxes) {
  if (boxes.size() < 2) return std::nullopt;
  Aabb whole;
  for (const Aabb& box : boxes) whole.include(box);
  const auto largest = std::ranges::max_element(boxes, {}, half_area);
  if (half_area(*largest) < kMainPart * half_area(whole)) return std::nullopt;
  return static_cast<std::uint32_t>(largest - boxes.begin());
}

void add_main_leaf(Tree& tree, std::uint32_t item) {
  tree.main_leaf = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes.push_back({kLeafAxis, 0, static_cast<std::uint32_t>(tree.items.size()), 1});
  tree.items.push_back(item);
  ++tree.stats.leaves;
  ++tree.stats.items;
  tree.stats.list_places += list_places(1);
}

}  // namespace

Tree build_instance_tree(const Scene& scene, std::span<const Aabb> object_boxes,
                         const BoxTreeOptions& options) {
  if (scene.instances.empty()) {
    refuse("scene '{}' has no instances; a scene must have at least one", scene.name);
  }
  const double limit = options.grid.largest() / 2;
  std::vector<Aabb> boxes(scene.instances.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Aabb& box = boxes[i] = transformed_box(object_boxes[instance.object], instance.transform);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double x : {box.low[axis], box.high[axis]}) {
        if (!(std::abs(x) <= limit)) {
          refuse(
              "instance '{}': its box reaches {} = {:g}, outside the core's numbers; coordinates "
              "must lie within -{:.5g} and {:.5g}",
              instance.name, static_cast<char>('x' + axis), x, limit, limit);
        }
      }
    }
  }
  const TreeSize most = top_level_room(boxes.size());
  BoxTreeOptions within = options;
  within.room = {std::min(options.room.nodes, most.nodes),
                 std::min(options.room.items, most.items)};
  const std::optional<std::uint32_t> main =
      options.main_first ? main_instance(boxes) : std::nullopt;
  return main ? build_beside_main(std::move(boxes), *main, within) : build_box_tree(boxes, within);
}

Tree build_beside_main(std::vector<Aabb> boxes, std::uint32_t main, const BoxTreeOptions& options) {
  boxes.erase(boxes.begin() + main);
  BoxTreeOptions within = options;
  within.room.nodes -= 1;
  within.room.items -= list_places(1);
  Tree tree;
  tree.nodes.resize(1);
  tree.leaves = options.leaves;
  if (!boxes.empty()) tree = build_box_tree(boxes, within);
  for (std::uint32_t& item : tree.items) item += item >= main;
  add_main_leaf(tree, main);
  return tree;
}

}  // namespace dynrt::host
