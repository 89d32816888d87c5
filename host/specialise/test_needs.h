// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The needs of small scenes, for tests.
#pragma once

#include "host/specialise/scene_needs.h"
#include "host/tree/scene_trees.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host::testing {

inline SceneNeeds needs_of(const Scene& scene,
                           TriangleMatrix form = TriangleMatrix::kNormalConsistent) {
  return scene_needs(scene, build_scene_trees(scene), form);
}

inline Mesh one_triangle(const std::string& name) {
  Mesh mesh;
  mesh.name = name;
  add_triangle(mesh, {0, 0, -5}, {1, 0, -5}, {0, 1, -5});
  return mesh;
}

/// An instance of the last object, moved along x.
inline void add_instance(Scene& scene, double x) {
  scene.instances.push_back({"i", static_cast<std::uint32_t>(scene.objects.size() - 1),
                             glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0, 0))});
}

}  // namespace dynrt::host::testing
