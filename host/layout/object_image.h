// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The static part of a scene's image: the objects' trees, lists and triangle matrices,
// laid out once from the bottom of the memory.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <utility>
#include <vector>

#include "host/format/core_info.h"
#include "host/memory/memory.h"
#include "host/scene/scene.h"
#include "host/tree/tree.h"

namespace dynrt::host {

/// The static part. It holds the core that the whole image is laid out for. Throws UserError if a
/// limit of the memory is exceeded or a triangle's matrix is outside the core's numbers.
struct ObjectImage {
  /// The place of an object.
  struct Object {
    std::uint32_t root = 0;          ///< for rays that start inside its box
    std::uint32_t clipped_root = 0;  ///< for all others
    std::uint32_t first_matrix = 0;  ///< of primitive 0, in the numbers of primitives
    Aabb box;
  };
  std::vector<Object> objects;
  MemoryPart memory;
  CoreInfo core;

  /// Of no objects yet.
  explicit ObjectImage(CoreInfo core) : core(std::move(core)) {}
  ObjectImage(const Scene& scene, std::span<const Tree> trees, const CoreInfo& core);

  std::vector<Aabb> boxes() const;
  /// The memory that is left for the top-level tree; of a specialised core also that beyond its
  /// reach, as a frame that needs more is refused by the key that it exceeds.
  TreeSize room_left() const;
};

}  // namespace dynrt::host
