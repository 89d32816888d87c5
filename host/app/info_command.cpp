// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt info: a scene, its trees and the memory they take; nothing is rendered.
#include <memory>

#include "host/app/arguments.h"
#include "host/app/command.h"
#include "host/app/prepare.h"
#include "host/app/text.h"
#include "host/picture/output_file.h"
#include "host/render/render.h"

namespace dynrt::host {

namespace {

struct Arguments {
  SceneArguments scene;
  std::string json;
};

int run(const Arguments& arguments) {
  const auto [width, height] = parse_size(arguments.scene.size);
  check_size(width, height);
  if (!arguments.json.empty()) check_output_path(arguments.json);
  const Prepared prepared = prepare(arguments.scene, width, height);
  if (!arguments.json.empty()) write_text(arguments.json, prepared.json().dump(2) + "\n");
  say(prepared.text());
  return kDone;
}

}  // namespace

Command add_info_command(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("info", "show the contents of a scene, its trees and its memory");
  arguments->scene.add_to(*command, true);
  add_json_flag(*command, arguments->json);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace dynrt::host
