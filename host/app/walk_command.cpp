// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt walk: a scene's animation or a way through it, frame after frame, as pictures or a GIF.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string_view>

#include "hls/json_text.h"
#include "host/app/arguments.h"
#include "host/app/board_frame.h"
#include "host/app/command.h"
#include "host/app/kept_trees.h"
#include "host/app/report.h"
#include "host/app/scene_flags.h"
#include "host/app/specialised.h"
#include "host/app/text.h"
#include "host/app/walk_folder.h"
#include "host/app/walk_report.h"
#include "host/error.h"
#include "host/picture/gif.h"
#include "host/picture/output_file.h"
#include "host/scene/animation.h"
#include "host/scene/check_lights.h"
#include "host/scene/fingerprint.h"
#include "host/ulx3s/board_at_link.h"

namespace dynrt::host {

namespace {

constexpr std::string_view kOtherPictures[] = {".png", ".exr",  ".jpg", ".jpeg",
                                               ".tif", ".tiff", ".bmp", ".webp"};
constexpr double kSlowestGif = 4;  ///< pictures a second: below, it is no motion any more

struct Arguments {
  SceneArguments scene;
  FrameArguments frame;
  SpecialiseFlags specialise;
  std::string board = "rtl";
  std::string schedule;
  bool hits = false;
  unsigned frames = kWalkFrames;
  SpanArguments span;
  bool again = false;

  /// The flags that decide the frames and their figures.
  WalkSettings settings(const Scene& content, const Board& on) const;
};

WalkSettings Arguments::settings(const Scene& content, const Board& on) const {
  const auto text = [](const auto& value) { return value ? fmt::format("{}", *value) : ""; };
  WalkSettings settings = {{"SCENE", scene.scene},
                           {"--frames", fmt::format("{}", frames)},
                           {"--from", text(span.from)},
                           {"--to", text(span.to)}};
  for (const SceneFlag& flag : scene_flags()) {
    settings.emplace_back(flag.name, fmt::format("{}", fmt::join(flag.given(scene), " ")));
  }
  settings.insert(settings.end(),
                  {{"--reflections", text(frame.reflections)},
                   {"--board", board},
                   {"--schedule", schedule},
                   {"--hits", hits ? "yes" : "no"},
                   {"--config", is_at_link(board) ? on.core().name : frame.configuration},
                   {kBoardClock, text(on.clock_hz())},
                   {"--specialise", specialise.specialise ? "yes" : "no"},
                   {"--packets", text(frame.packets)},
                   {"--lines", text(frame.lines)},
                   {"--memory-latency", text(frame.memory.latency)},
                   {"--row-clocks", text(frame.memory.row_clocks)},
                   {"--order", frame.order},
                   {"--uncompressed", frame.uncompressed ? "yes" : "no"},
                   {kSceneContent, fmt::format("{:016x}", fingerprint(content))}});
  return settings;
}

struct Place {
  std::string out;
  bool gif = false;
  std::string folder() const { return gif ? out + ".frames" : out; }
};

bool is_within(const std::string& file, const std::string& folder) {
  namespace fs = std::filesystem;
  const fs::path place = fs::weakly_canonical(fs::absolute(file));
  const fs::path own = fs::weakly_canonical(fs::absolute(folder));
  return place == own || place.parent_path() == own;
}

Place place_of(const Arguments& arguments) {
  namespace fs = std::filesystem;
  Place place{arguments.frame.out};
  if (place.out.empty()) place.out = fs::path(arguments.scene.scene).stem().string() + ".gif";
  std::string extension = fs::path(place.out).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::ranges::count(kOtherPictures, extension) != 0) {
    refuse("--out {}: a walk is written to a folder, as PNG files, or to a .gif file", place.out);
  }
  place.gif = extension == ".gif";
  check_walk_folder(place.folder());
  const std::string& json = arguments.frame.json;
  const Output outputs[] = {{"--out", place.gif ? place.out : ""}, {"--json", json}};
  check_outputs(outputs);
  if (!json.empty() && is_within(json, place.folder())) {
    refuse(
        "--json {}: this file lies in the folder where the walk keeps its frames, {}; name a file "
        "in another folder",
        json, place.folder());
  }
  return place;
}

/// A light stands still; a moving object must not enclose it in any frame.
void check_moving_lights(const Prepared& prepared, const WalkPlan& plan, const CoreInfo& board) {
  Scene scene = prepared.scene;
  for (const double time : plan.times) {
    move_to(scene, time);
    try {
      check_lights(scene, prepared.view.camera.position, core_numbers(board, prepared.space));
    } catch (const UserError& error) {
      refuse("{} (after {} seconds)", error.what(), time);
    }
  }
}

/// Renders the frames that their core was not made for, if it is allowed to.
class GeneralWalk {
 public:
  GeneralWalk(const Arguments& arguments, SceneFile& scene, const FrameOptions& options,
              const ChosenCore& core, const WalkPlan& plan)
      : arguments_(arguments), scene_(scene), options_(options), core_(core), plan_(plan) {}

  Walker::Result render_frame(unsigned frame, const PixelProgress& progress) {
    if (!walker_) {
      on_ = on_board({arguments_.board, core_.general, "", arguments_.schedule}, options_, scene_,
                     kept_trees());
      walker_.emplace(*on_->board, options_, on_->prepared, arguments_.scene.camera, plan_);
    }
    Walker::Result result = walker_->render_frame(frame, progress);
    result.record.general = true;
    return result;
  }

 private:
  const Arguments& arguments_;
  SceneFile& scene_;
  const FrameOptions& options_;
  const ChosenCore& core_;
  const WalkPlan& plan_;
  std::optional<OnBoard> on_;
  std::optional<Walker> walker_;
};

int run(const Arguments& arguments) {
  FrameOptions options = arguments.frame.options(arguments.scene);
  options.hits = arguments.hits;
  arguments.frame.check_timeout(arguments.board);
  const Place place = place_of(arguments);
  SceneFile scene = arguments.specialise.file(arguments.scene);
  // Every frame of the walk is analysed.
  const ChosenCore core =
      arguments.specialise.choose(scene, arguments.frame, arguments.board,
                                  {.frames = {.frames = arguments.frames, .span = arguments.span}});
  auto [board, prepared] =
      prepare_on(arguments.specialise, core,
                 {.board = arguments.board, .trace = "", .schedule = arguments.schedule}, options,
                 scene, kept_trees());
  const CoreClock clock = arguments.frame.clock.clock_of(board->core(), board->clock_hz());
  WalkFolder folder(place.folder(), arguments.settings(prepared.scene, *board), arguments.again);
  const WalkPlan plan(prepared.scene, arguments.frames, arguments.span.from, arguments.span.to);
  if (!plan.orbit && board->core().lights > 0 && !prepared.scene.lights.empty()) {
    check_moving_lights(prepared, plan, board->core());
  }
  if (plan.orbit)
    prepared.scene.notes.push_back(
        "neither the scene nor its camera moves, so the camera goes once round the scene's centre");
  nlohmann::ordered_json json = {{"out", place.out}, {"scene", prepared.json()}};
  say(prepared.text() + walk_header());

  Walker walker(*board, options, prepared, arguments.scene.camera, plan);
  GeneralWalk general(arguments, scene, options, core, plan);
  std::vector<WalkRecord> records;
  std::vector<std::string> pictures;
  std::vector<nlohmann::ordered_json> figures(arguments.frames);
  unsigned kept = 0;
  for (unsigned i = 0; i < arguments.frames; ++i) {
    pictures.push_back(folder.name(i));
    if (const auto record = folder.kept(i, options.width, options.height)) {
      records.push_back(*record);
      ++kept;
    } else {
      BoardProgress progress(
          *board, fmt::format("frame {} of {} on board {}", i, arguments.frames, board->name()),
          std::uint64_t{options.width} * options.height);
      const PixelProgress show = progress.pixels();
      const Walker::Result result = [&] {
        try {
          return walker.render_frame(i, show);
        } catch (const Exceeded& over) {
          arguments.specialise.refuse_unless_general(over);
          return general.render_frame(i, show);
        }
      }();
      folder.write(result.frame, result.record);
      figures[i] = report_json(result.frame, figures_of(result.frame, clock.hz()), clock);
      records.push_back(result.record);
    }
    say(walk_line(records.back(), clock.hz()));
  }

  if (kept < arguments.frames) folder.save();

  const WalkSummary summary{records, kept, walker.scene_upload(), clock};
  if (!arguments.frame.json.empty()) {
    json["walk"] = summary.json();
    for (unsigned i = 0; i < arguments.frames; ++i) {
      json["walk"]["frames"][i]["figures"] = std::move(figures[i]);
    }
    write_text(arguments.frame.json, hls::json_text(json));
  }
  if (place.gif) {
    const double rate = static_cast<double>(arguments.frames) / plan.seconds;
    write_gif(place.out, pictures, std::max(rate, kSlowestGif));
    folder.remove();
  }
  say(fmt::format("{}images      {}, {}x{}\n", summary.text(), place.out, options.width,
                  options.height));
  return kDone;
}

}  // namespace

Command add_walk_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "walk", "render the frames of a scene's animation, or of a camera's way around the scene");
  arguments->scene.add_to(*command, true);
  command->add_option("--board", arguments->board, board_help())->option_text("BOARD [rtl]");
  command
      ->add_option("--schedule", arguments->schedule,
                   "count the clocks of --board model with the schedules in this folder")
      ->option_text("FOLDER");
  command->add_flag("--hits", arguments->hits, "write hit records too, as render does");
  command
      ->add_option("--frames", arguments->frames,
                   "number of frames, evenly spread over the animation")
      ->option_text(fmt::format("N [{}]", kWalkFrames))
      ->check(not_a_count);
  arguments->span.add_to(*command);
  command->add_flag("--again", arguments->again,
                    "replace frames that are already there instead of keeping them");
  arguments->frame.add_to(*command, "SCENE.gif",
                          "a folder for the frames as PNG files, or a .gif file");
  arguments->specialise.add_to(*command, true);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
