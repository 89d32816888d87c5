// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt measure: compares one frame of the native model with the truth, as data and as pictures.
// `dynrt report error` does this for every scene and variant.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "hls/json_text.h"
#include "host/analysis/truth/measures.h"
#include "host/app/arguments.h"
#include "host/app/board_frame.h"
#include "host/app/command.h"
#include "host/app/progress.h"
#include "host/app/text.h"
#include "host/picture/output_file.h"
#include "host/picture/write_image.h"

namespace dynrt::host {

namespace {

struct Arguments {
  SceneArguments scene;
  std::string configuration = kDefaultConfiguration;
  std::string schedule;
  std::optional<unsigned> reflections;
  std::string out;
  std::string json;
};

nlohmann::ordered_json counters_json(const Frame& frame) {
  nlohmann::ordered_json counters;
  for (const Counter& counter : frame.counters) counters[counter.name] = counter.value;
  return counters;
}

struct Expected {
  TruthFrame truth;
  nlohmann::ordered_json measures;
};

Expected expected_of(const Frame& frame, const FrameOptions& options, const Prepared& prepared) {
  const Progress progress("computing the exact results");
  const Truth truth(prepared.scene);
  const FrameConfig config = frame_config(frame.core, options, prepared.frame);
  Expected expected{truth_of_frame(truth, prepared.view.camera, shading_of(frame.core, config)),
                    {}};
  const MatrixOwners owners(prepared.scene, prepared.objects, prepared.frame);
  expected.measures = measure(truth, expected.truth, frame, owners, frame.core.format->number);
  return expected;
}

void write_picture(const std::string& path, const Frame& like, std::vector<std::uint32_t> pixels) {
  Frame picture;
  picture.width = like.width;
  picture.height = like.height;
  picture.pixels = std::move(pixels);
  write_image(path, picture);
}

std::string text_of(const nlohmann::ordered_json& measures) {
  std::string text;
  for (const auto& [kind, figures] : measures.items()) {
    for (const auto& [name, figure] : figures.items()) {
      text += fmt::format("  {:<28}{:>14}\n", kind + "." + name,
                          figure.is_null() ? "-" : fmt::format("{:.6g}", figure.get<double>()));
    }
  }
  return text;
}

int run(const Arguments& arguments) {
  FrameOptions options = arguments.scene.frame_options();
  options.reflections = arguments.reflections;
  const auto path = [&](const char* name) {
    return arguments.out.empty() ? "" : (std::filesystem::path(arguments.out) / name).string();
  };
  const Output outputs[] = {{"--out", path("image.png")}, {"--json", arguments.json}};
  check_outputs(outputs);
  const auto board =
      open_board({"model", arguments.configuration, "", arguments.schedule}, options);
  const Prepared prepared = prepare(arguments.scene, &board->core());
  const Frame frame = render_on(*board, options, prepared);
  const Expected expected = expected_of(frame, options, prepared);

  if (!arguments.out.empty()) {
    write_image(path("image.png"), frame);
    write_picture(path("truth.png"), frame, expected.truth.pixels);
    write_picture(path("difference.png"), frame,
                  difference_picture(expected.truth.pixels, frame.pixels));
  }
  if (!arguments.json.empty()) {
    nlohmann::ordered_json json;
    if (frame.run.cycles) json["clocks"] = *frame.run.cycles;
    json["seconds"] = {{"model", frame.run.seconds}, {"truth", expected.truth.seconds}};
    json["counters"] = counters_json(frame);
    json["measures"] = expected.measures;
    write_text(arguments.json, hls::json_text(json));
  }
  say(fmt::format("{}model       {:.2f} s\ntruth       {:.2f} s\n{}", prepared.text(),
                  frame.run.seconds, expected.truth.seconds, text_of(expected.measures)));
  return kDone;
}

}  // namespace

Command add_measure_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("measure", "compare a frame of the native model with exact results");
  arguments->scene.add_to(*command, true);
  add_configuration_flag(*command, arguments->configuration);
  command
      ->add_option("--schedule", arguments->schedule,
                   "count clocks with the schedules in this folder, which scripts/configuration "
                   "--verilog writes")
      ->option_text("FOLDER");
  command
      ->add_option("--reflections", arguments->reflections,
                   "largest number of bounces of a ray; default: all that the configuration has")
      ->option_text("N")
      ->check(not_a_count);
  command
      ->add_option("--out", arguments->out,
                   "folder for the pictures image.png, truth.png and difference.png (16 times the "
                   "difference)")
      ->option_text("FOLDER");
  add_json_flag(*command, arguments->json);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
