// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A hit record's six words: pixel p has words 3p to 3p + 2 of bank 4 (t; v; hit flag and object)
// and of bank 5 (u; cosine; triangle).
#pragma once

#include <span>

#include "host/render/frame.h"
#include "units/memory_format.h"

namespace dynrt::host {

inline constexpr std::uint32_t kHitFlag = 1u << 31;

/// `first` and `second` are the pixel's kHitWords words in banks 4 and 5.
inline HitRecord unpack_hit(std::span<const std::uint32_t, kHitWords> first,
                            std::span<const std::uint32_t, kHitWords> second) {
  return {.hit = (first[2] & kHitFlag) != 0,
          .object = first[2] & ~kHitFlag,
          .triangle = second[2],
          .t = first[0],
          .u = second[0],
          .v = first[1],
          .cosine = second[1]};
}

}  // namespace dynrt::host
