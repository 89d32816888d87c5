// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// From the numbers of matrices, as hit records have them, back to the scene.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/layout/frame_image.h"
#include "host/scene/primitive_id.h"

namespace dynrt::host {

/// The primitive and the instance of the matrices in a hit record. Refers to the scene.
class MatrixOwners {
 public:
  MatrixOwners(const Scene& scene, const ObjectImage& objects, const FrameImage& frame);
  /// Nothing for numbers that are no instance's and no primitive's of its object.
  std::optional<PrimitiveId> of(std::uint32_t object, std::uint32_t triangle) const;
  /// The instance that a matrix belongs to, if it is one's.
  std::optional<std::uint32_t> instance_of(std::uint32_t matrix) const;
  /// The primitive of an object that it belongs to, if it is one's.
  std::optional<std::uint32_t> primitive_of(std::uint32_t object, std::uint32_t matrix) const;

 private:
  const Scene& scene_;
  std::uint32_t first_instance_;
  std::uint32_t stride_;                             ///< from one instance's matrix to the next
  std::vector<std::vector<std::uint32_t>> numbers_;  ///< of every object's primitives
};

}  // namespace dynrt::host
