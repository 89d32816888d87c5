// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A small scene of two levels in the memory, for tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "host/layout/frame_image.h"
#include "host/tree/scene_trees.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host::testing {

/// A core with room for every stack.
inline CoreInfo test_core(const MemoryFormat& format = kShippedFormat) {
  CoreInfo core(format);
  core.name = "test";
  core.packets = 8;
  core.lines = 16;
  core.stack_depth = 63;
  return core;
}

inline Scene two_objects() {
  Scene scene = scene_of(soup(1, 200, 0.3));
  scene.materials.push_back({"orange", {1.0, 0.5, 0.0}});
  Mesh ball;
  ball.name = "ball";
  add_sphere(ball, {0, 0, 0}, 1, 6);
  std::fill(ball.material.begin(), ball.material.end(), 1);
  scene.objects.push_back(ball);
  scene.instances.clear();
  for (std::uint32_t i = 0; i < 5; ++i) {
    glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(3.0 * i, 0.1, 0.2));
    m = glm::rotate(m, 0.3 * i, glm::dvec3(0.3, 1, 0.2));
    scene.instances.push_back({"i", i % 2, glm::scale(m, glm::dvec3(1, 0.7, -1.3))});
  }
  return scene;
}

struct Laid {
  Scene scene;
  SceneTrees trees;
  ObjectImage objects;
  FrameImage frame;
  SceneMemory memory;

  Laid(Scene s, const Camera& camera, const MemoryFormat& format = kShippedFormat)
      : scene(std::move(s)),
        trees(build_scene_trees(scene, {.grid = Grid(format)})),
        objects(scene, trees.objects, test_core(format)),
        frame(scene, objects, trees.instances, camera, 512, 384),
        memory(format) {
    memory.write(objects.memory.runs());
    memory.write(frame.memory.runs());
  }
};

/// As near as one rounding to the core's format lets them be.
inline void expect_near(const glm::dmat4x3& got, const glm::dmat4x3& expected,
                        const MemoryFormat& format = kShippedFormat) {
  const int half_step = -1 - static_cast<int>(format.mantissa_bits);
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 3; ++r) {
      ASSERT_NEAR(got[c][r], expected[c][r],
                  std::ldexp(std::abs(expected[c][r]), half_step) + 2 * format.smallest);
    }
  }
}

}  // namespace dynrt::host::testing
