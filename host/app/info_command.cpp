// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt info: a scene, its trees and the memory they take; nothing is rendered. For a host of one's
// own, the bytes of that memory and the registers of a frame.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "hls/json_text.h"
#include "host/app/arguments.h"
#include "host/app/command.h"
#include "host/app/prepare.h"
#include "host/app/text.h"
#include "host/board/registers.h"
#include "host/error.h"
#include "host/link/port_image.h"
#include "host/picture/output_file.h"
#include "host/render/render.h"
#include "units/memory_format.h"

namespace dynrt::host {

namespace {

struct Arguments {
  SceneArguments scene;
  std::string configuration;
  std::string json, memory, registers;
  std::optional<unsigned> packets, lines;

  bool for_a_core() const { return !memory.empty() || !registers.empty(); }
};

/// The core that the scene is laid out for, if its memory is to be written.
std::optional<CoreInfo> core_of(const Arguments& arguments) {
  if (!arguments.for_a_core()) {
    if (!arguments.configuration.empty()) {
      refuse(
          "--config selects the memory layout, which only --memory and --registers use; give one "
          "of them too");
    }
    return std::nullopt;
  }
  const std::string name = arguments.configuration.empty() ? "fast_port" : arguments.configuration;
  CoreInfo core = make_board(configurations(), BoardRequest{"model", name, ""})->core();
  if (core.memory != MemoryPath::kPort) {
    refuse(
        "configuration {} reads its scene from banks of SRAM, not from a memory behind a port; "
        "take fast_port or another whose key memory is port",
        core.name);
  }
  return core;
}

/// The memory from byte 0 to the last that the scene needs, with zeros where nothing lies.
void write_memory(const std::string& path, const MemoryImage& image) {
  const std::vector<MemoryRun> runs = image.runs();
  std::string bytes;
  for (const MemoryBytes& part : port_image(runs)) {
    bytes.resize(std::max<std::size_t>(bytes.size(), part.address + part.bytes.size()));
    std::ranges::copy(part.bytes, bytes.begin() + part.address);
  }
  write_bytes(path, bytes);
}

nlohmann::ordered_json registers_json(const CoreInfo& core, const FrameConfig& frame) {
  nlohmann::ordered_json writes;
  std::uint32_t address = registers::kRegFrame;
  for (const std::uint32_t word : core.frame_words(frame)) {
    writes.push_back(
        {{"address", fmt::format("0x{:x}", address)}, {"value", fmt::format("0x{:08x}", word)}});
    address += 4;
  }
  return {{"configuration", core.name},
          {"pixels",
           {{"byte", kPixelsAt},
            {"bytes_each", core.pixel_bytes()},
            {"in_a_row", core.pitch(static_cast<unsigned>(frame.width.to_u64()))}}},
          {"hits", {{"byte", kHitsAt}, {"bytes_each", 8 * kHitWords}}},
          {"writes", writes}};
}

int run(const Arguments& arguments) {
  FrameOptions options = arguments.scene.frame_options();
  options.packets = arguments.packets;
  options.lines = arguments.lines;
  const Output outputs[] = {{"--json", arguments.json},
                            {"--memory", arguments.memory},
                            {"--registers", arguments.registers}};
  check_outputs(outputs);
  const std::optional<CoreInfo> core = core_of(arguments);
  const Prepared prepared = prepare(arguments.scene, core ? &*core : nullptr);
  if (!arguments.memory.empty()) write_memory(arguments.memory, prepared);
  if (!arguments.registers.empty()) {
    const FrameConfig frame = frame_config(*core, options, prepared.frame);
    write_text(arguments.registers, hls::json_text(registers_json(*core, frame)));
  }
  if (!arguments.json.empty()) write_text(arguments.json, hls::json_text(prepared.json()));
  say(prepared.text());
  return kDone;
}

}  // namespace

Command add_info_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("info", "show the contents of a scene, its trees and its memory");
  arguments->scene.add_to(*command, true);
  command
      ->add_option(
          "--memory", arguments->memory,
          "write the bytes of the memory of a core with a port, from the scene's first byte on")
      ->option_text("FILE");
  command
      ->add_option("--registers", arguments->registers,
                   "write the registers of a frame, as JSON, in the order in which a host writes "
                   "them before it starts the frame")
      ->option_text("FILE");
  add_limit_flags(*command, arguments->packets, arguments->lines);
  add_configuration_flag(*command, arguments->configuration);
  add_json_flag(*command, arguments->json);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
