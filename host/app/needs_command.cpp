// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt needs: the value that each key of a configuration must have for a scene, and the reason. It
// builds and renders nothing; `dynrt specialise` begins with the same analysis.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "hls/json_text.h"
#include "host/app/command.h"
#include "host/app/scene_analysis.h"
#include "host/app/text.h"
#include "host/picture/output_file.h"

namespace dynrt::host {

namespace {

struct Arguments {
  SceneArguments scene;
  std::string configuration;
  AnalysedFrames frames;
  std::string json;
};

/// Key, value and reason, under one another.
std::string table_of(const std::vector<Decision>& decisions) {
  std::size_t widest = 0;
  for (const Decision& decision : decisions)
    widest = std::max(widest, words_of(decision.value).size());
  std::string text = fmt::format("  {:<18}{:<{}}because\n", "key", "needs", widest + 2);
  for (const Decision& decision : decisions) {
    text += fmt::format("  {:<18}{:<{}}{}\n", decision.key, words_of(decision.value), widest + 2,
                        decision.reason);
  }
  return text;
}

int run(const Arguments& arguments) {
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
  arguments->frames.add_to(*command);
  add_json_flag(*command, arguments->json);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
