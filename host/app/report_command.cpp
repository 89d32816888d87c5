// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt report: studies of a scene, one subcommand each. Experiments render with many cores; the
// others count in software and open no board.
#include <fmt/format.h>

#include <memory>

#include "hls/json_text.h"
#include "host/app/arguments.h"
#include "host/app/command.h"
#include "host/app/script_command.h"
#include "host/app/text.h"
#include "host/app/truth_report.h"
#include "host/app/work_report.h"
#include "host/error.h"
#include "host/picture/output_file.h"

namespace dynrt::host {

namespace {

constexpr unsigned kMaxCountedSide = 4096;

struct Arguments {
  SceneArguments scene;
  std::string json;
};

using Study = WorkReport (*)(const Prepared& prepared);

int run(const Arguments& arguments, Study study) {
  if (study == truth_report) require_truth();
  const auto [width, height] = std::pair(arguments.scene.width, arguments.scene.height);
  for (const unsigned side : {width, height}) {
    if (side == 0 || side % 2 != 0 || side > kMaxCountedSide) {
      refuse(
          "--size {}x{}: dynrt counts work for packets of 2x2 rays, so both numbers must be even, "
          "above 0 and at most {}",
          width, height, kMaxCountedSide);
    }
  }
  if (!arguments.json.empty()) check_output_path(arguments.json);
  const WorkReport report = study(prepare(arguments.scene));
  if (!arguments.json.empty()) write_text(arguments.json, hls::json_text(report.json));
  say(report.text);
  return kDone;
}

struct Subcommand {
  const char* name;
  const char* about;
  Study study;
};

constexpr Subcommand kSubcommands[] = {
    {"overlap", "objects that overlap: none, hierarchical tree, mailbox, multiple scenes (4.3)",
     overlap_report},
    {"mailbox", "the work that 0 to 32 slots of the mailbox save (4.3.2)", mailbox_report},
    {"clipping", "the work that the clipping nodes of the scene and of objects save (4.2)",
     clipping_report},
    {"truth",
     "the primitive that each ray hits, by exact decisions, and where Embree finds another one",
     truth_report}};

/// The experiments of scripts/dynrt_tools/experiments/table.
struct Experiment {
  const char* name;
  const char* about;
};

constexpr Experiment kExperiments[] = {
    {"error", "error, time and area of other number formats and variants"},
    {"hardware",
     "the thesis's figures over packets, lines, bandwidth and pipelines, and its indices of "
     "quality"},
    {"scenes", "the thesis's four kinds of scene, beside its frame rates"},
    {"memory", "a memory behind the port: latency, caches and pipelines"},
    {"board", "a board whose memory is an SDRAM, beside banks of SRAM"},
    {"board_caches", "which change to the caches lets that board render more"},
    {"ideas", "what configurations bring that differ in one key"}};

}  // namespace

Command add_choose_command(CLI::App& program) {
  const ScriptCommand choose = add_script_command(
      program, "choose", "find the cheapest variant that keeps an error below a bound", "choose");
  return {choose.app, choose.run};
}

Command add_report_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("report", "count the work of other variants of the core");
  const auto chosen = std::make_shared<std::function<int()>>();
  for (const Subcommand& subcommand : kSubcommands) {
    const auto arguments = std::make_shared<Arguments>();
    arguments->scene.scene = "conference";
    arguments->scene.width = 1024;
    arguments->scene.height = 768;
    CLI::App* const app = command->add_subcommand(subcommand.name, subcommand.about);
    arguments->scene.add_to(*app, false);
    app->get_option("--size")
        ->description(
            fmt::format("rays of the image: two even numbers, at most {} a side", kMaxCountedSide))
        ->option_text("WxH [1024x768]");
    app->get_option("SCENE")->option_text("[conference]");
    add_json_flag(*app, arguments->json);
    app->callback([chosen, arguments, study = subcommand.study] {
      *chosen = [arguments, study] { return run(*arguments, study); };
    });
  }
  for (const Experiment& one : kExperiments) {
    const ScriptCommand experiment =
        add_script_command(*command, one.name, one.about, "experiment", one.name);
    experiment.app->callback([chosen, experiment] { *chosen = experiment.run; });
  }
  return {command, [chosen] {
            if (!*chosen) {
              refuse(
                  "report: name a report; the reports are overlap, mailbox, clipping, error, "
                  "hardware and truth");
            }
            return (*chosen)();
          }};
}

}  // namespace dynrt::host
