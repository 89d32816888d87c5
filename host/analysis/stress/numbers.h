// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// For putting vertices and rays exactly where a core has numbers.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "host/format/memory_format.h"

namespace dynrt::host::stress {

/// The nearest number; zero, which the core has not, stays zero.
inline double on_grid(const MemoryFormat& numbers, double x) {
  return x == 0 ? 0 : numbers.round(x);
}
inline glm::dvec3 on_grid(const MemoryFormat& numbers, const glm::dvec3& p) {
  return {on_grid(numbers, p.x), on_grid(numbers, p.y), on_grid(numbers, p.z)};
}

/// One step of the mantissa, of 1.
inline double step_of(const MemoryFormat& numbers) {
  return std::ldexp(1.0, -static_cast<int>(numbers.mantissa_bits));
}

}  // namespace dynrt::host::stress
