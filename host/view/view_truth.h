// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the rays of a frame really hit, beside what the core has found. A build without the
// libraries of the analysis has no truth.
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

/// A core's hit beside the truth.
enum class Verdict : std::uint8_t { kRight, kOther, kMissed, kNothingThere };

/// The rays of a frame, through the centres of its pixels.
struct FrameRays {
  const Camera& camera;
  unsigned width, height;
};

class ViewTruth {
 public:
  virtual ~ViewTruth() = default;
  /// The scene must not change. Null in a build that has no truth.
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
