// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/figures.h"

#include <algorithm>
#include <string_view>

namespace dynrt::host {

namespace {

constexpr std::string_view kTransactions = ".transactions";
constexpr std::string_view kStalls = ".stalls";
constexpr const char* kCaches[] = {"node", "list", "matrix"};

std::optional<std::uint64_t> value_of(const Frame& frame, const std::string& name) {
  const auto found = std::ranges::find(frame.counters, name, &Counter::name);
  if (found == frame.counters.end()) return std::nullopt;
  return found->value;
}

std::vector<UnitFigures> units_of(const Frame& frame) {
  std::vector<UnitFigures> units;
  for (const Counter& counter : frame.counters) {
    if (!counter.name.ends_with(kTransactions)) continue;
    UnitFigures unit;
    unit.name = counter.name.substr(0, counter.name.size() - kTransactions.size());
    unit.transactions = counter.value;
    if (frame.run.cycles && *frame.run.cycles > 0) {
      const auto cycles = static_cast<double>(*frame.run.cycles);
      unit.utilisation = static_cast<double>(counter.value) / cycles;
      if (const auto stalls = value_of(frame, unit.name + std::string(kStalls))) {
        unit.stalled = static_cast<double>(*stalls) / cycles;
      }
    }
    units.push_back(std::move(unit));
  }
  std::ranges::sort(units, [](const UnitFigures& a, const UnitFigures& b) {
    return a.transactions != b.transactions ? a.transactions > b.transactions : a.name < b.name;
  });
  return units;
}

/// A cache's filling half takes one transaction for every miss, and before the frame one to empty
/// each line.
std::vector<CacheFigures> caches_of(const Frame& frame) {
  std::vector<CacheFigures> caches;
  for (const char* name : kCaches) {
    const auto lookups = value_of(frame, std::string(name) + "_lookup.transactions");
    const auto fills = value_of(frame, std::string(name) + "_fill.transactions");
    if (!lookups || !fills) continue;
    CacheFigures cache;
    cache.name = name;
    cache.lookups = *lookups;
    cache.misses = *fills - std::min<std::uint64_t>(*fills, frame.lines);
    if (cache.lookups > 0) {
      cache.hit_rate = 1 - static_cast<double>(cache.misses) / static_cast<double>(cache.lookups);
    }
    caches.push_back(cache);
  }
  return caches;
}

}  // namespace

FrameFigures figures_of(const Frame& frame, double clock_hz) {
  FrameFigures figures;
  figures.units = units_of(frame);
  figures.caches = caches_of(frame);
  figures.dropped_pushes = value_of(frame, "stack_full.tokens");
  const auto rays = static_cast<double>(frame.pixels.size());
  if (frame.run.cycles && *frame.run.cycles > 0) {
    const auto cycles = static_cast<double>(*frame.run.cycles);
    figures.frames_per_second = clock_hz / cycles;
    figures.rays_per_clock = rays / cycles;
    if (frame.run.seconds > 0) figures.clocks_per_second = cycles / frame.run.seconds;
  }
  if (frame.run.seconds > 0) figures.rays_per_second = rays / frame.run.seconds;
  return figures;
}

}  // namespace dynrt::host
