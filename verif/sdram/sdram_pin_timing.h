// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The way between the registers at an FPGA's pins and an SDRAM chip, in time: the chip's set-up and
// hold times at its pins, and a word that is there no longer than its data sheet promises. The
// board's and the FPGA's part of the way is assumed, with its least and its most.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "sdram/sdram_chip.h"

namespace dynrt::verif {

/// Picoseconds.
struct SdramWays {
  /// From the clock inside the FPGA to the chip: the pin's cell, its pad, the board.
  std::uint64_t out_least = 2'500, out_most = 4'000;
  /// By how much pins may be later or earlier than each other.
  std::uint64_t skew = 500;
  /// The FPGA's register needs a word at its pad so long before the clock inside, and behind it.
  std::uint64_t set_up = 1'000, hold = 1'200;
};

class SdramPinTiming {
 public:
  using Ps = std::uint64_t;
  static constexpr std::uint16_t kUnknown = 0xdead;  ///< a word that nobody gives, or not yet

  SdramPinTiming(const SdramPart& part, unsigned cas_latency, const SdramWays& ways = {})
      : part_(part), access_(cas_latency == 2 ? part.access_cas2 : part.access_cas3), ways_(ways) {}

  /// What the FPGA drives at this time.
  void drive(Ps now, const SdramChipPins& pins) {
    if (pins == driven_) return;
    driven_ = pins;
    changed_ = now;
    if (clocked_ && now - *clocked_ < part_.hold_in + ways_.skew) {
      note(
          fmt::format("pins change {} ps behind an edge of its clock; tIH is {} ps, and pins may "
                      "differ by {}",
                      now - *clocked_, part_.hold_in, ways_.skew));
    }
  }
  /// The chip's clock rises at the FPGA's pin; then the chip gives this word, or none.
  void clock(Ps now, const std::optional<std::uint16_t>& word) {
    clocked_ = now;
    if (now - changed_ < part_.set_up_in + ways_.skew) {
      note(
          fmt::format("pins change {} ps before an edge of its clock; tIS is {} ps, and pins may "
                      "differ by {}",
                      now - changed_, part_.set_up_in, ways_.skew));
    }
    coming_.emplace_back(now + ways_.out_least + part_.hold - ways_.hold, kUnknown);
    if (word) coming_.emplace_back(now + ways_.out_most + access_ + ways_.set_up, *word);
  }
  /// What a register of the FPGA takes whose clock rises at this time.
  std::uint16_t word_before(Ps next) {
    for (; !coming_.empty() && coming_.front().first < next; coming_.pop_front()) {
      word_ = coming_.front().second;
    }
    return word_;
  }
  /// The first time that was too short.
  const std::string& fault() const { return fault_; }

 private:
  void note(std::string fault) {
    if (fault_.empty()) fault_ = std::move(fault);
  }

  SdramPart part_;
  Ps access_;
  SdramWays ways_;
  SdramChipPins driven_;
  Ps changed_ = 0;
  std::optional<Ps> clocked_;
  std::deque<std::pair<Ps, std::uint16_t>> coming_;
  std::uint16_t word_ = kUnknown;
  std::string fault_;
};

}  // namespace dynrt::verif
