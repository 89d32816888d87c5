// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/run_script.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "host/board/board_messages.h"
#include "host/board/load_configuration.h"
#include "host/error.h"

namespace dynrt::host {

CommandOutput output_of(const std::vector<std::string>& command) {
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

  CommandOutput output;
  std::array<char, 4096> buffer;
  for (ssize_t n; !failed && (n = read(ends[0], buffer.data(), buffer.size())) > 0;) {
    output.text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  close(ends[0]);
  int status = 0;
  if (!failed && waitpid(process, &status, 0) == process && WIFEXITED(status)) {
    output.code = WEXITSTATUS(status);
  }
  while (output.text.ends_with('\n')) output.text.pop_back();
  return output;
}

std::string made_by_script(const std::string& script, const std::vector<std::string>& arguments,
                           const std::string& what) {
  const ThisBuild build = this_build();
  std::vector<std::string> command = {std::string(build.scripts) + "/" + script};
  command.insert(command.end(), arguments.begin(), arguments.end());
  for (const std::string_view word :
       {std::string_view("--build"), build.description, std::string_view("--expect"),
        build.fingerprint, std::string_view("--for-program")}) {
    command.emplace_back(word);
  }
  const CommandOutput output = output_of(command);
  if (output.code != 0) {
    refuse(messages::kNotMade, what,
           output.text.empty() ? command.front() + " failed" : output.text);
  }
  return output.text;
}

}  // namespace dynrt::host
