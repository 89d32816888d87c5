// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A progress line on stderr, rewritten a few times a second and erased at the end. Nothing is
// printed if stderr is not a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace dynrt::host {

class Progress {
  using Clock = std::chrono::steady_clock;

 public:
  /// `total` is zero if the number of steps is not known.
  explicit Progress(std::string what, std::uint64_t total = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::uint64_t done);
  /// Of a part that has steps of its own.
  void update(std::string_view part, std::uint64_t done, std::uint64_t total);

 private:
  bool is_due();
  void show(const std::string& what, std::uint64_t done, std::uint64_t total,
            Clock::time_point begin);

  std::string what_;
  std::uint64_t total_;
  bool terminal_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
  std::string part_;
  Clock::time_point part_begin_ = begin_;
};

}  // namespace dynrt::host
