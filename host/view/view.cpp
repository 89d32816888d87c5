// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/view.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "host/error.h"
#include "host/view/page_files.h"
#include "host/view/rendering_thread.h"
#include "host/view/server.h"
#include "host/view/session.h"

namespace dynrt::host {

namespace {

int stop_pipe[2];

void stop_at_signal(int /*signal*/) {
  const char byte = 0;
  [[maybe_unused]] const auto written = write(stop_pipe[1], &byte, 1);
}

/// Programs that are started do not inherit the handler, so that they end with the same signal.
void wait_for_signal() {
  char byte = 0;
  while (read(stop_pipe[0], &byte, 1) < 0 && errno == EINTR) {
  }
}

void catch_signals() {
  if (pipe2(stop_pipe, O_CLOEXEC) != 0) throw std::runtime_error("no pipe for signals");
  struct sigaction action{};
  action.sa_handler = stop_at_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

/// Opens the user's browser with xdg-open, which fails without a display, may be missing, and may
/// run until the browser is closed.
void open_browser(const std::string& address, const std::function<void()>& failed) {
  std::string program = "xdg-open", where = address;
  char* const arguments[] = {program.data(), where.data(), nullptr};
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_RDWR, 0);
  }
  pid_t process = 0;
  const int error = posix_spawnp(&process, program.data(), &quiet, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&quiet);
  if (error != 0) return failed();
  std::thread([process, failed] {
    int status = 0;
    const bool ended = waitpid(process, &status, 0) == process;
    if (!ended || !WIFEXITED(status) || WEXITSTATUS(status) != 0) failed();
  }).detach();
}

}  // namespace

std::string recorded_view(ViewServices services) {
  const std::atomic<unsigned> nothing_urgent = 0;
  return Session(std::move(services), nothing_urgent).record(page_files());
}

void view(ViewServices services, const ViewWindow& window) {
  // They outlive this function: a thread may be rendering when it returns.
  auto& rendering = *new RenderingThread;
  auto& jobs = *new JobRunner;
  auto& lowering = *new JobRunner;
  const auto make = services.make, lower = services.lower;
  auto& session = *new Session(std::move(services), rendering.urgent());
  const auto begin = [](JobRunner& runner, const char* what, const auto& act,
                        const Json& question) -> Answer {
    const ViewChoices choices = choices_of(question);
    const unsigned job = runner.start(fmt::format("{} {}", what, choices.configuration),
                                      [act, choices](const JobRunner::Tell& tell) -> Json {
                                        act(choices, tell);
                                        return json_of(choices);
                                      });
    return {.head = {{"job", job}}};
  };
  const auto answer = [&, make, lower, begin](const Json& question) -> Answer {
    const std::string type = question.at("type");
    if (type == "progress") return Answer{.head = jobs.progress()};
    if (type == "lowering") return Answer{.head = lowering.progress()};
    if (type == "make") return begin(jobs, "configuration", make, question);
    if (type == "lower") return begin(lowering, "the units of", lower, question);
    if (type == "compare") {
      JobRunner::Job job = rendering.run(true, [&] { return session.comparison(question); });
      return Answer{.head = {{"job", jobs.start("the frame through the RTL", std::move(job))}}};
    }
    const bool urgent = type == "frame" || type == "open" || type == "pixel";
    return rendering.run(urgent, [&] { return session.answer(question); });
  };
  answer({{"type", "start"}});  // a mistake in the scene ends the program here
  auto& server = *new ViewServer(page_files(), window.port, answer);
  catch_signals();
  if (server.port() != window.port) {
    window.say(fmt::format("port        {} is in use; took {}\n", window.port, server.port()));
  }
  window.say(fmt::format("window      {}\n", server.address()));
  if (window.browser) {
    open_browser(server.address(),
                 [&window] { window.say("browser     none opened; open the address in one\n"); });
  }
  wait_for_signal();
}

}  // namespace dynrt::host
