// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One line on stderr that says what is going on, rewritten a few times a second and wiped at the
// end. Silent where stderr is no terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace dynrt::host {

class Progress {
 public:
  /// `total` zero: there is no telling how long it takes.
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
