// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/counts/traced_scene.h"

#include <cmath>
#include <glm/matrix.hpp>

#include "host/memory/triangle_matrix.h"

namespace dynrt::host {

namespace {

const glm::dmat4x3 kNoMatrix(std::nan(""));

std::uint32_t start(const Tree& tree, const glm::dvec3& origin, Clipping clipping) {
  if (clipping == Clipping::kNever) return tree.root;
  return clipping == Clipping::kAlways ? tree.clipped_root : tree.entry(origin);
}

glm::dmat4x3 unit_matrix_of(const Mesh& mesh, std::size_t primitive) {
  return mesh.is_ellipsoid(primitive)
             ? ellipsoid_matrix(mesh.ellipsoid(primitive)).matrix
             : triangle_matrix(mesh.corners(primitive)).value_or(kNoMatrix);
}

}  // namespace

TracedScene::TracedScene(const Scene& the_scene, std::span<const Tree> the_objects,
                         const TopLevel& the_top, const Camera& the_camera,
                         const TraceOptions& the_options)
    : scene(the_scene),
      objects(the_objects),
      top(the_top),
      camera(the_camera),
      options(the_options) {
  for (const Mesh& mesh : scene.objects) {
    std::vector<glm::dmat4x3>& matrices = triangles.emplace_back();
    for (std::size_t i = 0; i < mesh.primitives(); ++i) matrices.push_back(unit_matrix_of(mesh, i));
  }
  for (const Instance& instance : scene.instances) {
    const glm::dmat4 inverse = glm::inverse(instance.transform);
    to_object.push_back(inverse);
    object_start.push_back(start(objects[instance.object],
                                 glm::dvec3(inverse * glm::dvec4(camera.position, 1.0)),
                                 options.object_clipping));
  }
  if (!top.tree.nodes.empty()) {
    top_start = start(top.tree, camera.position, options.scene_clipping);
  }
}

}  // namespace dynrt::host
