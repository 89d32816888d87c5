// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene before it is packed for the board: objects of triangles, rectangles and ellipsoids,
// instances that place them in the world, lights, a camera, and the motion of these. All in
// doubles: rounding to the core's format happens once, when the memory image is written. Lengths
// are in the file's unit (metres in scenes/*.json), times in seconds, colours in [0, 1], angles
// nowhere. A loaded scene has at least one primitive, finite vertices, no triangle of zero area and
// only instances whose transform has an inverse.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace dynrt::host {

/// The share of the light that a mirror reflects by default.
inline constexpr double kMirrorShare = 0.8;

struct Material {
  std::string name;
  glm::dvec3 diffuse{0.8};
  double mirror = 0.0;  ///< the part of the light that it reflects, 0 to 1
};

/// A parallelogram: from its corner along two edges.
struct Rectangle {
  glm::dvec3 corner{0.0};
  glm::dvec3 across{1.0, 0.0, 0.0};
  glm::dvec3 along{0.0, 1.0, 0.0};
  std::uint32_t material = 0;

  std::array<glm::dvec3, 4> corners() const {
    return {corner, corner + across, corner + across + along, corner + along};
  }
};

/// The sphere of radius 1 about the origin under an affine map with an inverse.
struct Ellipsoid {
  glm::dmat4 from_unit{1.0};
  std::uint32_t material = 0;

  /// Half its box: the length of each row.
  glm::dvec3 extent() const {
    const glm::dmat3 rows = glm::transpose(glm::dmat3(from_unit));
    return {glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])};
  }
};

/// An object, over which a bottom-level tree is built. Its primitives are numbered: the triangles
/// first, then the rectangles, then the ellipsoids.
struct Mesh {
  std::string name;
  std::vector<glm::dvec3> vertices;
  std::vector<glm::uvec3> triangles;
  std::vector<std::uint32_t> material;  ///< one per triangle, an index into Scene::materials
  std::vector<Rectangle> rectangles = {};
  std::vector<Ellipsoid> ellipsoids = {};

  std::size_t primitives() const {
    return triangles.size() + rectangles.size() + ellipsoids.size();
  }
  bool is_rectangle(std::size_t primitive) const {
    return primitive >= triangles.size() && primitive < triangles.size() + rectangles.size();
  }
  bool is_ellipsoid(std::size_t primitive) const {
    return primitive >= triangles.size() + rectangles.size();
  }
  const Rectangle& rectangle(std::size_t primitive) const {
    return rectangles[primitive - triangles.size()];
  }
  const Ellipsoid& ellipsoid(std::size_t primitive) const {
    return ellipsoids[primitive - triangles.size() - rectangles.size()];
  }
  std::uint32_t material_of(std::size_t primitive) const {
    return is_ellipsoid(primitive)   ? ellipsoid(primitive).material
           : is_rectangle(primitive) ? rectangle(primitive).material
                                     : material.at(primitive);
  }
  /// The corners of a triangle, or three corners of a rectangle such that the last is next to both
  /// others.
  std::array<glm::dvec3, 3> corners(std::size_t primitive) const {
    if (is_rectangle(primitive)) {
      const Rectangle& r = rectangle(primitive);
      return {r.corner + r.across, r.corner + r.along, r.corner};
    }
    const glm::uvec3& t = triangles[primitive];
    return {vertices[t.x], vertices[t.y], vertices[t.z]};
  }
};

struct Instance {
  std::string name;
  std::uint32_t object = 0;
  glm::dmat4 transform{1.0};  ///< object to world, affine; of what moves: at time 0
  std::optional<std::uint32_t> motion = std::nullopt;  ///< index of its motion in Scene::motion
};

/// A value at a time, in seconds. Keys of a list are in order of time, no two at the same.
template <typename T>
struct Keyframe {
  double time = 0.0;
  T value;
};

/// A link of the chain that places a moving instance. Its keys scale, rotate and move it (no keys
/// of a kind: no change), or it has a fixed transform. animation.h evaluates it.
struct MotionNode {
  std::string name;
  std::optional<std::uint32_t> parent;  ///< a lower index into Scene::motion; none: the world
  glm::dmat4 transform{1.0};            ///< to the parent, of a node without keys
  std::vector<Keyframe<glm::dvec3>> position;
  std::vector<Keyframe<glm::dquat>> rotation;
  std::vector<Keyframe<glm::dvec3>> scale;
  bool repeats = false;  ///< from the start after its last key

  bool moves() const { return !position.empty() || !rotation.empty() || !scale.empty(); }
};

/// The primary ray through (x', y') in [-1/2, 1/2]^2 starts at position and goes along
/// x' * right + y' * up + forward (thesis 6.2.1): right and up carry the field of view.
struct Camera {
  glm::dvec3 position{0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 forward{0.0, 0.0, -1.0};
};

/// Where a walk's camera is at a time, in seconds.
struct PathKey {
  double time = 0.0;
  glm::dvec3 position{0.0};
  glm::dvec3 look_at{0.0};
};

/// Shines from a point in all directions. The colour, times the light's intensity, is not negative
/// and may be above 1; its unit is the file's (candela in glTF).
struct PointLight {
  std::string name;
  glm::dvec3 position{0.0};
  glm::dvec3 colour{1.0};
};

/// Counts of the primitives that the import left out, for the report.
struct ImportCounts {
  std::size_t zero_area_triangles = 0;
  std::size_t points_and_lines = 0;
};

struct Scene {
  std::string name;
  std::vector<Material> materials;
  std::vector<Mesh> objects;
  std::vector<Instance> instances;
  std::optional<Camera> camera;  ///< of the file, for a square image: camera.h fits it to another
  std::vector<PointLight> lights;
  std::vector<std::string> distant_lights;  ///< at infinity, so none of the above: their names
  std::vector<MotionNode> motion;
  std::optional<std::uint32_t> camera_motion =
      std::nullopt;           ///< the motion that places the camera instead
  std::vector<PathKey> path;  ///< the same, in order of time
  glm::dvec3 path_up{0.0, 1.0, 0.0};
  ImportCounts dropped;
  std::vector<std::string> notes;  ///< sentences for the user: differences from the file
};

}  // namespace dynrt::host
