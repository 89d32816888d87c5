// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs a program in its own folder and keeps its output.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "host/test_folder.h"

namespace dynrt::host {

struct Outcome {
  int code = -1;
  std::string out, err;
  std::vector<std::string> files;  ///< left in the folder, sorted
};

/// `folder` keeps its files between runs; stdout and stderr are files, so no terminal. `stdout_to`
/// names a file for stdout instead of Outcome::out.
inline Outcome run_program(const std::string& program, const std::string& arguments,
                           const std::filesystem::path& folder, const std::string& stdout_to = {}) {
  namespace fs = std::filesystem;
  const fs::path out = stdout_to.empty() ? folder.string() + ".out" : stdout_to;
  const fs::path err = folder.string() + ".err";
  const std::string command = "cd '" + folder.string() + "' && '" + program + "' " + arguments +
                              " > '" + out.string() + "' 2> '" + err.string() + "' < /dev/null";
  const int status = std::system(command.c_str());
  Outcome outcome;
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (stdout_to.empty()) outcome.out = text_of(out);
  outcome.err = text_of(err);
  outcome.files = names_in(folder);
  if (stdout_to.empty()) fs::remove(out);
  fs::remove(err);
  return outcome;
}

}  // namespace dynrt::host
