// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Some of Assimp's readers run out of their memory or stack on a damaged file of a rare format, and
// would take the program with them without a word. There is no going on after that, but the user is
// told of the file.
#pragma once

#include <array>
#include <csignal>
#include <string>
#include <vector>

namespace dynrt::host {

/// While it lives, a crash of this thread prints "dynrt: SENTENCE" and ends the program with exit
/// code 2, that of a mistake in the input.
class CrashGuard {
 public:
  explicit CrashGuard(const std::string& sentence);
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

 private:
  static constexpr std::array kCrashes = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

  std::string line_;
  const std::string* outer_;  ///< of the guard around this one
  std::vector<char> stack_;   ///< for the handler, as the program's own may be full
  stack_t outer_stack_{};
  std::array<struct sigaction, kCrashes.size()> outer_actions_{};
};

}  // namespace dynrt::host
