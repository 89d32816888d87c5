// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Commands that run this program many times: scripts do the work and parse the flags.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace dynrt::host {

/// Adds a subcommand that replaces this process by scripts/<script> and passes on `first`, if it is
/// not empty, and all its arguments, --help included.
struct ScriptCommand {
  CLI::App* app = nullptr;
  std::function<int()> run;
};
ScriptCommand add_script_command(CLI::App& parent, const std::string& name,
                                 const std::string& about, const std::string& script,
                                 const std::string& first = "");

}  // namespace dynrt::host
