// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/scene_analysis.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/board_frame.h"
#include "host/app/progress.h"
#include "host/app/text.h"
#include "host/app/walk.h"
#include "host/memory/matrix_numbers.h"
#include "host/scene/animation.h"
#include "host/scene/fingerprint.h"

namespace dynrt::host {

namespace {

/// Of one frame, or of all the frames of the walk that moves the scene or is asked for, and of the
/// scene as it is before it moves: so it is laid out first.
SceneNeeds needs_over_frames(Prepared& prepared, const AnalysedFrames& asked) {
  const SceneNeeds still = prepared.needs();
  const bool moves = duration(prepared.scene) > 0;
  if (!moves && !asked.frames) return still;
  const WalkPlan plan(prepared.scene, asked.frames.value_or(kWalkFrames), asked.span.from,
                      asked.span.to);
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

}  // namespace

void AnalysedFrames::add_to(CLI::App& command) {
  command
      .add_option("--reflections", reflections,
                  "largest number of bounces of a ray; default: all that the configuration has")
      ->option_text("N")
      ->check(not_a_count);
  command.add_flag("--uncompressed", uncompressed,
                   "make a core that can also render with --uncompressed");
  command
      .add_option("--frames", frames,
                  fmt::format("number of frames of a walk that the core must render; default: {} "
                              "if the scene moves, else 1",
                              kWalkFrames))
      ->option_text("N")
      ->check(not_a_count);
  span.add_to(command);
  memory.add_to(command);
}

std::string general_configuration(SceneFile& file) {
  const SceneArguments& flags = file.arguments();
  const Scene& scene = file.scene();
  if (!flags.lights.empty() || !flags.mirrors.empty() || !scene.lights.empty() ||
      has_mirrors(scene)) {
    return "whitted";
  }
  const bool others = std::ranges::any_of(scene.objects, [](const Mesh& object) {
    return !object.rectangles.empty() || !object.ellipsoids.empty();
  });
  return others ? "primitives" : kDefaultConfiguration;
}

SceneAnalysis analyse(SceneFile& file, const std::string& configuration,
                      const AnalysedFrames& frames) {
  FrameOptions options = file.arguments().frame_options();
  options.reflections = frames.reflections;
  frames.memory.put_into(options);
  SceneAnalysis analysis;
  analysis.general = configuration.empty() ? general_configuration(file) : configuration;
  const auto board = open_board({"model", analysis.general, ""}, options);
  const CoreInfo& core = board->core();
  Prepared prepared = prepare(file, &core);
  analysis.content = fingerprint(prepared.scene);
  analysis.needs = needs_over_frames(prepared, frames);
  analysis.decisions = decide(analysis.needs, core,
                              {frames.reflections.value_or(core.reflections), frames.uncompressed});
  analysis.text = prepared.text();
  return analysis;
}

nlohmann::ordered_json SceneAnalysis::json() const {
  return {{"general", general},
          {"content", fmt::format("{:016x}", content)},
          {"needs", json_of(needs)},
          {"keys", json_of(decisions)}};
}

std::string SceneAnalysis::about() const {
  constexpr std::string_view kTitle = "scene";
  const std::string line = text.substr(0, text.find('\n'));
  return line.substr(line.find_first_not_of(' ', kTitle.size()));
}

}  // namespace dynrt::host
