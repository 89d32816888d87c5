// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The truth of a frame: the primitives that its rays really hit, and the picture that the core
// would make without rounding. Rays and hits are those of Truth; brightness comes from them in
// doubles and goes through the rules of the shading units (units/shading.h, units/shader.h), whose
// integers round as the core's do. So this picture and the core's differ only by the error of the
// core's numbers, not by the rounding to 256 levels. Written from those rules, not from their code.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/analysis/truth/truth.h"
#include "host/scene/scene.h"

namespace dynrt::host {

/// The options of the picture.
struct TruthShading {
  unsigned width = 512;
  unsigned height = 384;
  /// A core without light and reflection rays: colour times cosine, nothing of the rest.
  bool eye_light = true;
  bool mirrors = false;      ///< a core that knows mirrors, even if no ray is reflected
  unsigned lights = 0;       ///< the first of the scene's
  unsigned reflections = 0;  ///< bounces
  unsigned ambient = 256;    ///< in 256ths
  std::uint32_t background = 0;
};

/// Red, green and blue in 16ths of a level, as the shader adds them up.
using Sixteenths = std::array<unsigned, 3>;

struct LightRayTruth {
  std::uint32_t pixel = 0;  ///< row by row from the top
  unsigned bounce = 0;      ///< 0: to what the primary ray has hit
  unsigned light = 0;
  bool shadow = false;  ///< something lies before the surface
  Sixteenths adds{};    ///< what the light adds to the pixel where there is no shadow
};

struct ReflectionTruth {
  std::uint32_t pixel = 0;
  unsigned bounce = 1;  ///< of the reflected ray
  std::optional<TruthHit> hit;
};

struct TruthFrame {
  TruthShading shading;
  std::vector<TruthRay> rays;                 ///< primary, one per pixel
  std::vector<std::optional<TruthHit>> hits;  ///< of them
  std::vector<LightRayTruth> light_rays;
  std::vector<ReflectionTruth> reflections;
  std::vector<Sixteenths> unlimited;  ///< of every pixel, as if there were brighter than white
  std::vector<std::uint32_t> pixels;  ///< 0x00BBGGRR
  double seconds = 0;

  std::uint64_t hit_count() const;
};

TruthFrame truth_of_frame(const Truth& truth, const Camera& camera, const TruthShading& shading);

}  // namespace dynrt::host
