// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What follows from the keys of a configuration for the units and the host alike. The enumerations
// that keys are of come from their table (hls/configs/configurations/keys.py).
#pragma once

#include <algorithm>
#include <string>

#include "configs/choices.h"

namespace dynrt {

/// The beginning of the names that units, channels and RAMs of one of several pipelines have.
inline std::string pipeline_prefix(unsigned pipeline) {
  return "p" + std::to_string(pipeline) + "_";
}

/// Whether rays that miss the box of an object in the world do not enter the object
/// (units/world_box.h). Boxes are stored as they lie from the point where all rays start.
constexpr bool tests_world_box(Origins origins, unsigned levels) {
  return origins == Origins::kCommon && levels == 2;
}
template <class C>
inline constexpr bool kTestsWorldBox = tests_world_box(C::kOrigins, C::kLevels);

/// Bytes of a line of the second level of cache: a line of the first lies in it, 8 bytes for each
/// node, and it takes at least a beat of the port.
constexpr unsigned second_line_bytes(unsigned line_nodes, unsigned port_bytes) {
  return std::max({16u, 8 * line_nodes, port_bytes});
}

/// The unit objects that are intersected (thesis 5.2).
struct Primitives {
  bool triangle = false;
  bool sphere = false;  ///< hence every ellipsoid
  bool rectangle = false;

  constexpr unsigned count() const { return unsigned{triangle} + sphere + rectangle; }
  friend constexpr bool operator==(const Primitives&, const Primitives&) = default;
};

}  // namespace dynrt
