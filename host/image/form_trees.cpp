// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/image/form_trees.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dynrt::host {

namespace {

/// A hit lies at most so many times the distance of the triangle's farthest corner beside the ray,
/// in units of the rounding of one operation; eight and a half are proved.
constexpr double kRoundings = 16;

double largest_of(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

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
  std::vector<Aabb> boxes(scene.objects.size());
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (const glm::dvec3& corner : scene.objects[k].vertices) boxes[k].include(corner);
  }
  Aabb world;
  for (const Instance& instance : scene.instances) {
    world.include(transformed_box(boxes[instance.object], instance.transform));
  }
  // A cube, as the eye may go round the scene.
  const glm::dvec3 middle = 0.5 * (world.low + world.high);
  double reach = std::max(glm::length(world.high - middle), glm::length(eye - middle));
  for (const PointLight& light : scene.lights) {
    reach = std::max(reach, glm::length(light.position - middle));
  }
  world = {middle - glm::dvec3(reach), middle + glm::dvec3(reach)};

  const bool nearest = format.rounding == hls::Rounding::kNearestEven;
  const double rounding = std::ldexp(nearest ? 0.5 : 1.0, -static_cast<int>(format.mantissa_bits));
  std::vector<double> margins(boxes.size(), 0);
  for (const Instance& instance : scene.instances) {
    const Aabb& box = boxes[instance.object];
    const Aabb rays = transformed_box(world, glm::inverse(instance.transform));
    const double distance = largest_of(glm::max(box.high - rays.low, rays.high - box.low));
    double& margin = margins[instance.object];
    margin = std::max(
        margin, std::min(kRoundings * rounding * distance, kWidest * largest_of(box.extent())));
  }
  return margins;
}

SceneTrees trees_for(const Scene& scene, const glm::dvec3& eye, const ImageForm& form,
                     TreeOptions options) {
  options.grid = Grid(*form.format);
  if (form.triangle_test != TriangleTest::kWatertight) return build_scene_trees(scene, options);
  return build_scene_trees(with_rounded_corners(scene, *form.format), options, kMemoryForTrees,
                           rounding_margins(scene, eye, *form.format));
}

}  // namespace dynrt::host
