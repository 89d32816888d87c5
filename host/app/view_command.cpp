// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt view: a live window on the core in the browser.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "hls/json_text.h"
#include "host/app/arguments.h"
#include "host/app/board_frame.h"
#include "host/app/command.h"
#include "host/app/kept_trees.h"
#include "host/app/progress.h"
#include "host/app/scene_flags.h"
#include "host/app/text.h"
#include "host/board/load_configuration.h"
#include "host/error.h"
#include "host/picture/output_file.h"
#include "host/view/view.h"

namespace dynrt::host {

namespace {

constexpr unsigned kLastPort = 65535;
constexpr unsigned kRecordedWidth = 256, kRecordedHeight = 192;  ///< of --export without --size
constexpr unsigned kWidestRtl = 16;  ///< bits of a mantissa whose words the SRAM of board rtl holds

struct Arguments {
  SceneArguments scene;
  ViewChoices choices{.configuration = kDefaultConfiguration};
  ClockFlags clock;
  unsigned port = kViewPort;
  bool no_browser = false;
  std::string exported;
};

FrameOptions options_of(const ViewChoices& choices) {
  return {.width = 1,
          .height = 1,
          .packets = choices.packets,
          .lines = choices.lines,
          .reflections = choices.reflections};
}

/// The configuration's name, or the file of one that is like it but for the chosen numbers.
std::string configuration_of(const ViewChoices& choices) {
  namespace fs = std::filesystem;
  if (!choices.mantissa_bits) return choices.configuration;
  if (is_configuration_file(choices.configuration)) {
    refuse(
        "configuration {}: a file has its own number format; choose a listed configuration to "
        "change it",
        choices.configuration);
  }
  const fs::path folder = fs::temp_directory_path() / fmt::format("dynrt-view-{}", getuid());
  fs::create_directories(folder);
  const fs::path file =
      folder / fmt::format("{}_m{}.json", choices.configuration, *choices.mantissa_bits);
  const nlohmann::ordered_json keys = {
      {"about", fmt::format("{} with another number format", choices.configuration)},
      {"like", choices.configuration},
      {"rtl", *choices.mantissa_bits <= kWidestRtl},
      {"mantissa_bits", *choices.mantissa_bits}};
  write_text(file.string(), hls::json_text(keys));
  return file.string();
}

/// The figures of the last error reports, by configuration, if their pages are there.
nlohmann::ordered_json error_figures() {
  const std::filesystem::path data =
      std::filesystem::path(this_build().scripts).parent_path() / "docs/results/data";
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (const auto& [configuration, file] :
       {std::pair("thesis", "error.json"), std::pair("fast", "error_fast.json")}) {
    std::ifstream text(data / file);
    auto report = nlohmann::ordered_json::parse(text, nullptr, false);
    if (report.is_object()) all[configuration] = std::move(report);
  }
  return all;
}

nlohmann::ordered_json offers() {
  nlohmann::ordered_json listed = nlohmann::ordered_json::array();
  for (const Configuration& configuration : configurations()) {
    const CoreInfo core = configuration.core();
    listed.push_back({{"name", configuration.name},
                      {"about", core.about},
                      {"built_in", configuration.native != nullptr},
                      {"mantissa_bits", core.mantissa_bits},
                      {"packets", core.packets},
                      {"lines", core.lines},
                      {"lights", core.lights},
                      {"reflections", core.reflections}});
  }
  return {{"configurations", listed}, {"errors", error_figures()}};
}

/// The folder of a configuration's schedules: of this build, else those that are checked in; empty
/// if there is neither.
std::string schedules_of(const std::string& configuration) {
  namespace fs = std::filesystem;
  const fs::path build = fs::path(this_build().description).parent_path();
  const fs::path scripts(this_build().scripts);
  for (const fs::path& folder : {build / "generated", scripts.parent_path() / "rtl/generated"}) {
    std::error_code missing;
    if (fs::exists(folder / configuration / "dynrt_core.json", missing)) {
      return (folder / configuration).string();
    }
  }
  return {};
}

/// The folders of configurations' schedules, those made meanwhile among them.
class Schedules {
 public:
  std::string of(const std::string& configuration) {
    const std::lock_guard lock(mutex_);
    const auto made = made_.find(configuration);
    return made == made_.end() ? schedules_of(configuration) : made->second;
  }
  void found(const std::string& configuration, std::string folder) {
    const std::lock_guard lock(mutex_);
    made_[configuration] = std::move(folder);
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::string> made_;
};

SceneArguments scene_of(const Arguments& arguments, const ViewChoices& choices) {
  SceneArguments scene = arguments.scene;
  scene.lights.clear();
  scene.mirrors.clear();
  std::ranges::transform(choices.lights, std::back_inserter(scene.lights), parse_light);
  std::ranges::transform(choices.mirrors, std::back_inserter(scene.mirrors), parse_mirror);
  return scene;
}

ViewServices services_of(const Arguments& arguments) {
  ViewServices services;
  services.scene = arguments.scene.scene;
  services.choices = arguments.choices;
  const auto given = [&](const char* flag) {
    const auto found = arguments.scene.given.find(flag);
    return found == arguments.scene.given.end() ? std::vector<std::string>() : found->second;
  };
  services.choices.lights = given("--light");
  services.choices.mirrors = given("--mirror");
  const FrameOptions options = arguments.scene.frame_options();
  services.width = options.width;
  services.height = options.height;
  services.camera = arguments.scene.camera;
  // Configurations that are loaded are kept in a table that one thread at a time may use.
  const auto loading = std::make_shared<std::mutex>();
  const auto schedules = std::make_shared<Schedules>();
  services.board = [loading, schedules](ViewBoard kind, const ViewChoices& choices) {
    const std::lock_guard lock(*loading);
    const std::string name = configuration_of(choices);
    return open_board({kind == ViewBoard::kRtl ? "rtl" : "model", name, "",
                       kind == ViewBoard::kClocked ? schedules->of(name) : std::string()},
                      options_of(choices));
  };
  services.schedules = [schedules](const ViewChoices& choices) {
    return schedules->of(configuration_of(choices));
  };
  services.lower = [schedules](const ViewChoices& choices, const auto& tell) {
    const std::string name = configuration_of(choices);
    schedules->found(name, make_schedules(name, tell));
  };
  services.make = [](const ViewChoices& choices, const auto& tell) {
    make_ready(configurations(), configuration_of(choices), tell);
  };
  services.offers = offers();
  services.prepare = [&arguments](const ViewChoices& choices, const CoreInfo& core) -> MemoryImage {
    return prepare(scene_of(arguments, choices), &core, kept_trees());
  };
  services.clock = [&](const CoreInfo& core) { return arguments.clock.clock_of(core).json(); };
  return services;
}

int record(const Arguments& arguments) {
  const Output outputs[] = {{"--export", arguments.exported}};
  check_outputs(outputs);
  const Progress progress("recording a frame");
  const std::string page = recorded_view(services_of(arguments));
  write_text(arguments.exported, page);
  say(fmt::format("page        {}, {:.1f} MB\n", arguments.exported,
                  static_cast<double>(page.size()) / 1e6));
  return kDone;
}

int run(const Arguments& arguments) {
  if (arguments.port == 0 || arguments.port > kLastPort) {
    refuse("--port {}: a port is a number from 1 to {}", arguments.port, kLastPort);
  }
  arguments.clock.check();
  if (!arguments.exported.empty()) return record(arguments);
  view(services_of(arguments), {arguments.port, !arguments.no_browser, say});
  // Not by returning: that would wait for a frame that is being rendered.
  std::fflush(nullptr);
  std::_Exit(kDone);
}

}  // namespace

Command add_view_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "view", "walk through a scene in the browser and look inside the core that draws it");
  arguments->scene.add_to(*command, true);
  add_configuration_flag(*command, arguments->choices.configuration);
  const auto count = [&](const char* name, std::optional<unsigned>& value, const char* about) {
    command->add_option(name, value, about)->option_text("N")->check(not_a_count);
  };
  count("--packets", arguments->choices.packets,
        "packets of rays in flight; default: all that the configuration has");
  count("--lines", arguments->choices.lines,
        "lines of each cache, a power of two; default: all that the configuration has");
  count("--reflections", arguments->choices.reflections,
        "largest number of bounces of a ray; default: all that the configuration has");
  arguments->clock.add_to(*command);
  command
      ->add_option("--port", arguments->port,
                   "port of the page, for browsers on this computer only; if it is in use, the "
                   "next free one")
      ->option_text(fmt::format("N [{}]", kViewPort))
      ->check(not_a_count);
  command
      ->add_option("--export", arguments->exported,
                   "write one file of at most 20 MB that opens from disk and has the page with one "
                   "recorded frame, and end; the default size is then 256x192")
      ->option_text("FILE.html");
  command->add_flag("--no-browser", arguments->no_browser,
                    "print the page's address and open no browser");
  return {command, [arguments] {
            if (!arguments->exported.empty() && !arguments->scene.given.contains("--size")) {
              arguments->scene.width = kRecordedWidth;
              arguments->scene.height = kRecordedHeight;
            }
            return run(*arguments);
          }};
}

}  // namespace dynrt::host
