// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The input of a stress case: a scene, some with trees made by hand, and frames. A frame of one
// pixel is one ray, chosen exactly; a frame whose pixels are a power of two apart is a pencil of
// rays, each of them exact.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/analysis/stress/numbers.h"
#include "host/analysis/truth/truth.h"
#include "host/render/render.h"
#include "host/scene/scene.h"
#include "host/tree/scene_trees.h"

namespace dynrt::host::stress {

/// A frame, and the camera that makes its rays.
struct Shot {
  Camera camera;
  FrameOptions options;
};

/// The rays whose truth is computed.
enum class Rays : std::uint8_t {
  kOfCore,   ///< those that the core has once the camera's matrix and they themselves are rounded
  kOfCamera  ///< those that the user asked for
};

struct Trial {
  Scene scene;
  std::vector<Shot> shots;
  Rays rays = Rays::kOfCore;
  std::optional<SceneTrees> trees{};  ///< by hand; else they are built
  TreeOptions tree_options{};
  BoxTreeOptions instance_options{};
  std::string configuration{};  ///< that it needs in place of the one that is asked for
};

/// A pencil of width x height rays of one origin: pixel (x, y) has the direction
/// first + x * across + y * down.
Shot pencil(const glm::dvec3& origin, const glm::dvec3& first, const glm::dvec3& across,
            const glm::dvec3& down, unsigned width, unsigned height);
/// One ray.
Shot ray(const glm::dvec3& origin, const glm::dvec3& direction);
/// A picture of the surroundings of `target`, with the camera turned towards it.
Shot picture(const glm::dvec3& position, const glm::dvec3& target, double field_of_view,
             unsigned width, unsigned height);

/// The ray of a pixel; of the core's rays those components that stand for zero are zero.
TruthRay ray_of(const Shot& shot, unsigned x, unsigned y, Rays rays, const MemoryFormat& numbers);

/// As in dynrt's other commands: moved and scaled to fit the core's numbers (host/layout/fit.h).
Trial fitted(Trial trial, const MemoryFormat& numbers);

/// One object, once, where it is.
Scene scene_of(Mesh mesh);
/// Adds an object with one instance.
void add(Scene& scene, Mesh mesh, const glm::dmat4& transform = glm::dmat4(1.0));

}  // namespace dynrt::host::stress
