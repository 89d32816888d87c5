// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs scripts/configuration. What it prints is the library's path or, where it fails, a sentence;
// its progress goes to the terminal.
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <vector>

#include "host/board/load_configuration.h"
#include "host/board/messages.h"
#include "host/error.h"

namespace dynrt::host {

namespace {

struct Said {
  std::string text;  ///< on standard output, without the newline at its end
  int code = -1;     ///< -1: it did not run or was killed
};

Said output_of(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  int ends[2];
  if (pipe(ends) != 0) return {};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  posix_spawn_file_actions_addclose(&actions, ends[1]);
  pid_t process = 0;
  const int failed =
      posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);

  Said said;
  std::array<char, 4096> buffer;
  for (ssize_t n; !failed && (n = read(ends[0], buffer.data(), buffer.size())) > 0;) {
    said.text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  close(ends[0]);
  int status = 0;
  if (!failed && waitpid(process, &status, 0) == process && WIFEXITED(status)) {
    said.code = WEXITSTATUS(status);
  }
  while (said.text.ends_with('\n')) said.text.pop_back();
  return said;
}

}  // namespace

std::string make_configuration(const std::string& json_path) {
  std::error_code error;
  if (!std::filesystem::exists(json_path, error)) {
    refuse(messages::kNoConfigurationFile, json_path);
  }
  const ThisBuild build = this_build();
  const std::string script = std::string(build.scripts) + "/configuration";
  const Said said = output_of({script, json_path, "--build", std::string(build.description),
                               "--expect", std::string(build.fingerprint), "--for-program"});
  if (said.code != 0) {
    refuse(messages::kNotMade, json_path, said.text.empty() ? script + " failed" : said.text);
  }
  return said.text;
}

}  // namespace dynrt::host
