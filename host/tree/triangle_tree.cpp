// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/triangle_tree.h"

#include <array>
#include <cmath>

#include "host/error.h"
#include "host/tree/clip.h"
#include "host/tree/sample_rays.h"

namespace dynrt::host {

namespace {

Aabb box_of(const Mesh& object, std::size_t primitive) {
  Aabb box;
  if (object.is_ellipsoid(primitive)) {
    const Ellipsoid& e = object.ellipsoid(primitive);
    box.include(glm::dvec3(e.from_unit[3]) - e.extent());
    box.include(glm::dvec3(e.from_unit[3]) + e.extent());
  } else if (object.is_rectangle(primitive)) {
    for (const glm::dvec3& p : object.rectangle(primitive).corners()) box.include(p);
  } else {
    for (const glm::dvec3& p : object.corners(primitive)) box.include(p);
  }
  return box;
}

Aabb grown(const Aabb& box, double by) {
  return {box.low - glm::dvec3(by), box.high + glm::dvec3(by)};
}

/// The box of the part within a cell; of an ellipsoid that of its box.
Aabb part_within(const Mesh& object, std::size_t primitive, const Aabb& cell) {
  if (object.is_ellipsoid(primitive)) {
    const Aabb box = box_of(object, primitive);
    return {glm::max(box.low, cell.low), glm::min(box.high, cell.high)};
  }
  if (object.is_rectangle(primitive)) {
    return clipped_box(object.rectangle(primitive).corners(), cell);
  }
  return clipped_box(object.corners(primitive), cell);
}

void check(const Grid& grid, const Mesh& object, std::size_t primitive, const Aabb& box) {
  const double limit = grid.largest() / 2;
  if (primitive >= object.triangles.size()) {
    for (const glm::dvec3& corner : {box.low, box.high}) {
      for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(corner[axis]) <= limit)) {
          refuse(
              "object '{}', primitive {}: its box reaches {} = {:g}, outside the core's numbers; "
              "coordinates must lie within -{:.5g} and {:.5g}",
              object.name, primitive, static_cast<char>('x' + axis), corner[axis], limit, limit);
        }
      }
    }
    return;
  }
  const std::array<glm::dvec3, 3> c = object.corners(primitive);
  for (unsigned vertex = 0; vertex < 3; ++vertex) {
    for (int axis = 0; axis < 3; ++axis) {
      const double x = c[vertex][axis];
      if (!(std::abs(x) <= limit)) {
        refuse(
            "object '{}', triangle {}, vertex {}: {} = {:g} is outside the core's numbers; "
            "coordinates must lie within -{:.5g} and {:.5g}",
            object.name, primitive, vertex, static_cast<char>('x' + axis), x, limit, limit);
      }
    }
  }
}

}  // namespace

Tree build_triangle_tree(const Mesh& object, const TreeOptions& options) {
  if (object.primitives() == 0) {
    refuse("object '{}' has no triangles; an object must have at least one", object.name);
  }
  const Grid& grid = options.grid;
  std::vector<ItemRef> items(object.primitives());
  Aabb whole;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Aabb box = box_of(object, i);
    check(grid, object, i, box);
    whole.include(grown(box, options.margin));
    items[i] = {grid_box(grid, grown(box, options.margin)), static_cast<std::uint32_t>(i)};
  }
  const CutItem cut = [&](const ItemRef& item, const GridBox& cell) {
    const Aabb within = grown(real_box(grid, cell), options.margin);
    return grid_box(grid, grown(part_within(object, item.item, within), options.margin));
  };
  CellContent content{grid_box(grid, whole, kBoxGrowth), std::move(items), {}};
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
