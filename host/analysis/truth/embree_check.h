// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Compares Embree's answers with the truth. Embree intersects floats: vertices, origin, direction
// and distances are rounded. This must explain every difference, so each is put into the class that
// explains it; a difference without a class is a mistake of Embree or of the truth.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/analysis/truth/truth.h"

namespace dynrt::host {

struct EmbreeComparison {
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;  ///< of the truth
  std::uint64_t same = 0;  ///< the same primitive, or none in both
  /// Another primitive that is hit at exactly the same t: of an edge or vertex, or coincident.
  std::uint64_t ties = 0;
  /// Another distance that floats cannot tell from the true one.
  std::uint64_t near_in_distance = 0;
  /// Only one of the two hits the primitive, and the ray passes its edge nearer than floats can
  /// tell.
  std::uint64_t near_an_edge = 0;
  std::uint64_t unexplained = 0;
  std::optional<std::size_t> first_unexplained{};  ///< of the rays

  std::string text() const;
};

/// Takes only scenes of triangles and rays with an interval from 0 to infinity. `hits` are the true
/// hits of `rays`.
EmbreeComparison compare_with_embree(const Truth& truth, std::span<const TruthRay> rays,
                                     std::span<const std::optional<TruthHit>> hits);

}  // namespace dynrt::host
