// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/run_script.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

#include "host/board/load_configuration.h"
#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr std::string_view kStep = "? ";  ///< begins a line that tells one

/// A command that runs, and its standard output.
class Running {
 public:
  explicit Running(const std::vector<std::string>& command) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    output_ = fdopen(ends[0], "r");
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    if (posix_spawnp(&process_, arguments[0], &actions, nullptr, arguments.data(), environ) != 0) {
      process_ = 0;
    }
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
  }
  ~Running() {
    if (process_ > 0) kill(process_, SIGINT);
    end();
    free(line_);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// The next line with its end, or what there is of the last one; empty at the end.
  std::string line() {
    const ssize_t length = output_ == nullptr ? -1 : getline(&line_, &room_, output_);
    return length <= 0 ? std::string() : std::string(line_, static_cast<std::size_t>(length));
  }

  /// Waits for the end. The exit code; -1 if it did not run or was killed.
  int end() {
    if (output_ != nullptr) std::fclose(std::exchange(output_, nullptr));
    int status = 0;
    const pid_t process = std::exchange(process_, 0);
    if (process <= 0 || waitpid(process, &status, 0) != process) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  FILE* output_ = nullptr;
  pid_t process_ = 0;
  char* line_ = nullptr;  ///< of getline()
  std::size_t room_ = 0;
};

}  // namespace

CommandOutput output_of(const std::vector<std::string>& command, const Tell& tell) {
  Running running(command);
  CommandOutput output;
  for (std::string line; !(line = running.line()).empty();) {
    if (tell != nullptr && line.starts_with(kStep)) {
      line.pop_back();
      tell(line.substr(kStep.size()));
    } else {
      output.text += line;
    }
  }
  output.code = running.end();
  while (output.text.ends_with('\n')) output.text.pop_back();
  return output;
}

std::string made_by_script(const std::string& script, const std::vector<std::string>& arguments,
                           const std::string& what, const Tell& tell) {
  const ThisBuild build = this_build();
  std::vector<std::string> command = {std::string(build.scripts) + "/" + script};
  command.insert(command.end(), arguments.begin(), arguments.end());
  for (const std::string_view word :
       {std::string_view("--build"), build.description, std::string_view("--expect"),
        build.fingerprint, std::string_view("--for-program")}) {
    command.emplace_back(word);
  }
  std::error_code error;
  if (!std::filesystem::exists(command.front(), error)) {
    refuse(
        "{}: is made by {}, which is not there; the program needs the folder that it was built "
        "from",
        what, command.front());
  }
  const CommandOutput output = output_of(command, tell);
  if (output.code != 0) {
    const std::string why = output.text.empty() ? command.front() + " failed" : output.text;
    throw UserError(what.empty() ? why : fmt::format("{}: {}", what, why));
  }
  return output.text;
}

}  // namespace dynrt::host
