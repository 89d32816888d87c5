// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Embree's own answers beside the truth. Embree intersects floats: vertices, origin and direction
// are rounded, distances too. Where the two name different triangles that must be why, so every
// difference is put into the class that explains it; one that none explains is a mistake of either.
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
  /// The ray passes the edge of the primitive that one of the two alone hits nearer than floats can
  /// tell.
  std::uint64_t near_an_edge = 0;
  std::uint64_t unexplained = 0;
  std::optional<std::size_t> first_unexplained{};  ///< of the rays

  std::string text() const;
};

/// Scenes of triangles alone. Rays whose interval is not from 0 to infinity are not for it. `hits`
/// are the truth's of `rays`.
EmbreeComparison compare_with_embree(const Truth& truth, std::span<const TruthRay> rays,
                                     std::span<const std::optional<TruthHit>> hits);

}  // namespace dynrt::host
