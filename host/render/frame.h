// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A board's results for a frame: its pixels, its hit records, its counters.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/board/board.h"

namespace dynrt::host {

/// The closest hit of a pixel's ray, exactly as it lies in banks 4 and 5. Numbers are the bits of
/// the core's float; a miss has `hit` false and the rest as the core initialised it.
struct HitRecord {
  bool hit = false;
  std::uint32_t object = 0;    ///< matrix of the instance
  std::uint32_t triangle = 0;  ///< matrix of the triangle
  std::uint32_t t = 0;         ///< distance along the ray, in the units of the core's space
  std::uint32_t u = 0;         ///< barycentric coordinates
  std::uint32_t v = 0;
  std::uint32_t cosine = 0;  ///< direction times normal
  friend bool operator==(const HitRecord&, const HitRecord&) = default;
};

struct Frame {
  std::string board;  ///< the name of one (host/board/board.h)
  CoreInfo core;
  unsigned width = 0;
  unsigned height = 0;
  unsigned packets = 0;                ///< that were allowed in flight
  unsigned lines = 0;                  ///< of each cache
  std::optional<MemoryTiming> timing;  ///< of the memory behind the core's port, if it has one
  std::vector<std::uint32_t> pixels;   ///< 0x00BBGGRR, row by row from the top
  std::vector<HitRecord> hits;         ///< one per pixel, or none if the options leave them out
  std::vector<Counter> counters;
  FrameRun run;
  std::optional<double> clock_hz;  ///< of the core, on a board that exists
  std::string_view bus;            ///< what lies between host and board
  BusTraffic upload;               ///< of the scene, or of what changed in it
  BusTraffic traffic;              ///< upload, frame and read-back

  std::uint64_t hit_count() const {
    std::uint64_t count = 0;
    for (const HitRecord& record : hits) count += record.hit;
    return count;
  }
};

}  // namespace dynrt::host
