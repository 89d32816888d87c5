// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/fingerprint.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "host/scene/generate.h"
#include "host/scene/load.h"

namespace dynrt::host {
namespace {

Scene moving() {
  Scene scene;
  scene.materials.push_back({"grey"});
  scene.objects.push_back(make_box({-1, -1, -1}, {1, 1, 1}, 0));
  scene.instances = {{"a", 0, glm::dmat4(1.0), 0}, {"b", 0, glm::dmat4(2.0)}};
  scene.camera = Camera();
  scene.lights.push_back({"lamp", {1, 2, 3}});
  MotionNode node;
  node.position = {{0.0, {1, 2, 3}}, {1.0, {4, 5, 6}}};
  node.rotation = {{0.0, glm::dquat(1, 0, 0, 0)}};
  scene.motion.push_back(node);
  scene.path = {{0.0, {1, 1, 1}, {0, 0, 0}}, {2.0, {3, 3, 3}, {0, 0, 0}}};
  return scene;
}

TEST(Fingerprint, DiffersWhereverTheSceneDoes) {
  const std::function<void(Scene&)> kChanges[] = {
      [](Scene&) {},
      [](Scene& s) { s.materials[0].diffuse.y += 1e-9; },
      [](Scene& s) { s.materials[0].mirror = 0.5; },
      [](Scene& s) { s.objects[0].vertices[3].z += 1e-9; },
      [](Scene& s) { std::swap(s.objects[0].triangles[0], s.objects[0].triangles[1]); },
      [](Scene& s) { s.objects[0].triangles.pop_back(), s.objects[0].material.pop_back(); },
      [](Scene& s) { s.objects[0].rectangles.push_back({}); },
      [](Scene& s) { s.objects[0].rectangles.push_back({.along = {0, 0, 1}}); },
      [](Scene& s) { s.objects[0].ellipsoids.push_back({}); },
      [](Scene& s) { s.objects[0].ellipsoids.push_back({.from_unit = glm::dmat4(2.0)}); },
      [](Scene& s) { s.instances[1].transform[3][0] += 1; },
      [](Scene& s) { s.instances[1].motion = 0; },
      [](Scene& s) { s.instances.pop_back(); },
      [](Scene& s) { s.camera->forward *= 2; },
      [](Scene& s) { s.camera.reset(); },
      [](Scene& s) { s.camera_motion = 0; },
      [](Scene& s) { s.lights[0].position.x = -1; },
      [](Scene& s) { s.lights[0].colour.x = 0.5; },
      [](Scene& s) { s.lights.push_back(s.lights[0]); },
      [](Scene& s) { s.motion[0].position[1].time = 1.5; },
      [](Scene& s) { s.motion[0].position[1].value.y = 0; },
      [](Scene& s) { s.motion[0].rotation[0].value.y = 0.1; },
      [](Scene& s) { s.motion[0].repeats = true; },
      [](Scene& s) { s.path[1].look_at.x = 1; },
      [](Scene& s) { s.path_up = {0, 0, 1}; },
  };
  std::set<std::uint64_t> seen;
  for (const auto& change : kChanges) {
    Scene scene = moving();
    change(scene);
    seen.insert(fingerprint(scene));
  }
  EXPECT_EQ(seen.size(), std::size(kChanges));
}

TEST(Fingerprint, IsThatOfTheContentAlone) {
  Scene other = moving();
  other.name = other.instances[0].name = other.materials[0].name = "another";
  EXPECT_EQ(fingerprint(other), fingerprint(moving()));
  EXPECT_EQ(fingerprint(load_scene("lamps")), fingerprint(load_scene("lamps")));
}

}  // namespace
}  // namespace dynrt::host
