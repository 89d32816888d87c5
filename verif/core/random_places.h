// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Where a closed mesh may lie: shifted, scaled, turned and among others; and how many of such
// places a test tries.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>
#include <vector>

#include "hls/random.h"

namespace dynrt::host {

using hls::testing::Random;

inline std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* wanted = std::getenv(name);
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : otherwise;
}
inline std::uint64_t rays_wanted(std::uint64_t otherwise) {
  return from_environment("DYNRT_RAYS", otherwise);
}
/// Of the slow tests, which several processes may share.
inline std::uint64_t slow_seed() { return from_environment("DYNRT_SEED", 100'000); }

inline double unit(Random& random) {
  return static_cast<double>(random.below(1u << 30)) * 0x1p-29 - 1;
}
inline glm::dvec3 in_ball(Random& random) {
  for (;;) {
    const glm::dvec3 v(unit(random), unit(random), unit(random));
    if (glm::dot(v, v) < 1) return v;
  }
}

/// Where a mesh lies in its object, and the object in the world.
struct Place {
  glm::dvec3 shift{0.0};  ///< of the mesh's corners, in radii
  double scale = 1;       ///< of the corners, shift and all: a power of two
  glm::dmat4 instance{1.0};
  std::vector<glm::dvec3> others{};  ///< further instances: where their middles are, in radii
};

/// Shifts by none to 4096 radii and scales of 2^-20 to 2^20; every second one in an instance that
/// is turned, scaled unevenly and mirrored, and every second one among twenty others, which may
/// reach into it.
inline Place any_place(Random& random) {
  static constexpr double kShifts[] = {0, 0, 16, 256, 4096};
  Place place;
  place.shift = kShifts[random.below(std::size(kShifts))] * in_ball(random);
  place.scale = std::exp2(static_cast<int>(random.below(41)) - 20);
  if (random.below(2) == 0) {
    const double size = std::exp2(3 * unit(random));
    glm::dmat4 m(1.0);
    m = glm::rotate(m, 3.2 * unit(random), in_ball(random));
    m = glm::scale(m, size * glm::dvec3(1, -0.5 - 0.25 * unit(random), 1.5));
    place.instance = glm::rotate(m, 3.2 * unit(random), in_ball(random));
  }
  if (random.below(2) == 0) {
    for (unsigned i = 0; i < 20; ++i) place.others.push_back(6.0 * in_ball(random));
  }
  return place;
}

/// How far rounding moves the corners and the eye, in radii.
inline double blur(const Place& place) { return 2 * glm::length(place.shift) * 0x1p-16; }

}  // namespace dynrt::host
