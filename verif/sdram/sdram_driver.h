// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Commands to the chip's model, pin by pin, for the tests of its rules.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sdram/sdram_chip.h"

namespace dynrt::verif {

/// Drives a chip by commands; clocks between them do nothing.
class SdramDriver {
 public:
  static constexpr unsigned kPauseClocks = 100;

  explicit SdramDriver(SdramPart part, unsigned clock = 7'500, unsigned cas = 3)
      : part_(with_short_pause(part, clock)), clock_(clock), cas_(cas), chip_(part_, clock) {}

  SdramChip& chip() { return chip_; }
  unsigned clocks(unsigned picoseconds) const { return clocks_of(picoseconds, clock_); }

  void none(unsigned clocks = 1) {
    for (unsigned i = 0; i < clocks; ++i) command(true, true, true, 0, 0);
  }
  void mode(unsigned value) { command(false, false, false, 0, value); }
  void refresh() { command(false, false, true, 0, 0); }
  void precharge(unsigned bank) { command(false, true, false, bank, 0); }
  void precharge_all() { command(false, true, false, 0, 1 << 10); }
  void activate(unsigned bank, unsigned row) { command(false, true, true, bank, row); }
  void read(unsigned bank, unsigned column, bool closes = false) {
    command(true, false, true, bank, column | (closes ? 1u << 10 : 0));
  }
  void write(unsigned bank, unsigned column, std::uint16_t first, bool closes = false) {
    pins_.dq = first;
    command(true, false, false, bank, column | (closes ? 1u << 10 : 0));
  }
  /// A clock without a command in which the controller drives a word.
  void data(std::uint16_t word, unsigned dqm = 0) {
    pins_.dq = word;
    pins_.dqm = dqm;
    none();
  }
  void mask_next(unsigned dqm) { pins_.dqm = dqm; }
  void stop_clock_enable() { pins_.cke = false; }
  void terminate() { command(true, true, false, 0, 0); }

  /// The words on the data pins at the edges since the last call; -1 where the pins float.
  std::vector<int> words() {
    std::vector<int> words = std::move(words_);
    words_.clear();
    return words;
  }

  /// All that comes before the first access, words in bursts of two.
  void set_up(unsigned burst = 1) {
    none(kPauseClocks);
    precharge_all();
    none(clocks(part_.rp) - 1);
    for (unsigned i = 0; i < part_.first_refreshes; ++i) {
      refresh();
      none(clocks(part_.rfc) - 1);
    }
    mode(cas_ << 4 | burst);
    none(clocks(part_.mrd) - 1);
  }
  /// A row that may be used in the next clock.
  void open(unsigned bank, unsigned row) {
    activate(bank, row);
    none(clocks(part_.rcd) - 1);
  }
  const SdramPart& part() const { return part_; }

 private:
  static SdramPart with_short_pause(SdramPart part, unsigned clock) {
    part.pause = kPauseClocks * clock;
    return part;
  }
  void command(bool ras_n, bool cas_n, bool we_n, unsigned bank, unsigned address) {
    pins_.ras_n = ras_n;
    pins_.cas_n = cas_n;
    pins_.we_n = we_n;
    pins_.bank = bank;
    pins_.address = address;
    const auto word = chip_.dq();
    words_.push_back(word ? int{*word} : -1);
    chip_.clock(pins_);
    pins_ = {};
  }

  SdramPart part_;
  unsigned clock_;
  unsigned cas_;
  SdramChip chip_;
  SdramChipPins pins_;
  std::vector<int> words_;
};

}  // namespace dynrt::verif
