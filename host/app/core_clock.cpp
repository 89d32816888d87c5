// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/core_clock.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "host/app/arguments.h"
#include "host/error.h"

namespace dynrt::host {

std::string_view clocks_json();  // of the build

namespace {

std::vector<PlacedClock> read_clocks() {
  std::vector<PlacedClock> clocks;
  for (const auto& one : nlohmann::json::parse(clocks_json())) {
    clocks.push_back({.configuration = one.at("configuration"),
                      .device = one.at("device"),
                      .part = one.at("part"),
                      .grade = one.at("grade"),
                      .mhz = one.at("mhz"),
                      .lowest_mhz = one.at("lowest_mhz"),
                      .highest_mhz = one.at("highest_mhz"),
                      .seeds = one.at("seeds"),
                      .placer = one.at("placer"),
                      .date = one.at("date"),
                      .verilog = one.at("verilog")});
  }
  return clocks;
}

/// The values of a field in the table's order, each once, of the placements that fit.
template <class Fits>
std::string listed(std::string PlacedClock::* field, Fits&& fits) {
  std::vector<std::string> names;
  for (const PlacedClock& clock : placed_clocks()) {
    if (fits(clock) && std::ranges::count(names, clock.*field) == 0) names.push_back(clock.*field);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string all_devices() {
  return listed(&PlacedClock::device, [](const PlacedClock&) { return true; });
}

std::string grades_of(std::string_view device) {
  return listed(&PlacedClock::grade, [&](const PlacedClock& c) { return c.device == device; });
}

/// A file may have the name of a listed configuration and other keys.
bool is_core(const PlacedClock& clock, const CoreConfiguration& core) {
  const CoreConfiguration* listed = listed_configuration(clock.configuration);
  return listed != nullptr && *listed == core;
}

}  // namespace

std::span<const PlacedClock> placed_clocks() {
  static const std::vector<PlacedClock> clocks = read_clocks();
  return clocks;
}

std::string CoreClock::text() const {
  if (of_board) return fmt::format("clock       {:g} MHz, that of the board\n", mhz);
  if (placed == nullptr) return fmt::format("clock       {:g} MHz, as --clock says\n", mhz);
  if (own) {
    return fmt::format(
        "clock       {:g} MHz, placed: {} on {}, median of {} seeds ({:g} to {:g} MHz), on {}\n",
        mhz, placed->configuration, placed->where(), placed->seeds, placed->lowest_mhz,
        placed->highest_mhz, placed->date);
  }
  const bool same_name = std::ranges::find(placed_clocks(), configuration,
                                           &PlacedClock::configuration) != placed_clocks().end();
  return fmt::format("clock       {:g} MHz, placed: {} on {}; {} was not placed and may miss it\n",
                     mhz, placed->configuration, placed->where(),
                     same_name ? "this core has other keys," : configuration);
}

nlohmann::ordered_json CoreClock::json() const {
  nlohmann::ordered_json json = {
      {"mhz", mhz}, {"placed", placed != nullptr}, {"of_board", of_board}};
  if (placed == nullptr) return json;
  json.update({{"device", placed->device},
               {"grade", placed->grade},
               {"configuration", placed->configuration},
               {"of_this_configuration", own},
               {"lowest_mhz", placed->lowest_mhz},
               {"highest_mhz", placed->highest_mhz},
               {"seeds", placed->seeds},
               {"placer", placed->placer},
               {"date", placed->date},
               {"verilog", placed->verilog}});
  return json;
}

void ClockFlags::add_to(CLI::App& command) {
  command
      .add_option(
          "--device", device,
          fmt::format("FPGA whose placed clock gives the frames per second: {}; a configuration "
                      "that was not placed takes the slowest clock on it, and a real board has "
                      "its own clock",
                      all_devices()))
      ->option_text(fmt::format("NAME [{}]", device));
  command
      .add_option("--grade", grade,
                  fmt::format("speed grade of the device; of {}: {}", device, grades_of(device)))
      ->option_text(fmt::format("N [{}]", placed_clocks().front().grade));
  command
      .add_option("--clock", mhz,
                  "clock of the core for frames per second, instead of a placed one")
      ->option_text("MHZ")
      ->check(not_a_number);
}

void ClockFlags::check() const {
  if (mhz && !(*mhz > 0)) refuse("--clock {}: the clock is a number of MHz above zero", *mhz);
  first_on_device();
}

CoreClock ClockFlags::clock_of(const CoreInfo& core, std::optional<double> board_hz) const {
  if (mhz) return {.mhz = *mhz};
  if (board_hz) return {.mhz = *board_hz / 1e6, .of_board = true};
  const PlacedClock& first = first_on_device();
  const PlacedClock* slowest = &first;
  for (const PlacedClock& c : placed_clocks()) {
    if (c.device != first.device || c.grade != first.grade) continue;
    if (is_core(c, core)) {
      return {.mhz = c.mhz, .placed = &c, .own = true, .configuration = core.name};
    }
    if (c.mhz < slowest->mhz) slowest = &c;
  }
  return {.mhz = slowest->mhz, .placed = slowest, .own = false, .configuration = core.name};
}

const PlacedClock& ClockFlags::first_on_device() const {
  const auto clocks = placed_clocks();
  const auto on = std::ranges::find(clocks, device, &PlacedClock::device);
  if (on == clocks.end()) {
    refuse(
        "--device {}: no core was placed on such a device, so it has no clock; those with a clock: "
        "{}",
        device, all_devices());
  }
  if (!grade) return *on;
  const auto of_grade = std::ranges::find_if(
      clocks, [&](const PlacedClock& c) { return c.device == device && c.grade == *grade; });
  if (of_grade == clocks.end()) {
    refuse(
        "--grade {}: no core was placed on {} of this grade, so it has no clock; those with a "
        "clock: {}",
        *grade, device, grades_of(device));
  }
  return *of_grade;
}

}  // namespace dynrt::host
