// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The needs of small scenes, for tests.
#pragma once

#include "host/image/form_trees.h"
#include "host/specialise/scene_needs.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host::testing {

inline SceneNeeds needs_of(const Scene& scene, const ImageForm& form = {}) {
  return scene_needs(scene, trees_for(scene, glm::dvec3(0.0), form), form.triangles);
}

/// What the scene takes of the memory.
inline MemoryUse laid_out(const Scene& scene, const ImageForm& form = {}) {
  const Camera camera;
  const SceneTrees trees = trees_for(scene, camera.position, form);
  const ObjectImage objects(scene, trees.objects, form);
  return memory_use(FrameImage(scene, objects, trees.instances, camera, 64, 48));
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
