// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt compare: the same frame on both boards, equal to the last bit or not.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "hls/json_text.h"
#include "host/app/arguments.h"
#include "host/app/board_frame.h"
#include "host/app/command.h"
#include "host/app/report.h"
#include "host/app/specialised.h"
#include "host/app/text.h"
#include "host/picture/output_file.h"
#include "host/picture/write_image.h"

namespace dynrt::host {

namespace {

struct Arguments {
  SceneArguments scene;
  FrameArguments frame;
  SpecialiseFlags specialise;
  std::string board = "rtl";
};

int run(const Arguments& arguments) {
  const FrameOptions options = arguments.frame.options(arguments.scene);
  const std::string& out = arguments.frame.out;
  const Output outputs[] = {{"--out", out, true}, {"--json", arguments.frame.json}};
  check_outputs(outputs);
  const bool special = arguments.specialise.specialise;
  SceneFile scene = arguments.specialise.file(arguments.scene);
  const ChosenCore core = arguments.specialise.choose(scene, arguments.frame, arguments.board);
  const auto [board, prepared] =
      on_board({arguments.board, core.configuration, ""}, options, scene);
  const std::string same = core.configuration.empty() ? board->core().name : core.configuration;
  // Unknown configurations and the like come before the work.
  const auto model_board = open_board({"model", special ? core.general : same, ""}, options);
  const Frame rtl = render_on(*board, options, prepared);
  const auto of_model =
      special ? std::optional(prepare(scene, &model_board->core())) : std::nullopt;
  const Frame model = render_on(*model_board, options, of_model ? *of_model : prepared);
  const Comparison comparison = compare(rtl, model);

  if (!out.empty()) write_image(out, rtl);
  const CoreClock clock = arguments.frame.clock.clock_of(rtl.core, rtl.clock_hz);
  const FrameFigures rtl_figures = figures_of(rtl, clock.hz());
  const FrameFigures model_figures = figures_of(model, clock.hz());
  if (!arguments.frame.json.empty()) {
    nlohmann::ordered_json json = {{"image", out}, {"scene", prepared.json()}};
    json["rtl"] = report_json(rtl, rtl_figures, clock);
    json["model"] = report_json(model, model_figures, clock);
    json["comparison"] = comparison_json(comparison);
    write_text(arguments.frame.json, hls::json_text(json));
  }
  const std::string image =
      out.empty() ? "" : fmt::format("image       {}, {}x{}\n", out, rtl.width, rtl.height);
  say(fmt::format("{}{}{}model       {:.2f} s, {:.0f} rays per second\n{}", image, prepared.text(),
                  report_text(rtl, rtl_figures, clock), model.run.seconds,
                  model_figures.rays_per_second, comparison_text(comparison, rtl.board, "model")));
  return comparison.identical() ? kDone : kDifferent;
}

}  // namespace

Command add_compare_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "compare",
      "render on the hardware and on the model and compare every hit record, pixel and counter; "
      "with --specialise, "
      "compare the Verilog made for the scene with the model of the general core");
  arguments->scene.add_to(*command, true);
  arguments->frame.add_to(*command, "none");
  arguments->specialise.add_to(*command, false);
  command->add_option("--board", arguments->board, hardware_help())->option_text("BOARD [rtl]");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
