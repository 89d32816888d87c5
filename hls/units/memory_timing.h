// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clocks of an emulated memory behind the port: those of the model and of the board with the
// Verilog. A read waits for its bank, whose rows are opened one at a time, and after the latency
// for the data bus, which gives the beats of one read after the other. Reads whose data are there
// first come first, whatever their order was.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>
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

/// Which reads are answered when. It keeps what a read was until then. Writes take their clocks of
/// the bus and open rows too, but nothing waits for them.
template <class Read>
class MemorySchedule {
 public:
  explicit MemorySchedule(const MemoryTiming& timing) : timing_(timing), banks_(kMemoryBanks) {}

  /// A read comes in clock `now`.
  void take(std::uint64_t now, unsigned byte_address, unsigned beats, Read read) {
    const std::uint64_t begin = open(now, byte_address);
    waiting_.push({begin + timing_.latency - 1, taken_++, beats, std::move(read)});
  }
  /// A beat to be written comes in clock `now`.
  void write(std::uint64_t now, unsigned byte_address) {
    open(now, byte_address);
    bus_free_ = std::max(bus_free_, now) + 1;
  }
  /// The read whose beats begin in the next clock, if any do.
  std::optional<Read> answer(std::uint64_t now) {
    if (waiting_.empty() || next() > now) return std::nullopt;
    const Waiting& first = waiting_.top();
    bus_free_ = now + first.beats;
    Read read = first.read;
    waiting_.pop();
    return read;
  }
  /// The clock of the next answer(); only without reads there is none.
  bool is_idle() const { return waiting_.empty(); }
  std::uint64_t next() const { return std::max(bus_free_, waiting_.top().clock); }

 private:
  struct Bank {
    std::uint64_t free = 0;
    std::optional<unsigned> row = {};
  };
  struct Waiting {
    std::uint64_t clock;
    std::uint64_t number;  ///< in the order of their coming
    unsigned beats;
    Read read;
    bool operator>(const Waiting& other) const {
      return std::tie(clock, number) > std::tie(other.clock, other.number);
    }
  };

  /// The clock in which the row of an address is open.
  std::uint64_t open(std::uint64_t now, unsigned byte_address) {
    if (timing_.row_clocks == 0) return now;
    const unsigned row = byte_address / kMemoryRowBytes;
    Bank& bank = banks_[row % kMemoryBanks];
    bank.free = std::max(now, bank.free);
    if (bank.row != row) {
      bank.free += timing_.row_clocks;
      bank.row = row;
    }
    return bank.free;
  }

  MemoryTiming timing_;
  std::vector<Bank> banks_;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
  std::uint64_t taken_ = 0;
  std::uint64_t bus_free_ = 0;
};

}  // namespace dynrt
