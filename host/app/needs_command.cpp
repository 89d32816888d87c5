// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt needs: the value that each key of a configuration must have for a scene, and the reason. It
// builds and renders nothing; `dynrt specialise` uses its result.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "host/app/arguments.h"
#include "host/app/board_frame.h"
#include "host/app/command.h"
#include "host/app/progress.h"
#include "host/app/specialised.h"
#include "host/app/text.h"
#include "host/app/walk.h"
#include "host/picture/output_file.h"
#include "host/scene/animation.h"
#include "host/scene/fingerprint.h"
#include "host/specialise/decide.h"

namespace dynrt::host {

namespace {

struct Arguments {
  SceneArguments scene;
  std::string configuration;
  std::optional<unsigned> reflections, frames;
  SpanArguments span;
  bool uncompressed = false;
  std::string json;
};

/// The needs of one frame, or of all frames of a walk if the scene moves or the flags ask for one,
/// and of the scene at rest, as it is laid out first.
SceneNeeds needs_over_frames(Prepared& prepared, const Arguments& arguments) {
  const SceneNeeds still = prepared.needs();
  const bool moves = duration(prepared.scene) > 0;
  if (!moves && !arguments.frames) return still;
  const WalkPlan plan(prepared.scene, arguments.frames.value_or(kWalkFrames), arguments.span.from,
                      arguments.span.to);
  const auto frames = static_cast<unsigned>(plan.times.size());
  SceneNeeds all = still;
  Progress progress("analysing the frames", frames);
  for (unsigned i = 0; i < frames; ++i) {
    const Tree instances = instances_at(prepared, plan, i);
    all.include(frame_needs(still, prepared.scene, instances));
    progress.update(i + 1);
  }
  all.frames = frames;
  return all;
}

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

int run(const Arguments& arguments) {
  FrameOptions options;
  std::tie(options.width, options.height) = parse_size(arguments.scene.size);
  check_size(options.width, options.height);
  options.reflections = arguments.reflections;
  if (!arguments.json.empty()) check_output_path(arguments.json);
  const std::string general = arguments.configuration.empty()
                                  ? general_configuration(arguments.scene)
                                  : arguments.configuration;
  const auto board = open_board({"model", general, ""}, options);
  Prepared prepared = prepare(arguments.scene, options.width, options.height, &board->core());
  const std::uint64_t content = fingerprint(prepared.scene);
  const SceneNeeds needs = needs_over_frames(prepared, arguments);
  const std::vector<Decision> decisions =
      decide(needs, board->core(),
             {arguments.reflections.value_or(board->core().reflections), arguments.uncompressed});
  if (!arguments.json.empty()) {
    nlohmann::ordered_json json = {{"general", general},
                                   {"content", fmt::format("{:016x}", content)},
                                   {"needs", json_of(needs)},
                                   {"keys", json_of(decisions)}};
    write_text(arguments.json, json.dump(2) + "\n");
  }
  say(prepared.text() + table_of(decisions));
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
      ->add_option("--reflections", arguments->reflections,
                   "largest number of bounces of a ray; default: all that the configuration has")
      ->option_text("N")
      ->check(not_a_count);
  command->add_flag("--uncompressed", arguments->uncompressed,
                    "make a core that can also render with --uncompressed");
  command
      ->add_option("--frames", arguments->frames,
                   fmt::format("number of frames of a walk that the core must render; default: {} "
                               "if the scene moves, else 1",
                               kWalkFrames))
      ->option_text("N")
      ->check(not_a_count);
  arguments->span.add_to(*command);
  add_json_flag(*command, arguments->json);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
