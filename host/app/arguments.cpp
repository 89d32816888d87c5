// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <ranges>

#include "host/app/scene_flags.h"
#include "host/app/text.h"
#include "host/error.h"
#include "host/scene/load.h"
#include "host/scene/scene.h"
#include "host/ulx3s/board_at_link.h"
#include "units/memory_format.h"

namespace dynrt::host {

void SceneArguments::add_to(CLI::App& command, bool scene_required) {
  command
      .add_option("SCENE", scene,
                  fmt::format("a built-in scene ({}) or the path of a file: OBJ, PLY, STL, glTF, "
                              "COLLADA, FBX or another format of Assimp, BSP, PK3, JSON",
                              fmt::join(built_in_scenes(), ", ")))
      ->required(scene_required)
      ->option_text(" ");
  add_scene_flags(command, *this);
}

FrameOptions SceneArguments::frame_options() const {
  check_size(width, height);
  return {.width = width, .height = height};
}

void MemoryArguments::add_to(CLI::App& command) {
  command
      .add_option(
          "--memory-latency", latency,
          fmt::format("clocks from a read at the core's memory port to its first data, 1 to {}",
                      kMaxMemoryLatency))
      ->option_text(fmt::format("CLOCKS [{}]", MemoryTiming{}.latency))
      ->check(not_a_count);
  command
      .add_option(
          "--row-clocks", row_clocks,
          fmt::format("additional clocks if the read opens another row of that memory, 0 to {}",
                      kMaxRowClocks))
      ->option_text("CLOCKS [0]")
      ->check(not_a_count);
}

void MemoryArguments::put_into(FrameOptions& options) const {
  options.memory_latency = latency;
  options.row_clocks = row_clocks;
}

void FrameArguments::add_to(CLI::App& command, const std::string& default_out,
                            const std::string& about_out) {
  add_configuration_flag(command, configuration);
  command.add_option("--out", out, about_out)->option_text(fmt::format("FILE [{}]", default_out));
  add_limit_flags(command, packets, lines);
  command
      .add_option("--reflections", reflections,
                  "largest number of bounces of a ray; default: all that the configuration has")
      ->option_text("N")
      ->check(not_a_count);
  command.add_option("--order", order, "order of the packets: morton or scanline")
      ->option_text("ORDER [morton]");
  command.add_flag("--uncompressed", uncompressed,
                   "transform the origin of every ray instead of one for each packet");
  clock.add_to(command);
  memory.add_to(command);
  command
      .add_option("--timeout", timeout,
                  "stop with an error after this many clocks without a pixel or an interrupt")
      ->option_text(fmt::format("CLOCKS [{}]", kTimeout))
      ->check(not_a_count);
  add_json_flag(command, json);
}

FrameOptions FrameArguments::options(const SceneArguments& scene) const {
  FrameOptions options = scene.frame_options();
  options.packets = packets;
  options.lines = lines;
  options.reflections = reflections;
  memory.put_into(options);
  options.uncompressed = uncompressed;
  if (order == "scanline") {
    options.order = RayOrder::kScanline;
  } else if (order != "morton") {
    refuse("--order {}: unknown; the orders are morton and scanline", order);
  }
  clock.check();
  options.timeout = timeout.value_or(kTimeout);
  if (options.timeout == 0) refuse("--timeout 0: the board needs at least one clock");
  return options;
}

std::string hardware_help() {
  const auto held = std::views::transform(linked_cores(), &LinkedCore::configuration);
  return fmt::format(
      "rtl: the Verilog; ulx3s: the Verilog of a whole ULX3S with the configuration {}, simulated "
      "down to its pins; serial:DEVICE: a real ULX3S, Arty or other board at a serial device, with "
      "{}",
      held.front(), fmt::join(held, " or "));
}

std::string board_help() { return "model: the C++ as a native program; " + hardware_help(); }

void FrameArguments::check_timeout(const std::string& board) const {
  if (timeout && board == "model") {
    refuse(
        "--timeout {}: board model counts no clocks of its own, so it needs no timeout; take board "
        "rtl or leave the timeout out",
        *timeout);
  }
}

void SpanArguments::add_to(CLI::App& command) {
  command.add_option("--from", from, "time of the first frame")
      ->option_text("SECONDS [0]")
      ->check(not_a_number);
  command.add_option("--to", to, "time of the last frame; default: the animation's end")
      ->option_text("SECONDS")
      ->check(not_a_number);
}

void add_configuration_flag(CLI::App& command, std::string& configuration) {
  std::vector<std::string_view> names;
  for (const Configuration& c : configurations()) names.push_back(c.name);
  command
      .add_option("--config", configuration,
                  fmt::format("configuration of the core: {}, or a file: FILE.json with the keys "
                              "of a configuration, which dynrt builds, or FILE.so",
                              fmt::join(names, ", ")))
      ->option_text(configuration.empty() ? "NAME|FILE"
                                          : fmt::format("NAME|FILE [{}]", configuration));
}

void add_limit_flags(CLI::App& command, std::optional<unsigned>& packets,
                     std::optional<unsigned>& lines) {
  command
      .add_option("--packets", packets,
                  "packets of rays in flight; default: all that the configuration has")
      ->option_text("N")
      ->check(not_a_count);
  command
      .add_option("--lines", lines,
                  "lines of each cache, a power of two; default: all that the configuration has")
      ->option_text("N")
      ->check(not_a_count);
}

void add_json_flag(CLI::App& command, std::string& json) {
  command.add_option("--json", json, "write the same figures as JSON")->option_text("FILE");
}

std::string not_a_count(const std::string& text) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  std::uint64_t count = 0;
  if (parse(text, count) && count <= kMost) return {};
  return fmt::format("{} is not a whole number from 0 to {}", text, kMost);
}

std::string not_a_number(const std::string& text) {
  double number = 0;
  if (parse(text, number) && std::isfinite(number)) return {};
  return fmt::format("{} is not a finite number", text);
}

}  // namespace dynrt::host
