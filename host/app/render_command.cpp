// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt render: one board, one image.
#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "hls/json_text.h"
#include "host/app/arguments.h"
#include "host/app/board_frame.h"
#include "host/app/command.h"
#include "host/app/report.h"
#include "host/app/specialised.h"
#include "host/app/text.h"
#include "host/error.h"
#include "host/picture/output_file.h"
#include "host/picture/write_image.h"
#include "host/render/hit_json.h"
#include "host/ulx3s/board_at_link.h"

namespace dynrt::host {

namespace {

struct Pixel {
  unsigned x = 0, y = 0;
};

struct Arguments {
  SceneArguments scene;
  FrameArguments frame;
  SpecialiseFlags specialise;
  std::string board = "rtl";
  std::string schedule;
  std::string trace;
  std::string scan_out;
  std::string pixel;
  bool no_hits = false;

  std::optional<Pixel> pixel_in(const FrameOptions& options) const;
};

/// Throws UserError for a pixel that the image has not, or without hit records or a file for it.
std::optional<Pixel> Arguments::pixel_in(const FrameOptions& options) const {
  if (pixel.empty()) return std::nullopt;
  if (frame.json.empty() || no_hits) {
    refuse(
        "--pixel {}: its hit record goes to the file of --json; name one and leave --no-hits out",
        pixel);
  }
  std::array<unsigned, 2> at{};
  if (!parse_list(pixel, ',', at) || at[0] >= options.width || at[1] >= options.height) {
    refuse("--pixel {}: write the numbers of a pixel of this image, from 0,0 to {},{}", pixel,
           options.width - 1, options.height - 1);
  }
  return Pixel{at[0], at[1]};
}

/// The waveforms of a frame, which an error removes. Those of a frame that never ended, or in which
/// an assertion failed, are kept: they show why. Without --trace it does nothing.
class TraceFile {
 public:
  explicit TraceFile(const std::string& path) {
    if (path.empty()) return;
    waves_.emplace(path);
    hierarchy_.emplace(path + ".hier");
  }

  Frame render(Board& board, const FrameOptions& options, const MemoryImage& image) {
    try {
      Frame frame = render_on(board, options, image);
      keep();
      return frame;
    } catch (const TimeoutError&) {
      keep();
      throw;
    } catch (const std::logic_error&) {
      keep();
      throw;
    }
  }

 private:
  void keep() {
    if (waves_) waves_->keep();
  }

  std::optional<UnfinishedFile> waves_;
  std::optional<UnfinishedFile> hierarchy_;  ///< temporary file until the waveforms are complete
};

int run(const Arguments& arguments) {
  FrameOptions options = arguments.frame.options(arguments.scene);
  options.hits = !arguments.no_hits;
  arguments.frame.check_timeout(arguments.board);
  const std::optional<Pixel> pixel = arguments.pixel_in(options);
  const std::string out = image_name(arguments.frame.out, arguments.scene.scene);
  const bool shows = !arguments.scan_out.empty();
  if (shows && is_at_link(arguments.board)) {
    refuse(
        "board {} has a display of its own, which --scan-out does not read; leave out --scan-out, "
        "or take board rtl",
        arguments.board);
  }
  const Output outputs[] = {{"--out", out, true},
                            {"--json", arguments.frame.json},
                            {"--trace", arguments.trace},
                            {"--scan-out", arguments.scan_out, true}};
  check_outputs(outputs);
  TraceFile trace(arguments.trace);
  SpecialiseWishes wishes;
  if (shows) wishes.keep.emplace_back("scan_out");
  SceneFile scene = arguments.specialise.file(arguments.scene);
  const ChosenCore core =
      arguments.specialise.choose(scene, arguments.frame, arguments.board, wishes);
  auto [board, prepared] = prepare_on(arguments.specialise, core,
                                      {.board = arguments.board,
                                       .trace = arguments.trace,
                                       .schedule = arguments.schedule,
                                       .shows = shows},
                                      options, scene);
  const Frame frame = trace.render(*board, options, prepared);

  if (options.hits && frame.hit_count() == 0) prepared.note_no_hit();
  write_image(out, frame);
  const CoreClock clock = arguments.frame.clock.clock_of(frame.core, frame.clock_hz);
  std::optional<Shown> shown;
  if (shows) shown = show(*board, frame, clock.mhz, arguments.scan_out);
  const FrameFigures figures = figures_of(frame, clock.hz());
  if (!arguments.frame.json.empty()) {
    nlohmann::ordered_json json = {{"image", out}, {"scene", prepared.json()}};
    json["frame"] = report_json(frame, figures, clock);
    if (pixel) json["pixel"] = hit_json(frame, pixel->x, pixel->y);
    if (shown) json["scan_out"] = shown->json();
    write_text(arguments.frame.json, hls::json_text(json));
  }
  say(fmt::format("image       {}, {}x{}\n{}{}{}", out, frame.width, frame.height, prepared.text(),
                  report_text(frame, figures, clock), shown ? shown->text() : ""));
  return kDone;
}

}  // namespace

Command add_render_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("render", "render a scene and write the image");
  arguments->scene.add_to(*command, true);
  command->add_option("--board", arguments->board, board_help())->option_text("BOARD [rtl]");
  command
      ->add_option("--schedule", arguments->schedule,
                   "count the clocks of --board model with the schedules in this folder, which "
                   "also holds the configuration's Verilog, such as build/release/generated/fast")
      ->option_text("FOLDER");
  command
      ->add_option("--trace", arguments->trace,
                   "write the waveforms of the Verilog and check its assertions; the file is "
                   "large, so choose a small --size")
      ->option_text("FILE.fst");
  command
      ->add_option("--scan-out", arguments->scan_out,
                   "write the VGA display of 640x480 that shows the image, as a monitor at the "
                   "Verilog's pins would show it")
      ->option_text("FILE.png");
  command
      ->add_option("--pixel", arguments->pixel,
                   "write the hit record of this pixel, counted from the top left, with --json")
      ->option_text("X,Y");
  command->add_flag("--no-hits", arguments->no_hits,
                    "write only pixels and no hit records, as the thesis's core does; the banks "
                    "cannot take the records of a core that completes many rays a clock as fast");
  arguments->frame.add_to(*command, "SCENE.png");
  arguments->specialise.add_to(*command, true);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
