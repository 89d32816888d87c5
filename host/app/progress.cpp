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
  if (terminal_) show(what_, 0, total_, begin_);
}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "{}", kWipe);
}

void Progress::update(std::uint64_t done) {
  if (is_due()) show(what_, done, total_, begin_);
}

void Progress::update(std::string_view part, std::uint64_t done, std::uint64_t total) {
  if (part != part_) part_begin_ = Clock::now();
  part_ = part;
  if (is_due()) show(fmt::format("{}: {}", what_, part), done, total, part_begin_);
}

bool Progress::is_due() {
  if (!terminal_ || Clock::now() - shown_ < kBetween) return false;
  shown_ = Clock::now();
  return true;
}

void Progress::show(const std::string& what, std::uint64_t done, std::uint64_t total,
                    Clock::time_point begin) {
  std::string line = what;
  if (total != 0) {
    const double share = static_cast<double>(std::min(done, total)) / static_cast<double>(total);
    line += fmt::format(" {:3.0f} %", 100 * share);
    const std::chrono::duration<double> seconds = Clock::now() - begin;
    if (share > 0.01) line += fmt::format(", {:.0f} s left", seconds.count() * (1 / share - 1));
  }
  fmt::print(stderr, "{}{}", kWipe, line);
  std::fflush(stderr);
}

}  // namespace dynrt::host
