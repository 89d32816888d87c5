// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The SRAM banks at the board's pins (units/memory_format.h): synchronous, data `latency` clocks
// after enable and address. Contents are zero at power-up.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "units/memory_format.h"

namespace dynrt::host {

class Sram {
 public:
  using Data = std::array<std::uint32_t, kBanks>;

  explicit Sram(unsigned latency) : pipe_(latency) {
    for (auto& bank : banks_) bank.assign(kBankWords, 0);
  }

  /// The action of a bank at a clock edge with one bit of `enable` set.
  void access(unsigned bank, bool write, std::uint32_t address, std::uint32_t data) {
    std::uint32_t& word = banks_[bank][address & (kBankWords - 1)];
    if (write) {
      word = data;
      if (bank == kFrameBank) frame_writes_ += 2;
    } else {
      pipe_[newest_][bank] = word;
    }
  }

  /// Ends a clock: the data at the pins after its edge. A bank that is not read keeps its data.
  const Data& advance() {
    if (pipe_.size() == 1) return pipe_[0];
    const Data& latest = pipe_[newest_];
    newest_ = newest_ + 1 == pipe_.size() ? 0 : newest_ + 1;
    out_ = pipe_[newest_];
    pipe_[newest_] = latest;
    return out_;
  }

  /// A half of a word, the lower one first, from a memory that is not at these pins.
  void write_half(unsigned bank, std::uint32_t address, unsigned half, std::uint16_t data) {
    std::uint32_t& word = banks_[bank][address];
    const unsigned shift = 16 * half;
    word = (word & ~(0xffffu << shift)) | std::uint32_t{data} << shift;
    frame_writes_ += bank == kFrameBank;
  }
  std::uint32_t word(unsigned bank, std::uint32_t address) const { return banks_[bank][address]; }

  /// Halves of words written into the framebuffer's bank since power-up.
  std::uint64_t frame_writes() const { return frame_writes_; }

 private:
  std::array<std::vector<std::uint32_t>, kBanks> banks_;
  std::vector<Data> pipe_;  ///< words read in the last `latency` clocks, a ring
  Data out_{};
  std::size_t newest_ = 0;
  std::uint64_t frame_writes_ = 0;
};

}  // namespace dynrt::host
