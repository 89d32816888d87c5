// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/core_trees.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/layout/limits.h"
#include "host/scene/animation.h"

namespace dynrt::host {

namespace {

/// The largest distance of a hit from the ray, in roundings of one operation times the distance of
/// the triangle's farthest corner; twelve are proved.
constexpr double kRoundings = 16;

double largest_of(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

Aabb box_of(const Mesh& object) {
  Aabb box;
  for (const glm::dvec3& corner : object.vertices) box.include(corner);
  return box;
}

double widest_margin(const Mesh& object) {
  double sides = 0;
  for (std::size_t i = 0; i < object.triangles.size(); ++i) {
    Aabb box;
    for (const glm::dvec3& corner : object.corners(i)) box.include(corner);
    sides += largest_of(box.extent());
  }
  return std::min(kWidest * largest_of(box_of(object).extent()),
                  kWidestOfTriangle * sides / static_cast<double>(object.triangles.size()));
}

/// Where instances are at the moments of the scene's animation.
std::vector<std::vector<glm::dmat4>> transforms_of(const Scene& scene) {
  std::vector<std::vector<glm::dmat4>> transforms;
  for (const double time : moments_of(scene)) transforms.push_back(transforms_at(scene, time));
  return transforms;
}

/// A cube around the scene that contains the origins of all rays, with room for a camera that goes
/// round it.
Aabb reach_of(const Scene& scene, const glm::dvec3& eye, const std::vector<Aabb>& boxes,
              const std::vector<std::vector<glm::dmat4>>& transforms) {
  Aabb world;
  for (const std::vector<glm::dmat4>& at : transforms) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      world.include(transformed_box(boxes[scene.instances[i].object], at[i]));
    }
  }
  const glm::dvec3 middle = 0.5 * (world.low + world.high);
  double reach = std::max(glm::length(world.high - middle), glm::length(eye - middle));
  for (const PointLight& light : scene.lights) {
    reach = std::max(reach, glm::length(light.position - middle));
  }
  for (const double time : moments_of(scene)) {
    const auto camera = camera_at(scene, time);
    if (camera) reach = std::max(reach, glm::length(camera->position - middle));
  }
  return {middle - glm::dvec3(reach), middle + glm::dvec3(reach)};
}

/// For each object, however wide.
std::vector<double> needed_margins(const Scene& scene, const glm::dvec3& eye,
                                   const MemoryFormat& format) {
  std::vector<Aabb> boxes;
  for (const Mesh& object : scene.objects) boxes.push_back(box_of(object));
  const std::vector<std::vector<glm::dmat4>> transforms = transforms_of(scene);
  const Aabb world = reach_of(scene, eye, boxes, transforms);

  const bool nearest = format.rounding == hls::Rounding::kNearestEven;
  const double rounding = std::ldexp(nearest ? 0.5 : 1.0, -static_cast<int>(format.mantissa_bits));
  std::vector<double> margins(boxes.size(), 0);
  for (const std::vector<glm::dmat4>& at : transforms) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      const std::size_t object = scene.instances[i].object;
      const Aabb rays = transformed_box(world, glm::inverse(at[i]));
      const double distance =
          largest_of(glm::max(boxes[object].high - rays.low, rays.high - boxes[object].low));
      margins[object] = std::max(margins[object], kRoundings * rounding * distance);
    }
  }
  return margins;
}

/// The cost of a primitive in a leaf, in steps of the traversal; those of a fast one are cheaper
/// (docs/results/fast.md).
double item_cost(const CoreConfiguration& core) {
  return core.datapath == Datapath::kFast ? 3 : TreeCosts{}.item;
}

}  // namespace

Scene with_rounded_corners(Scene scene, const MemoryFormat& format) {
  for (Mesh& object : scene.objects) {
    for (glm::dvec3& corner : object.vertices) {
      for (int axis = 0; axis < 3; ++axis) corner[axis] = format.round(corner[axis]);
    }
  }
  return scene;
}

std::vector<double> rounding_margins(const Scene& scene, const glm::dvec3& eye,
                                     const MemoryFormat& format) {
  std::vector<double> margins = needed_margins(scene, eye, format);
  for (std::size_t k = 0; k < margins.size(); ++k) {
    margins[k] = std::min(margins[k], widest_margin(scene.objects[k]));
  }
  return margins;
}

std::vector<std::string> beyond_margins(const Scene& scene, const glm::dvec3& eye,
                                        const MemoryFormat& format) {
  const std::vector<double> margins = needed_margins(scene, eye, format);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < margins.size(); ++k) {
    if (margins[k] > widest_margin(scene.objects[k])) names.push_back(scene.objects[k].name);
  }
  return names;
}

Leaves leaves_of(const CoreConfiguration& core) {
  return core.datapath == Datapath::kFast ? Leaves::kPointers : Leaves::kNodes;
}

double object_cost(const CoreConfiguration& core) {
  return core.datapath == Datapath::kFast ? 16 : BoxTreeOptions{}.item;
}

TreeSize memory_for_trees(const CoreInfo& core) {
  CoreConfiguration whole = core;
  whole.address_bits = kAddressBits;
  const TreeSize ends = address_ends(whole);
  return {ends.nodes - 1, ends.items};
}

SceneTrees trees_for(const Scene& scene, const glm::dvec3& eye, const CoreInfo& core,
                     TreeOptions options) {
  options.grid = Grid(*core.format);
  options.costs.item = item_cost(core);
  options.object_cost = object_cost(core);
  options.leaves = leaves_of(core);
  options.main_first = core.main_first;
  const TreeSize memory = memory_for_trees(core);
  if (!core.is_watertight()) {
    return build_scene_trees(scene, options, memory);
  }
  return build_scene_trees(with_rounded_corners(scene, *core.format), options, memory,
                           rounding_margins(scene, eye, *core.format));
}

}  // namespace dynrt::host
