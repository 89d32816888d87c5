// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a scene is before it is packed for the board: objects made of triangles, instances of them
// placed in the world, lights, a camera, and how these move. All in doubles: rounding to the core's
// format happens once, when the memory image is written. Lengths are in the file's unit (metres in
// scenes/*.json), times in seconds, colours in [0, 1], angles nowhere. A loaded scene has at least
// one triangle, finite vertices, no triangle of zero area and only instances whose transform has an
// inverse.
#ifndef DYNRT_HOST_SCENE_SCENE_H_
#define DYNRT_HOST_SCENE_SCENE_H_

#include <cstddef>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace dynrt::host {

// How much a mirror reflects that is not said to reflect more or less.
inline constexpr double kMirrorShare = 0.8;

struct Material {
  std::string name;
  glm::dvec3 diffuse{0.8};
  double mirror = 0.0;  // the part of the light that it reflects, 0 to 1
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
  glm::dmat4 transform{1.0};  // object to world, affine; of what moves: at time 0
  std::optional<uint32_t> motion = std::nullopt;  // what moves it, an index into Scene::motion
};

// A value at a time, in seconds. Keys of a list are in order of time, no two at the same.
template <typename T>
struct Keyframe {
  double time = 0.0;
  T value;
};

// A link of the chain that places a moving instance: scaled, rotated and moved as its keys say
// (none of a kind: not at all), or by a fixed transform. animation.h evaluates it.
struct MotionNode {
  std::string name;
  std::optional<uint32_t> parent;  // a lower index into Scene::motion; none: the world
  glm::dmat4 transform{1.0};       // to the parent, of a node without keys
  std::vector<Keyframe<glm::dvec3>> position;
  std::vector<Keyframe<glm::dquat>> rotation;
  std::vector<Keyframe<glm::dvec3>> scale;
  bool repeats = false;  // from the start after its last key

  bool moves() const { return !position.empty() || !rotation.empty() || !scale.empty(); }
};

// The primary ray through (x', y') in [-1/2, 1/2]^2 starts at position and goes along
// x' * right + y' * up + forward (thesis 6.2.1): right and up carry the field of view.
struct Camera {
  glm::dvec3 position{0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 forward{0.0, 0.0, -1.0};
};

// Where a walk's camera is at a time, in seconds.
struct PathKey {
  double time = 0.0;
  glm::dvec3 position{0.0};
  glm::dvec3 look_at{0.0};
};

// Shines from a point in all directions. The colour, times the light's intensity, is not negative
// and may be above 1; its unit is the file's (candela in glTF).
struct PointLight {
  std::string name;
  glm::dvec3 position{0.0};
  glm::dvec3 colour{1.0};
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
  std::vector<PointLight> lights;
  std::vector<std::string> distant_lights;  // at infinity, so none of the above: their names
  std::vector<MotionNode> motion;
  std::optional<uint32_t> camera_motion = std::nullopt;  // what moves the camera, in its place
  std::vector<PathKey> path;                             // the same, in order of time
  glm::dvec3 path_up{0.0, 1.0, 0.0};
  ImportCounts dropped;
  std::vector<std::string> notes;  // sentences for the user: what was taken otherwise than asked
};

}  // namespace dynrt::host

#endif  // DYNRT_HOST_SCENE_SCENE_H_
