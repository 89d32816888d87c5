// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Writes the files of the core's join for one configuration: the Verilog top, the header with the
// positions of the frame's registers and the numbers of its start, and a description as JSON. UNITS
// is CMake's list of units (list_units.h); it is an error if the join has other units.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include DYNRT_CONFIG_HEADER
#include "join/emit_top.h"
#include "units/list_units.h"
#include "units/pixel.h"
#include "units/scan_out.h"
#include "units/start.h"

namespace {

using C = dynrt::config::DYNRT_CONFIG;

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

/// Of the memory's port, if the core has one.
std::string memory_macros(const auto& define) {
  if (!dynrt::kHasPort<C>) return {};
  return "\n// The memory's port (hls/units/memory_port.h).\n" +
         define("MEMORY_ID_BITS", hls::bit_width_of<dynrt::PortId<C>>()) +
         define("MEMORY_BEAT_BYTES", dynrt::kBeatBytes<C>) +
         define("MEMORY_PIXEL_BYTES", dynrt::PixelOf<C>::kBytes) +
         define("MEMORY_READ_BEATS", dynrt::kReadBeats<C>);
}

/// What the Verilog around the core takes from the units besides the fields of a frame.
std::string board_macros() {
  const auto define = [](const std::string& name, unsigned value) {
    return "`define DYNRT_CORE_" + name + " " + std::to_string(value) + "\n";
  };
  return "\n// The start of a frame (hls/units/start.h).\n" +
         define("RESET_CLOCKS", dynrt::kResetClocks) + define("FIRST_PACKET", dynrt::kFirstPacket) +
         define("START_PAUSE", dynrt::kStartPause) +
         "\n// The SCAN registers (hls/units/scan_out.h).\n" +
         define("SCAN_WORDS", dynrt::kScanWords) + memory_macros(define);
}

void check_units(const std::string& path, dynrt::Core<C>& core) {
  std::ifstream file(path);
  const std::string listed(std::istreambuf_iterator<char>(file), {});
  dynrt::UnitLines lines(DYNRT_CONFIG_NAME);
  core.name_units(lines);
  if (listed.find(lines.text()) == std::string::npos) {
    throw std::runtime_error(path +
                             ": the core's list of units has changed; run cmake again, so that the "
                             "build lowers all units of the join");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: elaborate UNITS TOP\n");
    return 2;
  }
  try {
    hls::Join join;
    const auto core = std::make_unique<dynrt::Core<C>>(join, dynrt::Banks<C>{});
    check_units(argv[1], *core);
    const std::string top = argv[2];
    write(top + ".v", hlsc::emit_top(join.record(), "dynrt_core"));
    write(top + ".vh", hlsc::emit_header(join.record(), "dynrt_core") + board_macros());
    write(top + ".json", hlsc::emit_json(join.record(), "dynrt_core"));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "elaborate: %s\n", error.what());
    return 1;
  }
  return 0;
}
