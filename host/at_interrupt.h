// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Clean-up that a part of the program does when SIGHUP, SIGINT or SIGTERM ends the program.
#pragma once

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>

namespace dynrt::host {

class AtInterrupt {
 public:
  /// May call only functions that are safe in a signal handler.
  using Action = void (*)(const void* of);

  /// While this object lives, the end by a signal calls `action` with `of`.
  AtInterrupt(Action action, const void* of) : action_(action), of_(of) {
    static const bool caught = (catch_signals(), true);
    static_cast<void>(caught);
    for (const AtInterrupt* none = nullptr; slot_ < slots.size(); ++slot_, none = nullptr) {
      if (slots[slot_].compare_exchange_strong(none, this)) break;
    }
  }
  ~AtInterrupt() {
    if (slot_ < slots.size()) slots[slot_] = nullptr;
  }
  AtInterrupt(const AtInterrupt&) = delete;
  AtInterrupt& operator=(const AtInterrupt&) = delete;

 private:
  static void end(int signal) {
    for (const auto& slot : slots) {
      if (const AtInterrupt* at = slot.load()) at->action_(at->of_);
    }
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  /// A signal that is ignored, as by nohup, stays so.
  static void catch_signals() {
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
      // A handler that is already installed stays, and then decides about the clean-up too.
      const auto before = std::signal(signal, end);
      if (before != SIG_DFL) std::signal(signal, before);
    }
  }

  static inline std::array<std::atomic<const AtInterrupt*>, 16> slots;

  Action action_;
  const void* of_;
  std::size_t slot_ = 0;
};

}  // namespace dynrt::host
