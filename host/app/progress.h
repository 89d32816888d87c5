// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A progress line on stderr, rewritten a few times a second and erased at the end. Nothing is
// printed if stderr is not a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace dynrt::host {

class Progress {
 public:
  /// `total` is zero if the number of steps is not known.
  explicit Progress(std::string what, std::uint64_t total = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::uint64_t done);

 private:
  void show(std::uint64_t done);

  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::uint64_t total_;
  bool terminal_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
};

}  // namespace dynrt::host
