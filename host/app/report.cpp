// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/report.h"

#include <fmt/format.h>

#include <iterator>

#include "host/app/text.h"

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

Json value_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::string units_text(const FrameFigures& figures) {
  if (figures.units.empty()) return "";
  std::string text =
      fmt::format("  {:<18}{:>14}{:>9}{:>9}\n", "unit", "transactions", "busy", "stalled");
  const auto percent = [](const std::optional<double>& share) {
    return share ? fmt::format("{:.1f} %", 100 * *share) : std::string("-");
  };
  for (const UnitFigures& unit : figures.units) {
    fmt::format_to(std::back_inserter(text), "  {:<18}{:>14}{:>9}{:>9}\n", unit.name,
                   grouped(unit.transactions), percent(unit.utilisation), percent(unit.stalled));
  }
  return text;
}

std::string caches_text(const FrameFigures& figures) {
  std::string text;
  for (const CacheFigures& cache : figures.caches) {
    fmt::format_to(std::back_inserter(text), "  {:<18}{:>14}{:>9}\n", cache.name + " cache",
                   grouped(cache.lookups), fmt::format("{:.2f} %", 100 * cache.hit_rate));
  }
  return text.empty() ? text
                      : fmt::format("  {:<18}{:>14}{:>9}\n", "cache", "lookups", "hits") + text;
}

std::string memory_text(const Frame& frame, const MemoryFigures& memory) {
  std::string text = "memory      bytes per ray: ";
  if (memory.read) text += fmt::format("{:.2f} read, ", per_ray(frame, *memory.read));
  text += fmt::format("{:g} of pixels written", per_ray(frame, memory.pixels));
  if (memory.hits > 0) text += fmt::format(", {:g} of hits", per_ray(frame, memory.hits));
  if (frame.timing) {
    text += fmt::format("; a port of {} bytes, {} clocks", frame.core.port_bytes,
                        frame.timing->latency);
    if (frame.timing->row_clocks > 0) {
      text += fmt::format(", {} more to open a row", frame.timing->row_clocks);
    }
  }
  return text + "\n";
}

Json memory_json(const Frame& frame, const MemoryFigures& memory) {
  Json json = {{"bytes_read", memory.read ? Json(*memory.read) : Json()},
               {"pixel_bytes_written", memory.pixels},
               {"hit_bytes_written", memory.hits},
               {"latency", Json()},
               {"row_clocks", Json()}};
  if (frame.timing) {
    json["latency"] = frame.timing->latency;
    json["row_clocks"] = frame.timing->row_clocks;
  }
  return json;
}

}  // namespace

std::string report_text(const Frame& frame, const FrameFigures& figures, const CoreClock& clock) {
  std::string text;
  const auto line = [&text]<class... A>(fmt::format_string<A...> format, A&&... args) {
    fmt::format_to(std::back_inserter(text), format, std::forward<A>(args)...);
    text += '\n';
  };
  line("board       {}, configuration {}, {} packets, {} lines in each cache", frame.board,
       frame.core.name, frame.packets, frame.lines);
  if (frame.hits.empty()) {
    line("pixels      {}, without hit records", grouped(frame.pixels.size()));
  } else {
    line("pixels      {}, {} of them hit something", grouped(frame.pixels.size()),
         grouped(frame.hit_count()));
  }
  if (frame.run.cycles) {
    line("frame       {} cycles{}, {:.2f} frames per second at {:g} MHz, {:.4f} rays per clock",
         grouped(*frame.run.cycles), frame.run.scheduled ? " from the units' schedules" : "",
         figures.frames_per_second.value_or(0), clock.mhz, figures.rays_per_clock.value_or(0));
    text += clock.text();
    line("simulation  {:.2f} s, {} clocks per second", frame.run.seconds,
         grouped(static_cast<std::uint64_t>(figures.clocks_per_second.value_or(0))));
  } else {
    line("simulation  {:.2f} s, {} rays per second", frame.run.seconds,
         grouped(static_cast<std::uint64_t>(figures.rays_per_second)));
  }
  text += memory_text(frame, figures.memory);
  if (frame.run.missed_pixels) {
    line(
        "warning     the display had to wait for its memory and missed pixels of pictures of this "
        "size; the frame itself is complete");
  }
  line("bus         {} bytes written, {} read, {} transactions, {:.3f} s on {}",
       grouped(frame.traffic.bytes_written), grouped(frame.traffic.bytes_read),
       grouped(frame.traffic.transactions), frame.traffic.seconds(), frame.bus);
  if (figures.dropped_pushes.value_or(0) > 0) {
    line(
        "warning     {} pushes onto full stacks (of {} entries) were dropped: hits may be missing; "
        "use a configuration with deeper stacks, such as deep",
        grouped(*figures.dropped_pushes), frame.core.stack_depth);
  }
  if (!frame.core.counters) line("counters    configuration {} has none", frame.core.name);
  return text + units_text(figures) + caches_text(figures);
}

Json report_json(const Frame& frame, const FrameFigures& figures, const CoreClock& clock) {
  Json units = Json::object();
  for (const UnitFigures& unit : figures.units) {
    units[unit.name] = {{"transactions", unit.transactions},
                        {"utilisation", value_or_null(unit.utilisation)},
                        {"stalled", value_or_null(unit.stalled)}};
  }
  Json caches = Json::object();
  for (const CacheFigures& cache : figures.caches) {
    caches[cache.name] = {
        {"lookups", cache.lookups}, {"misses", cache.misses}, {"hit_rate", cache.hit_rate}};
  }
  Json counters = Json::object();
  for (const Counter& total : totals_of(frame)) counters[total.name] = total.value;
  for (const Counter& counter : frame.counters) counters[counter.name] = counter.value;
  return {{"board", frame.board},
          {"configuration", frame.core.name},
          {"packets", frame.packets},
          {"cache_lines", frame.lines},
          {"width", frame.width},
          {"height", frame.height},
          {"hits", frame.hits.empty() ? Json() : Json(frame.hit_count())},
          {"cycles", frame.run.cycles ? Json(*frame.run.cycles) : Json()},
          {"cycles_by_schedule", frame.run.scheduled},
          {"clock_hz", clock.hz()},
          {"clock", clock.json()},
          {"frames_per_second", value_or_null(figures.frames_per_second)},
          {"display_missed_pixels", frame.run.missed_pixels},
          {"rays_per_clock", value_or_null(figures.rays_per_clock)},
          {"simulation",
           {{"seconds", frame.run.seconds},
            {"clocks_per_second", value_or_null(figures.clocks_per_second)},
            {"rays_per_second", figures.rays_per_second}}},
          {"memory", memory_json(frame, figures.memory)},
          {"bus",
           {{"transactions", frame.traffic.transactions},
            {"bytes_written", frame.traffic.bytes_written},
            {"bytes_read", frame.traffic.bytes_read},
            {"bus_clocks", frame.traffic.bus_clocks},
            {"clock_hz", frame.traffic.clock_hz},
            {"seconds", frame.traffic.seconds()}}},
          {"dropped_pushes", figures.dropped_pushes ? Json(*figures.dropped_pushes) : Json()},
          {"units", units},
          {"caches", caches},
          {"counters", counters}};
}

std::string comparison_text(const Comparison& comparison, const std::string& left,
                            const std::string& right) {
  std::string text = fmt::format(
      "compared    {} hit records, {} pixels, {} counters of {} and {}: {} + {} + {} differ\n",
      grouped(comparison.pixels), grouped(comparison.pixels), comparison.counters, left, right,
      comparison.different_hits, comparison.different_pixels, comparison.different_counters);
  if (comparison.first) {
    text += fmt::format("first difference: {}\n", comparison.first->text(left, right));
  }
  return text;
}

Json comparison_json(const Comparison& comparison) {
  Json json = {{"identical", comparison.identical()},
               {"pixels", comparison.pixels},
               {"hits", comparison.hits},
               {"counters", comparison.counters},
               {"different_hits", comparison.different_hits},
               {"different_pixels", comparison.different_pixels},
               {"different_counters", comparison.different_counters},
               {"first", Json()}};
  if (const auto& first = comparison.first) {
    json["first"] = {{"field", first->field}, {"left", first->left}, {"right", first->right}};
    if (first->x) {
      json["first"]["x"] = *first->x;
      json["first"]["y"] = *first->y;
    }
  }
  return json;
}

}  // namespace dynrt::host
