// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Commands whose work is a workflow of many runs of this program: scripts do it, and know the
// flags.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace dynrt::host {

/// A subcommand that leaves all that follows its name, --help too, to the script at
/// scripts/<script>, and becomes it. The function never returns unless it throws UserError.
struct ScriptCommand {
  CLI::App* app = nullptr;
  std::function<int()> run;
};
ScriptCommand add_script_command(CLI::App& parent, const std::string& name,
                                 const std::string& about, const std::string& script);

}  // namespace dynrt::host
