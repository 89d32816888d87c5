// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clocks of an emulated memory behind the port: those of the model and of the board with the
// Verilog. A read waits for its bank, whose rows are opened one at a time, and after the latency
// for the data bus, which gives the beats of one read after the other. Reads whose data are there
// first come first, whatever their order was.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace dynrt {

struct MemoryTiming {
  unsigned latency = 8;     ///< clocks from a read of an open row to its first beat, at least 1
  unsigned row_clocks = 0;  ///< more of a read that opens a row; 0: there are no rows
  friend bool operator==(const MemoryTiming&, const MemoryTiming&) = default;
};
inline constexpr unsigned kMaxMemoryLatency = 200;
inline constexpr unsigned kMaxRowClocks = 200;
inline constexpr unsigned kMemoryRowBytes = 1024;  ///< of a row
inline constexpr unsigned kMemoryBanks = 4;        ///< each with an open row; rows go round them

/// Which reads are answered when. A read has a number, in the order of their coming.
class MemorySchedule {
 public:
  explicit MemorySchedule(const MemoryTiming& timing) : timing_(timing), banks_(kMemoryBanks) {}

  /// A read comes in clock `now`; gives its number.
  std::size_t take(std::uint64_t now, unsigned byte_address, unsigned beats) {
    const unsigned row = byte_address / kMemoryRowBytes;
    Bank& bank = banks_[row % kMemoryBanks];
    std::uint64_t begin = std::max(now, bank.free);
    if (timing_.row_clocks != 0 && bank.row != row) {
      begin += timing_.row_clocks;
      bank.row = row;
      ++rows_opened_;
    }
    bank.free = timing_.row_clocks != 0 ? begin : 0;
    waiting_.push({begin + timing_.latency - 1, beats_.size()});
    beats_.push_back(beats);
    return beats_.size() - 1;
  }
  /// The read whose beats begin in the next clock, if any do.
  std::optional<std::size_t> answer(std::uint64_t now) {
    if (waiting_.empty() || next() > now) return std::nullopt;
    const std::size_t read = waiting_.top().second;
    waiting_.pop();
    bus_free_ = now + beats_[read];
    return read;
  }
  /// The clock of the next answer(); only without reads there is none.
  bool is_idle() const { return waiting_.empty(); }
  std::uint64_t next() const { return std::max(bus_free_, waiting_.top().first); }

  std::uint64_t rows_opened() const { return rows_opened_; }

 private:
  struct Bank {
    std::uint64_t free = 0;
    std::optional<unsigned> row = {};
  };
  using Waiting = std::pair<std::uint64_t, std::size_t>;  ///< clock, number

  MemoryTiming timing_;
  std::vector<Bank> banks_;
  std::vector<unsigned> beats_;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
  std::uint64_t bus_free_ = 0;
  std::uint64_t rows_opened_ = 0;
};

}  // namespace dynrt
