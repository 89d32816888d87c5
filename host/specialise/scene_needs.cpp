// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/scene_needs.h"

#include <algorithm>

#include "host/specialise/tree_needs.h"

namespace dynrt::host {

namespace {

constexpr char kTopLevel[] = "instances";

/// The larger of two needs.
void include(SceneNeeds::Stack& stack, const SceneNeeds::Stack& other) {
  if (other.pushes > stack.pushes || stack.tree.empty()) stack = other;
}
/// Items of a tree in which none is repeated need no slots.
void include(SceneNeeds::Repeats& repeats, const SceneNeeds::Repeats& other) {
  if (repeats.tree.empty()) {
    repeats = other;
    return;
  }
  const bool counts = other.repeated > 0;
  const std::size_t items =
      repeats.repeated == 0 ? other.items : std::max(repeats.items, other.items);
  if (counts && other.repeated > repeats.repeated) repeats = other;
  if (counts) repeats.items = items;
}

bool stands_as_it_is(const Scene& scene) {
  return scene.objects.size() == 1 && scene.instances.size() == 1 &&
         scene.instances.front().transform == glm::dmat4(1.0);
}

void count_surfaces(SceneNeeds& needs, const Scene& scene) {
  for (const Mesh& object : scene.objects) {
    needs.primitives.triangles += object.triangles.size();
    needs.primitives.rectangles += object.rectangles.size();
    needs.primitives.spheres += object.ellipsoids.size();
    for (std::size_t i = 0; i < object.primitives(); ++i) {
      const Material& material = scene.materials.at(object.material_of(i));
      needs.colours.insert(colour_bits(material.diffuse));
      if (!object.is_ellipsoid(i) && material.mirror > 0) needs.mirror = material.name;
    }
  }
}

}  // namespace

void SceneNeeds::include(const SceneNeeds& other) {
  frames += other.frames;
  objects = std::max(objects, other.objects);
  instances = std::max(instances, other.instances);
  one_level = one_level && other.one_level;
  main_first = main_first || other.main_first;
  host::include(top_stack, other.top_stack);
  host::include(object_stack, other.object_stack);
  host::include(instance_repeats, other.instance_repeats);
  host::include(primitive_repeats, other.primitive_repeats);
  primitives.triangles = std::max(primitives.triangles, other.primitives.triangles);
  primitives.rectangles = std::max(primitives.rectangles, other.primitives.rectangles);
  primitives.spheres = std::max(primitives.spheres, other.primitives.spheres);
  lights = std::max(lights, other.lights);
  if (mirror.empty()) mirror = other.mirror;
  colours.insert(other.colours.begin(), other.colours.end());
  places.nodes = std::max(places.nodes, other.places.nodes);
  places.entries = std::max(places.entries, other.places.entries);
  places.matrices = std::max(places.matrices, other.places.matrices);
}

SceneNeeds frame_needs(const SceneNeeds& before, const Scene& scene, const Tree& instances) {
  SceneNeeds needs = before;
  needs.frames = 1;
  needs.one_level = stands_as_it_is(scene);
  needs.main_first = instances.main_leaf != kNullNode;
  needs.instances = scene.instances.size();
  needs.lights = scene.lights.size();
  const TreeNeeds top = tree_needs(instances);
  needs.top_stack = {top.pushes, kTopLevel};
  needs.instance_repeats = {top.items, top.repeated, kTopLevel};
  const std::size_t of_instance = has_mirrors(scene) ? 2 : 1;
  needs.places = {needs.still.nodes + instances.size().nodes,
                  needs.still.entries + instances.size().items,
                  needs.still.matrices + of_instance * scene.instances.size() + 1 + needs.lights +
                      matrices_of_boxes(scene) * needs.boxes_of_instance};
  return needs;
}

SceneNeeds scene_needs(const Scene& scene, const SceneTrees& trees, TriangleMatrix form,
                       std::size_t boxes_of_instance) {
  SceneNeeds needs;
  needs.boxes_of_instance = boxes_of_instance;
  needs.scene = scene.name;
  needs.objects = scene.objects.size();
  needs.still.nodes = 1;  // the null node
  count_surfaces(needs, scene);
  std::size_t numbers = 0;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const TreeNeeds object = tree_needs(trees.objects[k]);
    const std::string& name = scene.objects[k].name;
    include(needs.object_stack, {object.pushes, name});
    include(needs.primitive_repeats, {object.items, object.repeated, name});
    needs.still.nodes += trees.objects[k].size().nodes;
    needs.still.entries += trees.objects[k].size().items;
    numbers += numbers_taken(scene, scene.objects[k], form);
  }
  needs.still.matrices = matrices_taken(numbers, form);
  SceneNeeds all = frame_needs(needs, scene, trees.instances);
  all.places.matrices = std::max(all.places.matrices, numbers);
  return all;
}

}  // namespace dynrt::host
