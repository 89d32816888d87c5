// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt specialise: the smallest core that renders a scene, its Verilog, and its savings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>

#include "hls/json_text.h"
#include "host/app/choose_format.h"
#include "host/app/command.h"
#include "host/app/special_core.h"
#include "host/app/specialise_page.h"
#include "host/app/text.h"
#include "host/board/load_configuration.h"
#include "host/error.h"
#include "host/format/configuration_json.h"
#include "host/picture/output_file.h"

namespace dynrt::host {

namespace {

namespace fs = std::filesystem;

struct Arguments {
  SceneArguments scene;
  SpecialiseWishes wishes;
  FormatWish format;
  std::string out, json;
  std::vector<std::string> devices = {"ecp5-85"};
  bool no_hardware = false;
};

/// What scripts/core_costs says of the Verilog in a folder; without one it checks tools and
/// devices.
Json hardware_of(const Arguments& arguments, const std::string& verilog) {
  std::vector<std::string> words;
  if (!verilog.empty()) words.push_back(verilog);
  for (const std::string& device : arguments.devices) words.push_back("--device=" + device);
  if (arguments.wishes.jobs > 0) words.push_back(fmt::format("--jobs={}", arguments.wishes.jobs));
  return Json::parse(made_by_script("core_costs", words, ""));
}

/// Refuses mistakes before the work.
void check(const Arguments& arguments) {
  require_whole_build();
  const double slowdown = arguments.wishes.max_slowdown;
  if (!std::isfinite(slowdown) || slowdown < 0)
    refuse("--max-slowdown {:g}: a part in percent, 0 or more", slowdown);
  arguments.format.check();
  const Output outputs[] = {{"--json", arguments.json}};
  check_outputs(outputs);
  const bool is_new = !fs::exists(arguments.out);
  std::error_code error;
  fs::create_directories(arguments.out, error);
  if (error)
    refuse("--out {}: cannot be written ({}); name a folder elsewhere", arguments.out,
           error.message());
  check_output_path((fs::path(arguments.out) / "analysis.json").string());
  if (is_new) fs::remove(arguments.out);
  if (!arguments.no_hardware) hardware_of(arguments, "");
}

/// Area, gates, stages and the clocks of a frame with so many packets and lines.
Json costs_of(const Arguments& arguments, CostMeter& meter, const LoweredCore& core,
              unsigned packets, unsigned lines) {
  Json costs = {{"clocks", meter.count(core, packets, lines).clocks}};
  if (!arguments.no_hardware) costs.update(hardware_of(arguments, core.verilog));
  return costs;
}

/// Of use without the build that made it.
bool is_delivered(const fs::path& file) {
  const std::string kind = file.extension();
  return kind == ".v" || kind == ".vh" || kind == ".json" || kind == ".txt";
}

/// Writes the folder, and removes the files that an earlier core with other units has left.
void deliver(const fs::path& out, const LoweredCore& core, Json& result) {
  const auto text_of = [](const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const Json before = Json::parse(std::ifstream(out / "analysis.json"), nullptr, false);
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(core.verilog)) {
    if (is_delivered(file.path())) names.push_back(file.path().filename());
  }
  std::ranges::sort(names);
  result["verilog"] = names;
  fs::create_directories(out / "verilog");
  for (const std::string& name : names) {
    write_text(out / "verilog" / name, text_of(fs::path(core.verilog) / name));
  }
  write_text(out / "configuration.json", text_of(core.configuration));
  write_text(out / "analysis.json", hls::json_text(result));
  if (!before.is_object() || !before.contains("verilog")) return;
  for (const Json& earlier : before.at("verilog")) {
    const fs::path name = earlier.is_string() ? earlier.get<std::string>() : "";
    std::error_code gone;
    if (name != name.filename() || std::ranges::find(names, name.string()) != names.end()) {
      continue;
    }
    fs::remove(out / "verilog" / name, gone);
  }
}

int run(Arguments arguments) {
  const std::string name = core_name(arguments.scene.scene);
  if (arguments.out.empty()) arguments.out = name + ".specialised";
  check(arguments);
  SceneFile file(arguments.scene, true);
  SpecialiseWishes& wishes = arguments.wishes;
  if (wishes.general.empty()) wishes.general = general_configuration(file);
  if (arguments.format.max_error) {
    wishes.formats =
        arguments.format.choose(arguments.scene, wishes.general, arguments.out, wishes.jobs);
  }
  const SpecialCore core = special_core(file, wishes);
  CostMeter meter(file, wishes.frames);
  const LoweredCore general = lowered(wishes.general, wishes.jobs);
  const LoweredCore made = lowered(core.configuration, wishes.jobs);
  const auto decided = [&](const char* key) {
    return core.analysis.at("configuration").at(key).at("value").get<unsigned>();
  };
  Json before = costs_of(arguments, meter, general, core.general.packets, core.general.lines);
  Json now = costs_of(arguments, meter, made, decided("packets"), decided("lines"));
  const Json misfit = now.contains("misfit") ? now.at("misfit") : Json();
  for (Json* costs : {&before, &now}) costs->erase("misfit");
  Json result = core.analysis;
  result["costs"] = {{"general", before}, {"special", now}, {"less", savings(before, now)}};
  deliver(arguments.out, made, result);
  if (!arguments.json.empty()) write_text(arguments.json, hls::json_text(result));
  say(specialise_page(core.about, core.general, result) +
      fmt::format("written     {}/configuration.json, analysis.json and verilog\n", arguments.out));
  if (misfit.is_string())
    refuse("the core made for {} fits no device asked for: {}", name, misfit.get<std::string>());
  return kDone;
}

void add_flags(CLI::App& command, Arguments& arguments) {
  SpecialiseWishes& wishes = arguments.wishes;
  command.add_option("--out", arguments.out, "folder to write to")
      ->option_text("DIR [SCENE.specialised]");
  arguments.format.add_to(command);
  command
      .add_option(
          "--max-slowdown", wishes.max_slowdown,
          "the most that fewer packets and fewer cache lines may slow a frame down, one half "
          "each")
      ->option_text(fmt::format("PERCENT [{:g}]", wishes.max_slowdown));
  command
      .add_option("--keep", wishes.keep,
                  "leave this key of the configuration as it is in the general one; can be given "
                  "several times")
      ->option_text("KEY")
      ->allow_extra_args(false);
  command
      .add_option(
          "--device", arguments.devices,
          "a device that the core must fit, as scripts/synth has them; if several are given, "
          "it must fit one of them")
      ->option_text("NAME [ecp5-85]")
      ->allow_extra_args(false);
  command.add_flag("--no-hardware", arguments.no_hardware,
                   "synthesize nothing: neither area nor gates, in a fraction of the time");
  add_json_flag(command, arguments.json);
  command
      .add_option("--jobs", wishes.jobs,
                  "compilers and synthesizers at a time; default: one for each processor")
      ->option_text("N")
      ->check([](const std::string& text) {
        return text == "0" ? "at least one is needed" : not_a_count(text);
      });
}

}  // namespace

Command add_specialise_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "specialise", "make the smallest core that renders a scene, and show what this saves");
  command->footer(
      "The core renders the scene to the same bits as a general one; its Verilog lacks the parts "
      "that the scene\ndoes not need. The folder receives configuration.json, every key with the "
      "reason for its value, which --config\nof the other commands takes; analysis.json, the "
      "figures behind the decisions and the savings; and verilog/.\ndocs/how-to/specialise.md "
      "explains more.");
  arguments->scene.add_to(*command, true);
  add_configuration_flag(*command, arguments->wishes.general);
  add_flags(*command, *arguments);
  arguments->wishes.frames.add_to(*command);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
