// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt view: a live window on the core in the browser.
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "host/app/app_messages.h"
#include "host/app/arguments.h"
#include "host/app/board_frame.h"
#include "host/app/command.h"
#include "host/app/text.h"
#include "host/view/view.h"

namespace dynrt::host {

namespace {

constexpr unsigned kLastPort = 65535;

struct Arguments {
  SceneArguments scene;
  ViewChoices choices{.configuration = kDefaultConfiguration};
  ClockFlags clock;
  unsigned port = kViewPort;
  bool no_browser = false;
};

FrameOptions options_of(const ViewChoices& choices) {
  return {.width = 1,
          .height = 1,
          .packets = choices.packets,
          .lines = choices.lines,
          .reflections = choices.reflections};
}

SceneArguments scene_of(const Arguments& arguments, const ViewChoices& choices) {
  SceneArguments scene = arguments.scene;
  scene.lights = choices.lights;
  scene.mirrors = choices.mirrors;
  return scene;
}

ViewStudio studio_of(const Arguments& arguments) {
  ViewStudio studio;
  studio.scene = arguments.scene.scene;
  studio.choices = arguments.choices;
  studio.choices.lights = arguments.scene.lights;
  studio.choices.mirrors = arguments.scene.mirrors;
  std::tie(studio.width, studio.height) = parse_size(arguments.scene.size);
  check_size(studio.width, studio.height);
  studio.camera = arguments.scene.camera();
  studio.board = [&](const std::string& kind, const ViewChoices& choices) {
    return open_board({kind, choices.configuration, ""}, options_of(choices));
  };
  studio.prepare = [&arguments, width = studio.width, height = studio.height](
                       const ViewChoices& choices, const CoreInfo& core) -> MemoryImage {
    return prepare(scene_of(arguments, choices), width, height, &core);
  };
  studio.clock = [&](const CoreInfo& core) { return arguments.clock.clock_of(core).json(); };
  return studio;
}

int run(const Arguments& arguments) {
  if (arguments.port == 0 || arguments.port > kLastPort) {
    refuse(messages::kViewPort, arguments.port, kLastPort);
  }
  arguments.clock.check();
  view(studio_of(arguments), {arguments.port, !arguments.no_browser, say});
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
                   "port of this computer at which the page is served, to its own browsers alone; "
                   "if it is in use, the next that is free")
      ->option_text(fmt::format("N [{}]", kViewPort))
      ->check(not_a_count);
  command->add_flag("--no-browser", arguments->no_browser,
                    "print the page's address and open no browser");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
