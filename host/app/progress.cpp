// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace dynrt::host {

namespace {

constexpr auto kBetween = std::chrono::milliseconds(200);
constexpr char kWipe[] = "\r\033[K";

}  // namespace

Progress::Progress(std::string what, std::uint64_t total)
    : what_(std::move(what)), total_(total), terminal_(isatty(STDERR_FILENO) != 0) {
  if (terminal_) show(0);
}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "{}", kWipe);
}

void Progress::update(std::uint64_t done) {
  if (!terminal_ || Clock::now() - shown_ < kBetween) return;
  shown_ = Clock::now();
  show(done);
}

void Progress::show(std::uint64_t done) {
  std::string line = what_;
  if (total_ != 0) {
    const double share = static_cast<double>(std::min(done, total_)) / static_cast<double>(total_);
    line += fmt::format(" {:3.0f} %", 100 * share);
    const std::chrono::duration<double> seconds = Clock::now() - begin_;
    if (share > 0.01) line += fmt::format(", {:.0f} s left", seconds.count() * (1 / share - 1));
  }
  fmt::print(stderr, "{}{}", kWipe, line);
  std::fflush(stderr);
}

}  // namespace dynrt::host
