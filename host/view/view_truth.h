// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The true hits of a frame's rays, to compare the core's hits with. A build without CGAL and Embree
// cannot compute them.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "host/format/memory_format.h"
#include "host/render/frame.h"
#include "host/scene/primitive_id.h"
#include "host/scene/scene.h"

namespace dynrt::host {

/// How a core's hit compares with the true one.
enum class Verdict : std::uint8_t { kRight, kOther, kMissed, kNothingThere };

/// The rays of a frame, through the centres of its pixels.
struct FrameRays {
  const Camera& camera;
  unsigned width, height;
};

class ViewTruth {
 public:
  virtual ~ViewTruth() = default;
  /// The scene must not change. Null in a build that cannot compute true hits.
  static std::unique_ptr<ViewTruth> of(const Scene& scene);

  /// The true hit of a pixel; where the core hits the same primitive, the distances of its numbers
  /// from the true ones in units of the last place.
  virtual nlohmann::ordered_json pixel(const FrameRays& rays, unsigned x, unsigned y,
                                       const HitRecord& hit,
                                       const std::optional<PrimitiveId>& primitive,
                                       const MemoryFormat& format) const = 0;
  /// Of all pixels, row by row.
  virtual std::vector<Verdict> verdicts(
      const FrameRays& rays, std::span<const std::optional<PrimitiveId>> primitives) const = 0;
};

}  // namespace dynrt::host
