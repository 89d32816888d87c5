// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The project's scripts, run by the program for what takes compilers and synthesis.
#pragma once

#include <string>
#include <vector>

namespace dynrt::host {

struct CommandOutput {
  std::string text;  ///< on standard output, without the newline at its end
  int code = -1;     ///< -1: it did not run or was killed
};

/// Runs a command; its progress and complaints go to the terminal.
CommandOutput output_of(const std::vector<std::string>& command);

/// Runs the script of that name below scripts/, told of which build it is, with --for-program: it
/// prints the path of what it made or, where it fails, a sentence. Throws UserError with the
/// sentence behind `what`.
std::string made_by_script(const std::string& script, const std::vector<std::string>& arguments,
                           const std::string& what);

}  // namespace dynrt::host
