// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs the project's scripts for work that needs compilers and synthesis.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace dynrt::host {

struct CommandOutput {
  std::string text;  ///< on standard output, without the newline at its end
  int code = -1;     ///< -1: it did not run or was killed
};

/// Hears of a step of the work.
using Tell = std::function<void(const std::string& step)>;

/// Runs a command; its messages go to the terminal. With `tell`, each line that begins with "? " is
/// a step and no output; if `tell` throws, the command is interrupted.
CommandOutput output_of(const std::vector<std::string>& command, const Tell& tell = {});

/// Runs a script of scripts/ for this build with --for-program. The script prints the path of the
/// file that it made, or other results, or, if it fails, a sentence. Throws UserError with `what`,
/// if that is not empty, and that sentence.
std::string made_by_script(const std::string& script, const std::vector<std::string>& arguments,
                           const std::string& what, const Tell& tell = {});

}  // namespace dynrt::host
