// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <sstream>
#include <vector>

#include "host/app/command.h"
#include "host/app/text.h"
#include "host/error.h"
#include "host/render/frame_refused.h"

namespace dynrt::host {

namespace {

constexpr char kAbout[] =
    "Renders scenes on dynrt, a ray tracing core for dynamic scenes. Its units are written in C++, "
    "and\nhlsc lowers them to Verilog. --board rtl runs the Verilog on an emulated PCI board; "
    "--board\nmodel runs the same C++ as a native program. Both give the same bits.";
constexpr char kFooter[] =
    "Exit codes: 0 success; 1 compare found a difference, or a stress case exceeds its bound; 2 a "
    "mistake in the input or the flags; 3 a defect of dynrt.\nExample: dynrt render office --size "
    "256x192 --out office.png";

int complain(const std::string& sentence, int code) {
  fmt::print(stderr, "dynrt: {}\n", sentence);
  return code;
}

/// CLI11's own sentences end with or without a full stop and may have several lines.
std::string one_sentence(std::string text) {
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

/// Names the flag that gave the option. A command without the flag, such as stress, chose it
/// itself.
std::string with_flag(const FrameRefused& refused, const CLI::App& command) {
  const std::string flag = "--" + refused.option;
  const bool has_flag = command.get_option_no_throw(flag) != nullptr;
  return has_flag ? fmt::format("{}: {}", flag, refused.what()) : refused.what();
}

int run(int argc, char** argv) {
  CLI::App program(kAbout, "dynrt");
  program.footer(kFooter);
  program.set_version_flag("--version", "dynrt " DYNRT_VERSION);
  program.require_subcommand(1);
  const std::vector<Command> commands = {
      add_render_command(program),     add_walk_command(program),   add_compare_command(program),
      add_info_command(program),       add_report_command(program), add_choose_command(program),
      add_measure_command(program),    add_stress_command(program), add_needs_command(program),
      add_specialise_command(program), add_view_command(program)};
  const auto is_first = [&](const Command& c) { return c.app->get_name() == argv[1]; };
  if (argc > 1 && argv[1][0] != '-' && std::ranges::none_of(commands, is_first)) {
    return complain(
        fmt::format("{}: there is no such command; the commands are render, walk, compare, info, "
                    "report, choose, measure, stress, needs, specialise and view",
                    argv[1]),
        kMistake);
  }
  std::string parsed;
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    program.exit(help, text);
    say(text.str());
    return kDone;
  } catch (const CLI::ParseError& error) {
    for (const Command& command : commands) {
      if (command.app->parsed()) parsed = command.app->get_name() + " ";
    }
    return complain(
        fmt::format("{}; dynrt {}--help lists what there is", one_sentence(error.what()), parsed),
        kMistake);
  }
  for (const Command& command : commands) {
    if (!command.app->parsed()) continue;
    try {
      return command.run();
    } catch (const FrameRefused& refused) {
      return complain(with_flag(refused, *command.app), kMistake);
    }
  }
  return kMistake;
}

}  // namespace

}  // namespace dynrt::host

int main(int argc, char** argv) {
  using namespace dynrt::host;
  try {
    return run(argc, argv);
  } catch (const UserError& error) {
    return complain(error.what(), kMistake);
  } catch (const std::exception& error) {
    return complain(fmt::format("defect in dynrt: {}", error.what()), kDefect);
  }
}
