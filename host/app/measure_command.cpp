// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt measure: one frame of the native model beside the truth, as data and as pictures. What
// `dynrt report error` does for every scene and variant.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "host/app/arguments.h"
#include "host/app/board_frame.h"
#include "host/app/command.h"
#include "host/app/messages.h"
#include "host/app/text.h"
#include "host/error.h"
#include "host/render/output_file.h"
#include "host/render/write_image.h"

namespace dynrt::host {

namespace {

struct Arguments {
  SceneArguments scene;
  std::string configuration = "thesis";
  std::string out;
  std::string json;
};

nlohmann::ordered_json counters_json(const Frame& frame) {
  nlohmann::ordered_json counters;
  for (const Counter& counter : frame.counters) counters[counter.name] = counter.value;
  return counters;
}

int run(const Arguments& arguments) {
  FrameOptions options;
  std::tie(options.width, options.height) = parse_size(arguments.scene.size);
  check_size(options.width, options.height);
  const std::string image = (std::filesystem::path(arguments.out) / "image.png").string();
  const Output outputs[] = {{"--out", image}, {"--json", arguments.json}};
  check_outputs(outputs);
  const auto board = open_board({"model", arguments.configuration, ""}, options);
  const Prepared prepared = prepare(arguments.scene, options.width, options.height, &board->info());
  const Frame frame = render_on(*board, options, prepared);

  write_image(image, frame);
  nlohmann::ordered_json json;
  if (frame.run.cycles) json["clocks"] = *frame.run.cycles;
  json["seconds"] = {{"model", frame.run.seconds}};
  json["counters"] = counters_json(frame);
  if (!arguments.json.empty()) write_text(arguments.json, json.dump(2) + "\n");
  say(prepared.text());
  return kDone;
}

}  // namespace

Command add_measure_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("measure", "hold a frame of the native model beside the truth");
  arguments->scene.add_to(*command, true);
  add_configuration_flag(*command, arguments->configuration);
  command
      ->add_option("--out", arguments->out,
                   "folder for the pictures: image.png, truth.png and difference.png")
      ->required()
      ->option_text("FOLDER");
  add_json_flag(*command, arguments->json);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
