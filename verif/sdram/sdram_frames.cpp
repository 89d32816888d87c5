// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Renders a frame of a native core with an SDRAM behind its port, and writes its costs and its
// waits as JSON. `dynrt report board` makes its tables from it.
#include "sdram/sdram_frames.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hls/json_text.h"
#include "host/error.h"
#include "host/render/figures.h"

namespace dynrt::verif {
namespace {

using Json = nlohmann::ordered_json;

struct Flags {
  std::string scene;
  std::string size = "512x384";
  double core_mhz = 0;
  unsigned sdram_mhz = 133;
  bool no_display = false;
  std::string schedules;
  std::string json;

  void add_to(CLI::App& program) {
    program.add_option("scene", scene, "a built-in name or a file")->required();
    program.add_option("--size", size, "pixels of the frame")->capture_default_str();
    program.add_option("--core-mhz", core_mhz, "clock of the core")
        ->required()
        ->check(CLI::Range(1., 1000.));
    program.add_option("--sdram-mhz", sdram_mhz, "clock of the SDRAM")
        ->capture_default_str()
        ->check(CLI::IsMember({133, 100}));
    program.add_flag("--no-display", no_display, "no display reads its picture");
    program.add_option("--schedule", schedules, "folder of the schedules of the core's units")
        ->required();
    program.add_option("--json", json, "file of the figures")->required();
  }
  SdramRequest request() const {
    SdramRequest request{.scene = scene, .options = {}, .mhz = sdram_mhz, .schedules = schedules};
    unsigned& width = request.options.width;
    unsigned& height = request.options.height;
    if (std::sscanf(size.c_str(), "%ux%u", &width, &height) != 2) {
      host::refuse("--size {}: not a size; write the pixels as WxH, for example 128x96", size);
    }
    request.options.hits = false;
    request.core_nanoseconds = 1000 / core_mhz;
    request.display = !no_display;
    return request;
  }
};

Json sdram_json(const SdramFrame& rendered) {
  const SdramUse& use = rendered.use;
  const SdramCounters& chip = use.chip;
  return {{"clocks", chip.clocks},
          {"busy", chip.busy()},
          {"idle", use.idle_clocks},
          {"activations", chip.activations},
          {"refreshes", chip.refreshes},
          {"refresh_clocks", rendered.refresh_clocks},
          {"bursts", use.bursts},
          {"reads", use.reads},
          {"read_nanoseconds", use.read_nanoseconds},
          {"bytes_read", use.core_reads},
          {"node_bytes_read", use.core_reads_of[0]},
          {"list_bytes_read", use.core_reads_of[1]},
          {"matrix_bytes_read", use.core_reads_of[2]},
          {"bytes_written", use.core_writes},
          {"bytes_displayed", use.display_reads},
          {"late_display_reads", use.late_display}};
}

Json json_of(const SdramFrame& rendered, double core_mhz) {
  const host::Frame& frame = rendered.frame;
  const host::FrameFigures figures = host::figures_of(frame, core_mhz * 1e6);
  Json units = Json::object();
  for (const host::UnitFigures& unit : figures.units) {
    units[unit.name] = {{"utilisation", unit.utilisation.value_or(0)},
                        {"stalled", unit.stalled.value_or(0)}};
  }
  Json caches = Json::object();
  for (const host::CacheFigures& cache : figures.caches) {
    caches[cache.name] = {{"hit_rate", cache.hit_rate}};
  }
  return {{"configuration", frame.core.name},
          {"width", frame.width},
          {"height", frame.height},
          {"cycles", *frame.run.cycles},
          {"sdram", sdram_json(rendered)},
          {"units", units},
          {"caches", caches}};
}

void measure(const Flags& flags) {
  const SdramFrame rendered = frame_of(flags.request());
  if (!rendered.report.empty()) throw std::logic_error(rendered.report);
  std::ofstream file(flags.json);
  file << hls::json_text(json_of(rendered, flags.core_mhz));
  if (!file.flush()) host::refuse("--json {}: cannot be written; name another file", flags.json);
}

int run(int argc, char** argv) {
  CLI::App program("Measures a frame of a core with an SDRAM behind its port.", "sdram_frames");
  Flags flags;
  flags.add_to(program);
  CLI11_PARSE(program, argc, argv);
  try {
    measure(flags);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "sdram_frames: {}\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace dynrt::verif

int main(int argc, char** argv) { return dynrt::verif::run(argc, argv); }
