// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A serial device that is a pseudo-terminal, and boards at its other end, for tests.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "link/simulated_line.h"

namespace dynrt::host {

class PseudoTerminal {
 public:
  PseudoTerminal() : file_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_GE(file_, 0);
    EXPECT_EQ(::grantpt(file_), 0);
    EXPECT_EQ(::unlockpt(file_), 0);
    path_ = ::ptsname(file_);
    // Keeps the device in being while nobody uses it, and raw from the start.
    held_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY);
    termios raw{};
    ::tcgetattr(held_, &raw);
    ::cfmakeraw(&raw);
    ::tcsetattr(held_, TCSANOW, &raw);
  }
  ~PseudoTerminal() {
    ::close(held_);
    ::close(file_);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Of the device.
  const std::string& path() const { return path_; }

  /// Whether a program that has opened the device keeps out others, of which root sees nothing
  /// else.
  bool is_exclusive() const {
    int exclusive = 0;
    EXPECT_EQ(::ioctl(held_, TIOCGEXCL, &exclusive), 0);
    return exclusive != 0;
  }

  /// What the user of the device has sent, after so many ms at most if there is nothing.
  std::vector<std::uint8_t> read(int milliseconds) {
    pollfd poll{.fd = file_, .events = POLLIN, .revents = 0};
    if (::poll(&poll, 1, milliseconds) <= 0 || (poll.revents & POLLIN) == 0) return {};
    std::vector<std::uint8_t> bytes(4096);
    const ssize_t count = ::read(file_, bytes.data(), bytes.size());
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }
  /// Sends as many bytes as the device takes at once; gives their number.
  std::size_t write(std::span<const std::uint8_t> bytes) {
    const ssize_t sent = ::write(file_, bytes.data(), bytes.size());
    return sent > 0 ? static_cast<std::size_t>(sent) : 0;
  }

 private:
  int file_;
  int held_ = -1;
  std::string path_;
};

/// Runs a board at a pseudo-terminal, in a thread, until it is destroyed.
class BoardAtTerminal {
 public:
  explicit BoardAtTerminal(BoardFunction board)
      : board_(std::move(board)), thread_([this] { run(); }) {}
  ~BoardAtTerminal() {
    ends_ = true;
    thread_.join();
  }
  BoardAtTerminal(const BoardAtTerminal&) = delete;
  BoardAtTerminal& operator=(const BoardAtTerminal&) = delete;

  const std::string& path() const { return terminal_.path(); }
  const PseudoTerminal& terminal() const { return terminal_; }

 private:
  void run() {
    while (!ends_) {
      const std::vector<std::uint8_t> bytes = terminal_.read(20);
      if (bytes.empty()) continue;
      const std::vector<std::uint8_t> answer = board_(bytes);
      for (std::size_t at = 0; at < answer.size() && !ends_;) {
        at += terminal_.write(std::span(answer).subspan(at));
      }
    }
  }

  PseudoTerminal terminal_;
  BoardFunction board_;
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

}  // namespace dynrt::host
