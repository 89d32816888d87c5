// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A line of bytes to a board that is a function, in a time of its own: each byte takes its time on
// the line, in both directions, and both ends of the cable add a latency. Bytes are lost, changed,
// repeated, added and delayed at random.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hls/random.h"
#include "host/link/byte_stream.h"
#include "units/link_format.h"

namespace dynrt::host {

using Bytes = std::vector<std::uint8_t>;
/// The board's answer to bytes.
using BoardFunction = std::function<Bytes(std::span<const std::uint8_t>)>;

/// Chances for each byte.
struct LineMistakes {
  double lose = 0, change = 0, repeat = 0, add = 0, delay = 0;
};

class SimulatedLine final : public ByteStream {
 public:
  struct Settings {
    LineMistakes mistakes = {};
    Time latency = Time(0);  ///< of each direction
    std::uint64_t seed = 1;
    Time* clock = nullptr;  ///< shows the time, if there is one
  };
  SimulatedLine(BoardFunction board, Settings settings)
      : ByteStream("simulated"),
        board_(std::move(board)),
        settings_(settings),
        random_(settings.seed) {}

  std::size_t write(std::span<const std::uint8_t> bytes) override {
    const std::size_t count = std::min(bytes.size(), room());
    for (const std::uint8_t byte : bytes.first(count)) to_board_.put(byte, now_, *this);
    return count;
  }
  std::size_t read(std::span<std::uint8_t> bytes) override {
    std::size_t count = 0;
    for (; count < bytes.size() && to_host_.has_come(now_); ++count) bytes[count] = to_host_.take();
    return count;
  }
  void wait(bool to_write, Time deadline) override {
    while (!to_host_.has_come(now_) && !(to_write && room() > 0) && now_ < deadline) {
      Time next = std::min({deadline, to_host_.next(), to_board_.next()});
      if (to_write) next = std::min(next, now_ + kByte);
      now_ = std::max(now_, next);
      if (settings_.clock != nullptr) *settings_.clock = now_;
      serve();
    }
  }
  Time now() const override { return now_; }
  /// Mistakes that were made.
  std::uint64_t mistakes() const { return mistakes_; }

 private:
  static constexpr Time kByte{std::uint64_t{1'000'000'000} * kLineBitsOfByte / kLinkBaud};
  static constexpr std::size_t kBuffer = 4096;  ///< of the operating system

  /// One direction.
  class Way {
   public:
    void put(std::uint8_t byte, Time now, SimulatedLine& line) {
      free_ = std::max(free_, now) + kByte;
      const LineMistakes& chance = line.settings_.mistakes;
      if (line.happens(chance.delay)) free_ += Time(line.random_.below(3'000'000));
      if (line.happens(chance.lose)) return;
      if (line.happens(chance.change))
        byte ^= static_cast<std::uint8_t>(1u << line.random_.below(8));
      push(byte, line);
      if (line.happens(chance.repeat)) push(byte, line);
      if (line.happens(chance.add)) push(static_cast<std::uint8_t>(line.random_.below(256)), line);
    }
    bool has_come(Time now) const { return !bytes_.empty() && bytes_.front().first <= now; }
    Time next() const { return bytes_.empty() ? Time::max() : bytes_.front().first; }
    std::uint8_t take() {
      const std::uint8_t byte = bytes_.front().second;
      bytes_.pop_front();
      return byte;
    }
    Time free() const { return free_; }

   private:
    void push(std::uint8_t byte, const SimulatedLine& line) {
      bytes_.emplace_back(free_ + line.settings_.latency, byte);
    }
    std::deque<std::pair<Time, std::uint8_t>> bytes_;
    Time free_{0};  ///< when the line has sent what it has
  };

  bool happens(double chance) {
    if (chance == 0 || !random_.chance(chance)) return false;
    ++mistakes_;
    return true;
  }
  std::size_t room() const {
    const Time left = std::max(to_board_.free() - now_, Time(0));
    const auto waiting = static_cast<std::size_t>((left + kByte - Time(1)) / kByte);
    return kBuffer - std::min(waiting, kBuffer);
  }
  void serve() {
    while (to_board_.has_come(now_)) {
      const std::uint8_t byte = to_board_.take();
      for (const std::uint8_t answer : board_({&byte, 1})) to_host_.put(answer, now_, *this);
    }
  }

  BoardFunction board_;
  const Settings settings_;
  hls::testing::Random random_;
  Way to_board_, to_host_;
  Time now_{0};
  std::uint64_t mistakes_ = 0;
};

}  // namespace dynrt::host
