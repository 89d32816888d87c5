// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The host's transfers and their time on the way to the board. Most boards have a 33 MHz, 32-bit
// PCI bus: bursts of at most kMaxBurst words, each an address phase, for a read a turnaround and
// the target's first-word wait, one clock per word, and an idle clock. Register accesses are bursts
// of one.
#pragma once

#include <cstdint>

namespace dynrt::host {

inline constexpr double kPciClockHz = 33e6;

/// What went over the bus, and its time there.
struct BusTraffic {
  std::uint64_t transactions = 0;
  std::uint64_t bytes_written = 0;
  std::uint64_t bytes_read = 0;
  std::uint64_t bus_clocks = 0;
  double clock_hz = kPciClockHz;  ///< of the bus; of a serial line, bits a second
  double seconds() const { return static_cast<double>(bus_clocks) / clock_hz; }
  friend bool operator==(const BusTraffic&, const BusTraffic&) = default;
  /// The traffic since `before`.
  friend BusTraffic operator-(const BusTraffic& now, const BusTraffic& before) {
    return {now.transactions - before.transactions, now.bytes_written - before.bytes_written,
            now.bytes_read - before.bytes_read, now.bus_clocks - before.bus_clocks, now.clock_hz};
  }
};

class BusMeter {
 public:
  static constexpr std::uint64_t kMaxBurst = 256;     ///< words; bounded by the bus's latency timer
  static constexpr std::uint64_t kWriteOverhead = 2;  ///< address phase, idle
  static constexpr std::uint64_t kReadOverhead = 5;   ///< and turnaround, two clocks to first word

  void write(std::uint64_t words) {
    count(words, kWriteOverhead);
    traffic_.bytes_written += 4 * words;
  }
  void read(std::uint64_t words) {
    count(words, kReadOverhead);
    traffic_.bytes_read += 4 * words;
  }
  const BusTraffic& traffic() const { return traffic_; }

 private:
  void count(std::uint64_t words, std::uint64_t overhead) {
    const std::uint64_t bursts = (words + kMaxBurst - 1) / kMaxBurst;
    traffic_.transactions += bursts;
    traffic_.bus_clocks += words + bursts * overhead;
  }
  BusTraffic traffic_;
};

}  // namespace dynrt::host
