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

/// Each unit once.
Json units_of(const std::vector<std::string>& ports) {
  Json units = Json::array();
  for (const std::string& port : ports) {
    if (std::find(units.begin(), units.end(), unit_of(port)) == units.end())
      units.push_back(unit_of(port));
  }
  return units;
}

/// The units at the ends of each channel, and how many tokens go between them.
Json channels_json(const FullPicture& picture) {
  Json channels = Json::array();
  for (const WatchedChannel& channel : picture.watch->channels) {
    const auto tokens =
        std::ranges::find(picture.watched->counters, channel.name + ".tokens", &Counter::name);
    channels.push_back(
        {{"name", channel.name},
         {"from", units_of(channel.from)},
         {"to", units_of(channel.to)},
         {"tokens", tokens == picture.watched->counters.end() ? Json() : Json(tokens->value)}});
  }
  return channels;
}

/// A FIFO belongs to a writer, to a reader behind a fork, or to the channel as a whole.
Json fifo_json(const FrameWatch& watch, const WatchedFifo& fifo, double cycles) {
  const auto channel = std::ranges::find(watch.channels, fifo.channel, &WatchedChannel::name);
  const bool of_writer = std::ranges::find(channel->from, fifo.port) != channel->from.end();
  const bool of_reader = std::ranges::find(channel->to, fifo.port) != channel->to.end();
  return {{"channel", fifo.channel},
          {"of", of_writer   ? "writer"
                 : of_reader ? "reader"
                             : "channel"},
          {"from", units_of(of_writer ? std::vector{fifo.port} : channel->from)},
          {"to", units_of(of_reader ? std::vector{fifo.port} : channel->to)},
          {"depth", fifo.depth},
          {"tokens", fifo.tokens},
          {"mean", static_cast<double>(fifo.clocks) / cycles},
          {"most", fifo.most}};
}

Json fifos_json(const FullPicture& picture) {
  Json fifos = Json::array();
  const auto cycles = static_cast<double>(picture.watched->run.cycles.value_or(1));
  for (const WatchedFifo& fifo : picture.watch->fifos) {
    fifos.push_back(fifo_json(*picture.watch, fifo, cycles));
  }
  return fifos;
}

/// What a unit waits for, over time.
Json waits_json(const FrameWatch& watch, std::size_t unit) {
  Json waits = Json::array();
  for (const WatchedWait& wait : watch.waits) {
    if (wait.unit != unit) continue;
    waits.push_back(
        {{"for", wait.for_room ? "space" : "token"}, {"fifo", wait.fifo}, {"clocks", wait.clocks}});
  }
  return waits;
}

Json units_json(const FullPicture& picture) {
  const FrameWatch& watch = *picture.watch;
  const Frame& frame = *picture.watched;
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
                     {"work", watch.work[i]},
                     {"waits", waits_json(watch, i)}});
  }
  return units;
}

}  // namespace

Json machine_json(const FullPicture& picture, const Json& clock) {
  const Frame& frame = *picture.watched;
  const FrameFigures figures = figures_of(frame, clock.at("mhz").get<double>() * 1e6);
  Json caches = Json::array();
  for (const CacheFigures& cache : figures.caches) {
    caches.push_back({{"name", cache.name},
                      {"lookups", cache.lookups},
                      {"misses", cache.misses},
                      {"hit_rate", cache.hit_rate}});
  }
  return {{"number", picture.number},
          {"configuration", frame.core.name},
          {"packets", frame.packets},
          {"lines", frame.lines},
          {"cycles", or_null(frame.run.cycles)},
          {"frames_per_second", or_null(figures.frames_per_second)},
          {"rays_per_clock", or_null(figures.rays_per_clock)},
          {"clock", clock},
          {"dropped_pushes", or_null(figures.dropped_pushes)},
          {"caches", caches},
          {"part_clocks", picture.watch->part_clocks},
          {"units", units_json(picture)},
          {"channels", channels_json(picture)},
          {"fifos", fifos_json(picture)}};
}

}  // namespace dynrt::host
