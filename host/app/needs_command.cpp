// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt needs: the value that each key of a configuration must have for a scene, and the reason. It
// builds and renders nothing; `dynrt specialise` uses its result and asks it for more (analyst.h).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "hls/json_text.h"
#include "host/app/analyst.h"
#include "host/app/command.h"
#include "host/app/scene_flags.h"
#include "host/app/text.h"
#include "host/picture/output_file.h"

namespace dynrt::host {

namespace {

struct Arguments {
  SceneArguments scene;
  std::string configuration;
  AnalysedFrames frames;
  std::string json;
  bool answer = false;
};

std::string value_of(const Decision& decision) {
  if (decision.value.is_string()) return decision.value.get<std::string>();
  if (decision.value.is_boolean()) return decision.value.get<bool>() ? "yes" : "no";
  if (!decision.value.is_array()) return decision.value.dump();
  return fmt::format("{}", fmt::join(decision.value.get<std::vector<std::string>>(), ", "));
}

/// Key, value and reason, under one another.
std::string table_of(const std::vector<Decision>& decisions) {
  std::size_t widest = 0;
  for (const Decision& decision : decisions) widest = std::max(widest, value_of(decision).size());
  std::string text = fmt::format("  {:<18}{:<{}}because\n", "key", "needs", widest + 2);
  for (const Decision& decision : decisions) {
    text += fmt::format("  {:<18}{:<{}}{}\n", decision.key, value_of(decision), widest + 2,
                        decision.reason);
  }
  return text;
}

/// Questions on standard input, answers on standard output, until there are no more.
int answer(const Arguments& arguments) {
  SceneFile file(arguments.scene, true);
  Analyst analyst(file, arguments.frames);
  for (std::string question; std::getline(std::cin, question);) {
    say(analyst.answer(question) + "\n");
  }
  return kDone;
}

int run(const Arguments& arguments) {
  if (arguments.answer) return answer(arguments);
  if (!arguments.json.empty()) check_output_path(arguments.json);
  SceneFile file(arguments.scene);
  const SceneAnalysis analysis = analyse(file, arguments.configuration, arguments.frames);
  if (!arguments.json.empty()) write_text(arguments.json, hls::json_text(analysis.json()));
  say(analysis.text + table_of(analysis.decisions));
  return kDone;
}

}  // namespace

Command add_needs_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "needs",
      "show the value that each key of a configuration must have for a scene, and the reason");
  arguments->scene.add_to(*command, true);
  add_configuration_flag(*command, arguments->configuration);
  command
      ->add_option("--reflections", arguments->frames.reflections,
                   "largest number of bounces of a ray; default: all that the configuration has")
      ->option_text("N")
      ->check(not_a_count);
  command->add_flag("--uncompressed", arguments->frames.uncompressed,
                    "make a core that can also render with --uncompressed");
  command
      ->add_option("--frames", arguments->frames.frames,
                   fmt::format("number of frames of a walk that the core must render; default: {} "
                               "if the scene moves, else 1",
                               kWalkFrames))
      ->option_text("N")
      ->check(not_a_count);
  arguments->frames.span.add_to(*command);
  arguments->frames.memory.add_to(*command);
  add_json_flag(*command, arguments->json);
  const auto list = [command] { throw CLI::CallForVersion(listed_flags(*command), 0); };
  command->add_flag_callback("--list-flags", list, "list the flags for scripts/specialise")
      ->group("");  // before a scene is asked for, as --help
  command->add_flag("--answer", arguments->answer, "answer the questions of scripts/specialise")
      ->group("");  // of no list of flags: for the script alone
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
