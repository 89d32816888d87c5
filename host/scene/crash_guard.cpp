// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/crash_guard.h"

#include <unistd.h>

namespace dynrt::host {

namespace {

constexpr int kMistake = 2;
constexpr std::size_t kStackBytes = 1 << 16;

/// What the handler prints; of the thread that the guard is on.
thread_local const std::string* line = nullptr;

/// Calls only what a signal handler may.
void tell(int) {
  if (line != nullptr) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, line->data(), line->size());
    _exit(kMistake);
  }
  _exit(kMistake + 1);  // another thread has crashed: a defect
}

}  // namespace

CrashGuard::CrashGuard(const std::string& sentence)
    : line_("dynrt: " + sentence + "\n"), outer_(line), stack_(kStackBytes) {
  line = &line_;
  stack_t stack{};
  stack.ss_sp = stack_.data();
  stack.ss_size = stack_.size();
  sigaltstack(&stack, &outer_stack_);
  struct sigaction action{};
  action.sa_handler = tell;
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < kCrashes.size(); ++i) {
    sigaction(kCrashes[i], &action, &outer_actions_[i]);
  }
}

CrashGuard::~CrashGuard() {
  for (std::size_t i = 0; i < kCrashes.size(); ++i) {
    sigaction(kCrashes[i], &outer_actions_[i], nullptr);
  }
  sigaltstack(&outer_stack_, nullptr);
  line = outer_;
}

}  // namespace dynrt::host
