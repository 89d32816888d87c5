// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/figures.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "hls/counter_name.h"
#include "host/render/counter_names.h"
#include "units/memory_format.h"
#include "units/options.h"

namespace dynrt::host {

namespace {

constexpr std::string_view kTransactions = hls::suffix_of(hls::Counted::kTransactions);

/// The counter's name in a core of one pipeline.
std::string plain_name(const std::string& counter, unsigned pipelines) {
  for (unsigned p = 0; pipelines > 1 && p < pipelines; ++p) {
    const std::string prefix = pipeline_prefix(p);
    if (counter.starts_with(prefix)) return counter.substr(prefix.size());
  }
  return counter;
}

std::optional<std::uint64_t> value_of(const CounterTotals& totals, std::string_view counter) {
  const auto found = std::ranges::find(totals, counter, &Counter::name);
  if (found == totals.end()) return std::nullopt;
  return found->value;
}

std::vector<UnitFigures> units_of(const Frame& frame, const CounterTotals& totals) {
  std::vector<UnitFigures> units;
  for (const CounterTotal& total : totals) {
    if (!total.name.ends_with(kTransactions)) continue;
    UnitFigures unit;
    unit.name = total.name.substr(0, total.name.size() - kTransactions.size());
    unit.transactions = total.value;
    if (frame.run.cycles && *frame.run.cycles > 0) {
      const double clocks = static_cast<double>(*frame.run.cycles) * total.pipelines;
      unit.utilisation = static_cast<double>(total.value) / clocks;
      if (const auto stalls =
              value_of(totals, hls::counter_name(unit.name, hls::Counted::kStalls))) {
        unit.stalled = static_cast<double>(*stalls) / clocks;
      }
    }
    units.push_back(std::move(unit));
  }
  std::ranges::sort(units, [](const UnitFigures& a, const UnitFigures& b) {
    return a.transactions != b.transactions ? a.transactions > b.transactions : a.name < b.name;
  });
  return units;
}

CacheFigures cache_of(std::string name, std::uint64_t lookups, std::uint64_t misses) {
  CacheFigures cache{.name = std::move(name), .lookups = lookups, .misses = misses};
  if (lookups > 0) {
    cache.hit_rate = 1 - static_cast<double>(misses) / static_cast<double>(lookups);
  }
  return cache;
}

/// A cache's filling half takes one transaction for every miss, and before the frame one to empty
/// each line.
std::vector<CacheFigures> caches_of(const Frame& frame, const CounterTotals& totals) {
  std::vector<CacheFigures> caches;
  for (const counters::OfCache& of : counters::kCaches) {
    const auto lookups = value_of(totals, of.lookups);
    const auto fills = value_of(totals, of.fills);
    if (!lookups || !fills) continue;
    const std::uint64_t emptied = std::uint64_t{frame.lines} * frame.core.pipelines;
    caches.push_back(cache_of(of.cache, *lookups, *fills - std::min(*fills, emptied)));
  }
  return caches;
}

/// The second level's, if there is one.
std::optional<CacheFigures> second_level_of(const Frame& frame, const CounterTotals& totals) {
  const auto lookups = value_of(totals, counters::kPortLines);
  const auto beats = value_of(totals, counters::kBeats);
  if (frame.core.second_level == 0 || !lookups || !beats) return std::nullopt;
  return cache_of("second", *lookups,
                  *beats * frame.core.port_bytes / frame.core.second_line_bytes());
}

MemoryFigures memory_of(const Frame& frame, const std::vector<CacheFigures>& caches,
                        const CounterTotals& totals) {
  MemoryFigures memory;
  memory.pixels = frame.core.pixel_bytes() * frame.pixels.size();
  memory.hits = 2 * kHitWords * sizeof(std::uint32_t) * frame.hits.size();
  if (const auto beats = value_of(totals, counters::kBeats)) {
    memory.read = *beats * frame.core.port_bytes;
    return memory;
  }
  for (const CacheFigures& cache : caches) {
    const auto of = std::ranges::find(counters::kCaches, cache.name, &counters::OfCache::cache);
    memory.read = memory.read.value_or(0) +
                  cache.misses * of->words * sizeof(std::uint32_t) * frame.core.format->bus_words();
  }
  return memory;
}

}  // namespace

CounterTotals totals_of(const Frame& frame) {
  CounterTotals totals;
  std::map<std::string, std::size_t> places;
  for (const Counter& counter : frame.counters) {
    std::string name = plain_name(counter.name, frame.core.pipelines);
    const auto [place, is_new] = places.emplace(name, totals.size());
    if (is_new) totals.push_back({{std::move(name), 0, counter.order_independent}});
    CounterTotal& total = totals[place->second];
    total.value += counter.value;
    ++total.pipelines;
  }
  return totals;
}

std::optional<std::uint64_t> value_of(const Frame& frame, std::string_view counter) {
  return value_of(totals_of(frame), counter);
}

double per_ray(const Frame& frame, std::uint64_t bytes) {
  return static_cast<double>(bytes) / static_cast<double>(frame.pixels.size());
}

std::optional<double> bytes_per_ray(const Frame& frame) {
  const CounterTotals totals = totals_of(frame);
  const auto read = memory_of(frame, caches_of(frame, totals), totals).read;
  return read ? std::optional(per_ray(frame, *read)) : std::nullopt;
}

FrameFigures figures_of(const Frame& frame, double clock_hz) {
  const CounterTotals totals = totals_of(frame);
  FrameFigures figures;
  figures.units = units_of(frame, totals);
  figures.caches = caches_of(frame, totals);
  figures.memory = memory_of(frame, figures.caches, totals);
  if (auto second = second_level_of(frame, totals)) figures.caches.push_back(*std::move(second));
  figures.dropped_pushes = value_of(totals, counters::kDroppedPushes);
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
