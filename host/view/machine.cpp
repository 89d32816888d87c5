// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/machine.h"

#include <algorithm>
#include <string>

#include "host/render/figures.h"

namespace dynrt::host {

namespace {

Json or_null(const auto& value) { return value ? Json(*value) : Json(); }

std::string unit_of(const std::string& port) { return port.substr(0, port.find('.')); }

/// The units, each once, and how many tokens go between them.
Json channels_json(const Still& still) {
  Json channels = Json::array();
  for (const WatchedChannel& channel : still.watch->channels) {
    Json from = Json::array(), to = Json::array();
    for (const std::string& port : channel.from) from.push_back(unit_of(port));
    for (const std::string& port : channel.to) to.push_back(unit_of(port));
    const auto tokens =
        std::ranges::find(still.watched->counters, channel.name + ".tokens", &Counter::name);
    channels.push_back(
        {{"name", channel.name},
         {"from", from},
         {"to", to},
         {"tokens", tokens == still.watched->counters.end() ? Json() : Json(tokens->value)}});
  }
  return channels;
}

Json units_json(const Still& still) {
  const FrameWatch& watch = *still.watch;
  const Frame& frame = *still.watched;
  Json units = Json::array();
  for (std::size_t i = 0; i < watch.units.size(); ++i) {
    const auto count = [&](const char* what) -> std::optional<std::uint64_t> {
      const auto found = std::ranges::find(frame.counters, watch.units[i] + what, &Counter::name);
      if (found == frame.counters.end()) return std::nullopt;
      return found->value;
    };
    units.push_back({{"name", watch.units[i]},
                     {"group", watch.groups[i]},
                     {"transactions", or_null(count(".transactions"))},
                     {"stalls", or_null(count(".stalls"))},
                     {"work", watch.work[i]}});
  }
  return units;
}

}  // namespace

Json machine_json(const Still& still, const Json& clock) {
  const Frame& frame = *still.watched;
  const FrameFigures figures = figures_of(frame, clock.at("mhz").get<double>() * 1e6);
  Json caches = Json::array();
  for (const CacheFigures& cache : figures.caches) {
    caches.push_back({{"name", cache.name},
                      {"lookups", cache.lookups},
                      {"misses", cache.misses},
                      {"hit_rate", cache.hit_rate}});
  }
  return {{"number", still.number},
          {"configuration", frame.core.name},
          {"packets", frame.packets},
          {"lines", frame.lines},
          {"cycles", or_null(frame.run.cycles)},
          {"frames_per_second", or_null(figures.frames_per_second)},
          {"rays_per_clock", or_null(figures.rays_per_clock)},
          {"clock", clock},
          {"dropped_pushes", or_null(figures.dropped_pushes)},
          {"caches", caches},
          {"part_clocks", still.watch->part_clocks},
          {"units", units_json(still)},
          {"channels", channels_json(still)}};
}

}  // namespace dynrt::host
