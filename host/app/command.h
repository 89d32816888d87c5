// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A command of the program: its flags and its work. One file per command.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace dynrt::host {

/// Exit codes, as cmp and diff have them.
inline constexpr int kDone = 0;
inline constexpr int kDifferent = 1;  ///< compare: boards differ; stress: a bound is exceeded
inline constexpr int kMistake = 2;    ///< the user's mistake, one sentence on stderr
inline constexpr int kDefect = 3;     ///< a defect of dynrt

struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;  ///< returns the exit code
};

Command add_render_command(CLI::App& program);
Command add_walk_command(CLI::App& program);
Command add_compare_command(CLI::App& program);
Command add_info_command(CLI::App& program);
Command add_report_command(CLI::App& program);
Command add_measure_command(CLI::App& program);
Command add_choose_command(CLI::App& program);
Command add_needs_command(CLI::App& program);
Command add_specialise_command(CLI::App& program);
Command add_stress_command(CLI::App& program);
Command add_view_command(CLI::App& program);

}  // namespace dynrt::host
