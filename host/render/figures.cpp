// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/figures.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "hls/counter_name.h"
#include "host/render/counter_names.h"
#include "units/options.h"

namespace dynrt::host {

namespace {

constexpr std::string_view kTransactions = hls::suffix_of(hls::Counted::kTransactions);

std::vector<UnitFigures> units_of(const Frame& frame) {
  std::vector<UnitFigures> units;
  const auto totals = totals_of(frame);
  for (const auto& [name, total] : totals) {
    if (!name.ends_with(kTransactions)) continue;
    UnitFigures unit;
    unit.name = name.substr(0, name.size() - kTransactions.size());
    unit.transactions = total.value;
    if (frame.run.cycles && *frame.run.cycles > 0) {
      const double clocks = static_cast<double>(*frame.run.cycles) * total.pipelines;
      unit.utilisation = static_cast<double>(total.value) / clocks;
      const auto stalls = totals.find(hls::counter_name(unit.name, hls::Counted::kStalls));
      if (stalls != totals.end()) {
        unit.stalled = static_cast<double>(stalls->second.value) / clocks;
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
  for (const counters::OfCache& of : counters::kCaches) {
    const auto lookups = value_of(frame, of.lookups);
    const auto fills = value_of(frame, of.fills);
    if (!lookups || !fills) continue;
    CacheFigures cache;
    cache.name = of.cache;
    cache.lookups = *lookups;
    cache.misses =
        *fills - std::min<std::uint64_t>(*fills, std::uint64_t{frame.lines} * frame.core.pipelines);
    if (cache.lookups > 0) {
      cache.hit_rate = 1 - static_cast<double>(cache.misses) / static_cast<double>(cache.lookups);
    }
    caches.push_back(cache);
  }
  return caches;
}

}  // namespace

std::map<std::string, CounterTotal> totals_of(const Frame& frame) {
  std::map<std::string, CounterTotal> totals;
  for (const Counter& counter : frame.counters) {
    CounterTotal& total = totals[plain_name(counter.name, frame)];
    total.value += counter.value;
    total.order_independent = counter.order_independent;
    ++total.pipelines;
  }
  return totals;
}

std::string plain_name(const std::string& counter, const Frame& frame) {
  for (unsigned p = 0; frame.core.pipelines > 1 && p < frame.core.pipelines; ++p) {
    const std::string prefix = pipeline_prefix(p);
    if (counter.starts_with(prefix)) return counter.substr(prefix.size());
  }
  return counter;
}

std::optional<std::uint64_t> value_of(const Frame& frame, std::string_view counter) {
  const auto totals = totals_of(frame);
  const auto found = totals.find(std::string(counter));
  if (found == totals.end()) return std::nullopt;
  return found->second.value;
}

FrameFigures figures_of(const Frame& frame, double clock_hz) {
  FrameFigures figures;
  figures.units = units_of(frame);
  figures.caches = caches_of(frame);
  figures.dropped_pushes = value_of(frame, counters::kDroppedPushes);
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
