// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/run_script.h"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "host/board/load_configuration.h"
#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr std::string_view kQuestion = "? ";  ///< begins a line that asks

/// A command that runs, at the other end of a socket: its standard output and, where it may ask,
/// its standard input.
class Running {
 public:
  Running(const std::vector<std::string>& command, bool asks) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return;
    socket_ = ends[0];
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    if (asks) posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    started_ =
        posix_spawnp(&process_, arguments[0], &actions, nullptr, arguments.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
  }
  ~Running() { end(); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// The next line with its end, or what there is of the last one; empty at the end.
  std::string line() {
    std::size_t end = 0;
    while ((end = read_.find('\n')) == std::string::npos) {
      std::array<char, 4096> buffer;
      const ssize_t n = started_ ? read(socket_, buffer.data(), buffer.size()) : 0;
      if (n <= 0) return std::exchange(read_, {});
      read_.append(buffer.data(), static_cast<std::size_t>(n));
    }
    std::string line = read_.substr(0, end + 1);
    read_.erase(0, end + 1);
    return line;
  }

  /// A command that has ended hears nothing.
  void tell(std::string_view text) {
    while (!text.empty()) {
      const ssize_t n = send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
      if (n <= 0) return;
      text.remove_prefix(static_cast<std::size_t>(n));
    }
  }

  /// Waits for the end. The exit code; -1 if it did not run or was killed.
  int end() {
    if (socket_ >= 0) close(std::exchange(socket_, -1));
    int status = 0;
    if (!std::exchange(started_, false) || waitpid(process_, &status, 0) != process_) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  int socket_ = -1;
  pid_t process_ = 0;
  bool started_ = false;
  std::string read_;
};

}  // namespace

CommandOutput output_of(const std::vector<std::string>& command, const Answer& answer) {
  Running running(command, answer != nullptr);
  CommandOutput output;
  for (std::string line; !(line = running.line()).empty();) {
    if (answer != nullptr && line.starts_with(kQuestion)) {
      line.pop_back();
      running.tell(answer(line.substr(kQuestion.size())) + "\n");
    } else {
      output.text += line;
    }
  }
  output.code = running.end();
  while (output.text.ends_with('\n')) output.text.pop_back();
  return output;
}

std::string made_by_script(const std::string& script, const std::vector<std::string>& arguments,
                           const std::string& what, const Answer& answer) {
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
  const CommandOutput output = output_of(command, answer);
  if (output.code != 0) {
    refuse("{}: {}", what, output.text.empty() ? command.front() + " failed" : output.text);
  }
  return output.text;
}

}  // namespace dynrt::host
