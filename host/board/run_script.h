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

/// Gives the line that answers a question.
using Answer = std::function<std::string(const std::string& question)>;

/// Runs a command; its progress and messages go to the terminal. With an `answer`, each line that
/// begins with "? " is a question, and the command reads the answer from its standard input.
CommandOutput output_of(const std::vector<std::string>& command, const Answer& answer = {});

/// Runs a script of scripts/ for this build with --for-program. The script prints the path of the
/// file that it made or, if it fails, a sentence. Throws UserError with `what` and that sentence.
std::string made_by_script(const std::string& script, const std::vector<std::string>& arguments,
                           const std::string& what, const Answer& answer = {});

}  // namespace dynrt::host
