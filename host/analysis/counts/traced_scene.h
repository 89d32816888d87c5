// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What all packets of a frame share: the matrices of triangles and instances, and the node at which
// rays enter each tree.
#pragma once

#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "host/analysis/counts/counts.h"

namespace dynrt::host {

/// It refers to all that it is made of.
struct TracedScene {
  TracedScene(const Scene& scene, std::span<const Tree> objects, const TopLevel& top,
              const Camera& camera, const TraceOptions& options);

  const Scene& scene;
  std::span<const Tree> objects;
  const TopLevel& top;
  const Camera& camera;
  const TraceOptions& options;
  std::vector<std::vector<glm::dmat4x3>> triangles;  ///< by object: to the unit triangle or sphere
  std::vector<glm::dmat4> to_object;                 ///< by instance
  std::vector<std::uint32_t> object_start;           ///< by instance
  std::uint32_t top_start = kNullNode;
};

}  // namespace dynrt::host
