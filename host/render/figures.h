// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Figures from a frame's counters: how busy each unit was, how often each cache hit.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/render/frame.h"

namespace dynrt::host {

/// Of a unit, or of the same unit in each of several pipelines.
struct UnitFigures {
  std::string name;
  std::uint64_t transactions = 0;
  std::optional<double> utilisation;  ///< transactions per cycle; a unit starts one a clock at most
  std::optional<double> stalled;      ///< share of cycles in which an output had no room
};

struct CacheFigures {
  std::string name;  ///< "node", "list" or "matrix"; "second" of the second level
  std::uint64_t lookups = 0;
  std::uint64_t misses = 0;
  double hit_rate = 1;
};

/// What goes between the core and its memory in a frame, in bytes.
struct MemoryFigures {
  std::optional<std::uint64_t> read;  ///< of the scene; none without counters
  std::uint64_t pixels = 0;           ///< written
  std::uint64_t hits = 0;             ///< written
};

struct FrameFigures {
  std::vector<UnitFigures> units;  ///< the busiest first
  MemoryFigures memory;
  std::vector<CacheFigures> caches;
  std::optional<double> frames_per_second;  ///< at the stated clock
  std::optional<double> rays_per_clock;
  std::optional<double> clocks_per_second;  ///< of the simulation
  double rays_per_second = 0;               ///< of the simulation
  /// Pushes onto full stacks, after which hits may be missing. None without counters.
  std::optional<std::uint64_t> dropped_pushes;
};

/// A counter of one pipeline, or of something that all pipelines share, or the sum over several,
/// under its name in a core of one.
struct CounterTotal : Counter {
  unsigned pipelines = 0;  ///< that count it
};
using CounterTotals = std::vector<CounterTotal>;

/// In the order of the frame's counters.
CounterTotals totals_of(const Frame& frame);

/// The value of a counter, the sum over all pipelines; none if the frame has no such counter.
std::optional<std::uint64_t> value_of(const Frame& frame, std::string_view counter);

double per_ray(const Frame& frame, std::uint64_t bytes);
/// Bytes of the scene that the core read; none without counters.
std::optional<double> bytes_per_ray(const Frame& frame);

/// `clock_hz`: the core's clock for frames per second.
FrameFigures figures_of(const Frame& frame, double clock_hz);

}  // namespace dynrt::host
