// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/triangle_tree.h"

#include <array>
#include <cmath>

#include "host/error.h"
#include "host/tree/clip.h"
#include "host/tree/messages.h"
#include "host/tree/sample_rays.h"

namespace dynrt::host {

namespace {

using Corners = std::array<glm::dvec3, 3>;

Corners corners(const Mesh& object, std::size_t triangle) {
  const glm::uvec3& t = object.triangles[triangle];
  return {object.vertices[t.x], object.vertices[t.y], object.vertices[t.z]};
}

void check(const Mesh& object, std::size_t triangle, const Corners& c) {
  const double limit = grid_largest() / 2;
  for (unsigned vertex = 0; vertex < 3; ++vertex) {
    for (int axis = 0; axis < 3; ++axis) {
      const double x = c[vertex][axis];
      if (!(std::abs(x) <= limit)) {
        refuse(messages::kCoordinate, object.name, triangle, vertex, static_cast<char>('x' + axis),
               x, limit, limit);
      }
    }
  }
}

}  // namespace

Tree build_triangle_tree(const Mesh& object, const TreeOptions& options) {
  if (object.triangles.empty()) refuse(messages::kNoTriangles, object.name);
  std::vector<ItemRef> items(object.triangles.size());
  Aabb whole;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Corners c = corners(object, i);
    check(object, i, c);
    Aabb box;
    for (const glm::dvec3& p : c) box.include(p);
    whole.include(box);
    items[i] = {grid_box(box), static_cast<std::uint32_t>(i)};
  }
  const CutItem cut = [&](const ItemRef& item, const GridBox& cell) {
    return grid_box(clipped_box(corners(object, item.item), real_box(cell)));
  };
  CellContent content{grid_box(whole, kBoxGrowth), std::move(items), {}};
  const auto rays = std::min<std::size_t>(options.sample_rays, content.items.size());
  if (rays == 0) return build_tree(content, options, cut);

  // The rays are found with a tree that is quickly made.
  TreeOptions rough = options;
  rough.depth_extra = 0;
  rough.patience = 0;
  Tree quick = build_tree(content, rough, cut);
  if (quick.given_up) return quick;
  content.rays = sample_rays(object, quick, rays);
  return build_tree(content, options, cut);
}

}  // namespace dynrt::host
