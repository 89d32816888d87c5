// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a scene is before it is packed for the board: objects made of triangles, instances of them
// placed in the world, a camera. All in doubles: rounding to the core's format happens once, when
// the memory image is written. Lengths are in the file's unit (metres in scenes/*.json), colours
// in [0, 1], angles nowhere. A loaded scene has at least one triangle, finite vertices, no
// triangle of zero area and only instances whose transform has an inverse.
#ifndef DYNRT_HOST_SCENE_SCENE_H_
#define DYNRT_HOST_SCENE_SCENE_H_

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace dynrt::host {

struct Material {
  std::string name;
  glm::dvec3 diffuse{0.8};
};

// An object: what a bottom-level tree is built over.
struct Mesh {
  std::string name;
  std::vector<glm::dvec3> vertices;
  std::vector<glm::uvec3> triangles;
  std::vector<uint32_t> material;  // one per triangle, an index into Scene::materials
};

struct Instance {
  std::string name;
  uint32_t object = 0;
  glm::dmat4 transform{1.0};  // object to world, affine
};

// The primary ray through (x', y') in [-1/2, 1/2]^2 starts at position and goes along
// x' * right + y' * up + forward (thesis 6.2.1): right and up carry the field of view.
struct Camera {
  glm::dvec3 position{0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 forward{0.0, 0.0, -1.0};
};

// What the import left out, for the report.
struct ImportCounts {
  std::size_t zero_area_triangles = 0;
  std::size_t points_and_lines = 0;
};

struct Scene {
  std::string name;
  std::vector<Material> materials;
  std::vector<Mesh> objects;
  std::vector<Instance> instances;
  std::optional<Camera> camera;  // of the file, for a square image: camera.h fits it to another
  ImportCounts dropped;
  std::vector<std::string> notes;  // sentences for the user: what was taken otherwise than asked
};

}  // namespace dynrt::host

#endif  // DYNRT_HOST_SCENE_SCENE_H_
