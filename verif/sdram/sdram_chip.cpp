// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "sdram/sdram_chip.h"

#include <fmt/format.h>

#include <stdexcept>

namespace dynrt::verif {

SdramChip::SdramChip(const SdramPart& part, unsigned clock_picoseconds)
    : part_(part),
      clock_picoseconds_(clock_picoseconds),
      rows_(std::size_t{kSdramBanks} << kSdramRowBits),
      refresh_clocks_(part.refreshes) {}

std::uint16_t& SdramChip::word(unsigned bank, unsigned row, unsigned column) {
  const unsigned rows = 1u << kSdramRowBits;
  const unsigned columns = 1u << part_.column_bits;
  if (bank >= kSdramBanks || row >= rows || column >= columns) {
    throw std::out_of_range(
        fmt::format("the SDRAM has no bank {}, row {}, column {}; there are {}, {} and {}", bank,
                    row, column, kSdramBanks, rows, columns));
  }
  std::vector<std::uint16_t>& words = rows_[std::size_t{bank} * rows + row];
  if (words.empty()) {
    // A cell that nobody wrote holds anything.
    auto noise = static_cast<std::uint32_t>((bank * rows + row) * 2654435761u + 1);
    words.resize(columns);
    for (std::uint16_t& cell : words) {
      noise = noise * 1664525u + 1013904223u;
      cell = static_cast<std::uint16_t>(noise >> 16);
    }
  }
  return words[column];
}

void SdramChip::clock(const SdramChipPins& pins) {
  check_bus(pins);
  check_times();
  if (!pins.cke) {
    fault(SdramRule::kClockEnable, {}, "CKE is low; this model has no power-down, so keep it high");
  }
  for (unsigned b = 0; b < kSdramBanks; ++b) {
    if (banks_[b].closes <= now_) close(b, banks_[b].closes);
  }
  run(command_of(pins), pins);
  step_burst(pins);

  // The word for the next edge, unless DQM was high two edges before it.
  std::optional<std::uint16_t>& word = coming_[(now_ + 1) % coming_.size()];
  drove_ = driven_.has_value();
  driven_ = word;
  if (driven_ && last_dqm_ == 3) driven_.reset();
  if (word) ++counters_.words_read;
  word.reset();
  last_dqm_ = pins.dqm;
  if (is_set_up()) ++counters_.clocks;
  ++now_;
}

SdramChip::Command SdramChip::command_of(const SdramChipPins& pins) {
  constexpr Command kCommands[] = {Command::kMode,      Command::kRefresh, Command::kPrecharge,
                                   Command::kActivate,  Command::kWrite,   Command::kRead,
                                   Command::kTerminate, Command::kNone};
  if (pins.cs_n) return Command::kNone;
  return kCommands[(pins.ras_n ? 4 : 0) | (pins.cas_n ? 2 : 0) | (pins.we_n ? 1 : 0)];
}

void SdramChip::run(Command command, const SdramChipPins& pins) {
  if (command == Command::kNone) return;
  if (now_ * clock_picoseconds_ < part_.pause) {
    fault(SdramRule::kPause, {},
          fmt::format("a command {} after power-up; the pause is {} ns, {} clocks",
                      nanoseconds(now_), part_.pause / 1000, clocks_in(part_.pause)));
  }
  ask(SdramRule::kMrd, "tMRD", part_.mrd, mode_set_, "a command after the mode register was set",
      {});
  switch (command) {
    case Command::kMode:
      return set_mode(pins);
    case Command::kRefresh:
      return refresh();
    case Command::kPrecharge:
      return precharge(pins);
    case Command::kActivate:
      return activate(pins);
    case Command::kWrite:
      return access(pins, false);
    case Command::kRead:
      return access(pins, true);
    case Command::kTerminate:
      return end_burst();
    case Command::kNone:
      return;
  }
}

void SdramChip::set_mode(const SdramChipPins& pins) {
  check_idle("MODE REGISTER SET");
  if (!all_precharged_) {
    fault(SdramRule::kSetup, {}, "MODE REGISTER SET before all banks were precharged once");
  }
  const unsigned length = pins.address & 7;
  const unsigned latency = pins.address >> 4 & 7;
  const bool page = length == 7 && (pins.address & 8) == 0;
  if ((length > 3 && !page) || (latency != 2 && latency != 3) || (pins.address & 0x1d80) != 0 ||
      pins.bank != 0) {
    fault(SdramRule::kMode, {},
          fmt::format(
              "the mode register is set to {:#06x}, which the data sheet reserves; a burst is "
              "1, 2, 4 or 8 words or the page, the CAS latency 2 or 3",
              pins.bank << kSdramRowBits | pins.address));
    return;
  }
  const unsigned shortest = latency == 2 ? part_.clock_cas2 : part_.clock_cas3;
  if (clock_picoseconds_ < shortest) {
    fault(SdramRule::kMode, {},
          fmt::format("CAS latency {} with a clock of {} ns; it needs {} ns", latency,
                      clock_picoseconds_ / 1000., shortest / 1000.));
  }
  cas_latency_ = latency;
  burst_length_ = page ? 0 : 1u << length;
  interleaved_ = (pins.address & 8) != 0;
  single_writes_ = (pins.address & 0x200) != 0;
  has_mode_ = true;
  mode_set_ = now_;
  if (set_up_ == kNever) set_up_ = now_;
}

void SdramChip::refresh() {
  if (!all_precharged_) {
    fault(SdramRule::kSetup, {}, "REFRESH before all banks were precharged once");
  }
  check_idle("REFRESH");
  refreshed_ = now_;
  late_ = false;
  ++counters_.refreshes;
  if (!has_mode_ || first_refreshes_ < part_.first_refreshes) ++first_refreshes_;
  if (set_up_ != kNever) {
    refresh_clocks_[rows_refreshed_ % part_.refreshes] = now_;
    ++rows_refreshed_;
  }
}

void SdramChip::precharge(const SdramChipPins& pins) {
  const bool all = (pins.address >> 10 & 1) != 0;
  ++counters_.precharges;
  if (all) all_precharged_ = true;
  ask(SdramRule::kRfc, "tRFC", part_.rfc, refreshed_, "PRECHARGE after REFRESH", {});
  for (unsigned b = 0; b < kSdramBanks; ++b) {
    if ((!all && b != pins.bank) || !banks_[b].row) continue;
    ask(SdramRule::kRas, "tRAS", part_.ras, banks_[b].activated, "PRECHARGE after ACTIVATE", b);
    ask(SdramRule::kWr, "tWR", part_.wr, banks_[b].written, "PRECHARGE after the last word written",
        b);
    if (burst_ && burst_->bank == b) end_burst();
    close(b, now_);
  }
}

void SdramChip::activate(const SdramChipPins& pins) {
  Bank& bank = banks_[pins.bank];
  if (!is_set_up()) {
    fault(SdramRule::kSetup, pins.bank,
          fmt::format("ACTIVATE before the chip is set up; that takes a precharge of all banks, {} "
                      "refreshes and the mode register",
                      part_.first_refreshes));
  }
  if (bank.row) {
    fault(SdramRule::kOpenRow, pins.bank,
          fmt::format("ACTIVATE of row {}, but row {} is open; precharge the bank first",
                      pins.address, *bank.row));
  }
  ask(SdramRule::kRp, "tRP", part_.rp, bank.precharged, "ACTIVATE after PRECHARGE", pins.bank);
  ask(SdramRule::kRc, "tRC", part_.rc, bank.activated, "ACTIVATE after ACTIVATE of the same bank",
      pins.bank);
  ask(SdramRule::kRfc, "tRFC", part_.rfc, refreshed_, "ACTIVATE after REFRESH", pins.bank);
  ask(SdramRule::kRrd, "tRRD", part_.rrd, activated_, "ACTIVATE after ACTIVATE of another bank",
      pins.bank);
  bank.row = pins.address;
  bank.activated = activated_ = now_;
  bank.open_too_long = false;
  bank.closes = kNever;
  ++counters_.activations;
}

void SdramChip::access(const SdramChipPins& pins, bool reads) {
  Bank& bank = banks_[pins.bank];
  const char* name = reads ? "READ" : "WRITE";
  ++(reads ? counters_.reads : counters_.writes);
  end_burst();
  if (!bank.row || bank.closes != kNever) {
    fault(SdramRule::kClosedRow, pins.bank,
          fmt::format("{} while no row is open; activate one first", name));
    return;
  }
  const unsigned columns = 1u << part_.column_bits;
  const unsigned column = (pins.address & 0x3ff) | (pins.address >> 1 & 0xc00);
  if (column >= columns) {
    fault(SdramRule::kColumn, pins.bank,
          fmt::format("{} of column {}; the last one is {}", name, column, columns - 1));
  }
  ask(SdramRule::kRcd, "tRCD", part_.rcd, bank.activated, fmt::format("{} after ACTIVATE", name),
      pins.bank);
  const unsigned length = !reads && single_writes_ ? 1
                          : burst_length_ == 0     ? columns
                                                   : burst_length_;
  burst_ = Burst{
      reads, pins.bank, *bank.row, column % columns, 0, length, (pins.address >> 10 & 1) != 0};
}

void SdramChip::close(unsigned bank, Clock at) {
  banks_[bank].row.reset();
  banks_[bank].precharged = at;
  banks_[bank].closes = kNever;
}

void SdramChip::step_burst(const SdramChipPins& pins) {
  if (!burst_) return;
  Burst& b = *burst_;
  const unsigned length = burst_length_ == 0 ? 1u << part_.column_bits : burst_length_;
  const unsigned within = interleaved_ ? b.column ^ b.done : b.column + b.done;
  const unsigned column = (b.column & ~(length - 1)) | (within & (length - 1));
  if (b.reads) {
    coming_[(now_ + cas_latency_) % coming_.size()] = word(b.bank, b.row, column);
  } else {
    write_word(pins, b, column);
  }
  if (++b.done < b.length) return;
  if (b.closes) {
    Bank& bank = banks_[b.bank];
    bank.closes = std::max(b.reads ? now_ + 1 : now_ + clocks_in(part_.wr),
                           bank.activated + clocks_in(part_.ras));
  }
  // A page goes on until a command ends it.
  if (burst_length_ == 0 && b.length > 1) {
    b.done = 0;
  } else {
    burst_.reset();
  }
}

void SdramChip::write_word(const SdramChipPins& pins, const Burst& b, unsigned column) {
  std::uint16_t& cell = word(b.bank, b.row, column);
  banks_[b.bank].written = now_;
  ++counters_.words_written;
  if (pins.dqm == 3) return;
  if (!pins.dq) {
    fault(SdramRule::kNoData, b.bank,
          fmt::format("WRITE of row {}, column {}, but the controller does not drive the data pins",
                      b.row, column));
    return;
  }
  const unsigned kept = ((pins.dqm & 1) != 0 ? 0x00ff : 0) | ((pins.dqm & 2) != 0 ? 0xff00 : 0);
  cell = static_cast<std::uint16_t>((cell & kept) | (*pins.dq & ~kept));
}

/// A command cuts a burst short: no word comes a CAS latency later.
void SdramChip::end_burst() { burst_.reset(); }

void SdramChip::check_bus(const SdramChipPins& pins) {
  if (!pins.dq) return;
  if (driven_) {
    fault(SdramRule::kContention, {},
          "the controller and the chip both drive the data pins; write after the last word read");
  } else if (drove_) {
    fault(SdramRule::kTurnaround, {},
          "the controller drives the data pins in the clock after the chip did; let them float for "
          "one clock");
  }
}

void SdramChip::check_times() {
  for (unsigned b = 0; b < kSdramBanks; ++b) {
    Bank& bank = banks_[b];
    if (!bank.row || bank.open_too_long) continue;
    const Clock open = now_ - bank.activated;
    if (open * clock_picoseconds_ <= part_.ras_most) continue;
    bank.open_too_long = true;
    fault(
        SdramRule::kRasMost, b,
        fmt::format("row {} is open for {}; tRAS allows {} ns, {} clocks", *bank.row,
                    nanoseconds(open), part_.ras_most / 1000, part_.ras_most / clock_picoseconds_));
  }
  if (set_up_ == kNever || late_) return;
  const std::uint64_t time = (now_ - set_up_) * clock_picoseconds_;
  const std::uint64_t due = time / (part_.refresh_time / part_.refreshes);
  const Clock row = rows_refreshed_ < part_.refreshes
                        ? set_up_
                        : refresh_clocks_[rows_refreshed_ % part_.refreshes];
  if (due <= rows_refreshed_ + kMostLate &&
      (now_ - row) * clock_picoseconds_ <= part_.refresh_time) {
    return;
  }
  late_ = true;
  fault(SdramRule::kRefresh, {},
        fmt::format("{} refreshes in {}, and the next row has waited for {}; {} are due each {} ns",
                    rows_refreshed_, nanoseconds(now_ - set_up_), nanoseconds(now_ - row),
                    part_.refreshes, part_.refresh_time / 1000));
}

void SdramChip::check_idle(const char* what) {
  ask(SdramRule::kRfc, "tRFC", part_.rfc, refreshed_, fmt::format("{} after REFRESH", what), {});
  for (unsigned b = 0; b < kSdramBanks; ++b) {
    if (banks_[b].row) {
      fault(
          SdramRule::kOpenRow, b,
          fmt::format("{} while row {} is open; precharge all banks first", what, *banks_[b].row));
    }
    ask(SdramRule::kRp, "tRP", part_.rp, banks_[b].precharged,
        fmt::format("{} after PRECHARGE", what), b);
    ask(SdramRule::kRc, "tRC", part_.rc, banks_[b].activated,
        fmt::format("{} after ACTIVATE", what), b);
  }
}

void SdramChip::ask(SdramRule rule, const char* name, unsigned least, Clock from,
                    const std::string& what, std::optional<unsigned> bank) {
  if (from == kNever || (now_ - from) * clock_picoseconds_ >= least) return;
  fault(rule, bank,
        fmt::format("{} came after {}; {} is {} ns, {} clocks", what, nanoseconds(now_ - from),
                    name, least / 1000., clocks_in(least)));
}

void SdramChip::fault(SdramRule rule, std::optional<unsigned> bank, const std::string& text) {
  if (faults_.size() >= kMostFaults) return;
  const std::string where = bank ? fmt::format(", bank {}", *bank) : std::string{};
  faults_.push_back({rule, fmt::format("clock {}{}: {}", now_, where, text)});
}

std::string SdramChip::nanoseconds(std::uint64_t clocks) const {
  return fmt::format("{} ns ({} clocks)", static_cast<double>(clocks) * clock_picoseconds_ / 1000,
                     clocks);
}

}  // namespace dynrt::verif
