// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A model of an SDR SDRAM chip at its pins, a clock at a time. It refuses what the data sheet
// forbids (units/sdram_parts.h has its figures) in sentences that name the rule, the clock and the
// bank, how long it was and how long it has to be; and it counts what it saw. It knows all of the
// chip's commands but power-down and self refresh.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "units/sdram_parts.h"

namespace dynrt::verif {

/// What the controller drives, held until the clock's edge.
struct SdramChipPins {
  bool cke = true;
  bool cs_n = false;
  bool ras_n = true;
  bool cas_n = true;
  bool we_n = true;
  unsigned bank = 0;
  unsigned address = 0;
  unsigned dqm = 0;  ///< bit 1: the upper byte
  std::optional<std::uint16_t> dq = {};
  bool operator==(const SdramChipPins&) const = default;
};

enum class SdramRule {
  kPause,      ///< no command in the pause after power-up
  kSetup,      ///< precharge, refreshes and mode register before the first access
  kMode,       ///< a mode that there is, for this clock, with all banks closed
  kClosedRow,  ///< read or write of a bank without an open row
  kOpenRow,    ///< activate of a bank with an open row, refresh or mode register with one
  kColumn,     ///< a column that there is
  kRcd,
  kRp,
  kRas,
  kRasMost,
  kRc,
  kRrd,
  kWr,
  kMrd,
  kRfc,
  kRefresh,      ///< each row in time
  kContention,   ///< both drive the data pins
  kTurnaround,   ///< a clock between the chip's last word and the controller's first
  kNoData,       ///< a write whose data pins nobody drives
  kClockEnable,  ///< CKE stays high
};

struct SdramFault {
  SdramRule rule;
  std::string text;
};

struct SdramCounters {
  std::uint64_t clocks = 0;  ///< since the chip was set up
  std::uint64_t activations = 0;
  std::uint64_t precharges = 0;  ///< of one bank or of all
  std::uint64_t reads = 0;       ///< commands
  std::uint64_t writes = 0;
  std::uint64_t refreshes = 0;
  std::uint64_t words_read = 0;
  std::uint64_t words_written = 0;                                   ///< masked ones too
  std::uint64_t busy() const { return words_read + words_written; }  ///< clocks of the data pins
};

class SdramChip {
 public:
  /// Refreshes that may be late at once. The data sheet only asks for all rows in time; this finds
  /// a controller that falls behind without 64 ms of simulation.
  static constexpr unsigned kMostLate = 8;
  static constexpr std::size_t kMostFaults = 100;  ///< that are kept

  SdramChip(const SdramPart& part, unsigned clock_picoseconds);

  /// What the chip drives until the next edge.
  std::optional<std::uint16_t> dq() const { return driven_; }
  /// A rising edge of the clock.
  void clock(const SdramChipPins& pins);

  /// The contents, by the back door.
  std::uint16_t& word(unsigned bank, unsigned row, unsigned column);

  const std::vector<SdramFault>& faults() const { return faults_; }
  const SdramCounters& counters() const { return counters_; }
  /// Since set-up; a count starts anew.
  void clear_counters() { counters_ = {}; }
  bool is_set_up() const { return has_mode_ && first_refreshes_ >= part_.first_refreshes; }

 private:
  using Clock = std::uint64_t;
  static constexpr Clock kNever = ~Clock{0};
  struct Bank {
    std::optional<unsigned> row;
    Clock activated = kNever;
    Clock precharged = kNever;
    Clock written = kNever;      ///< last word
    Clock closes = kNever;       ///< by auto precharge
    bool open_too_long = false;  ///< has been told
  };
  struct Burst {
    bool reads = false;
    unsigned bank = 0;
    unsigned row = 0;
    unsigned column = 0;  ///< of the command
    unsigned done = 0;
    unsigned length = 0;
    bool closes = false;  ///< auto precharge
  };
  enum class Command { kNone, kMode, kRefresh, kPrecharge, kActivate, kWrite, kRead, kTerminate };
  static Command command_of(const SdramChipPins& pins);

  void run(Command command, const SdramChipPins& pins);
  void set_mode(const SdramChipPins& pins);
  void refresh();
  void precharge(const SdramChipPins& pins);
  void activate(const SdramChipPins& pins);
  void access(const SdramChipPins& pins, bool reads);
  void close(unsigned bank, Clock at);
  void step_burst(const SdramChipPins& pins);
  void write_word(const SdramChipPins& pins, const Burst& burst, unsigned column);
  void end_burst();
  void check_bus(const SdramChipPins& pins);
  void check_times();
  void check_idle(const char* what);

  /// A fault unless `least` picoseconds have gone by since clock `from`.
  void ask(SdramRule rule, const char* name, unsigned least, Clock from, const std::string& what,
           std::optional<unsigned> bank);
  void fault(SdramRule rule, std::optional<unsigned> bank, const std::string& text);
  std::string nanoseconds(std::uint64_t clocks) const;
  std::uint64_t clocks_in(std::uint64_t picoseconds) const {
    return (picoseconds + clock_picoseconds_ - 1) / clock_picoseconds_;
  }

  SdramPart part_;
  unsigned clock_picoseconds_;
  Clock now_ = 0;
  std::array<Bank, kSdramBanks> banks_;
  std::vector<std::vector<std::uint16_t>> rows_;  ///< empty until one of its words is looked at

  bool all_precharged_ = false;
  unsigned first_refreshes_ = 0;
  bool has_mode_ = false;
  unsigned cas_latency_ = 3;
  unsigned burst_length_ = 1;  ///< 0: the page
  bool interleaved_ = false;
  bool single_writes_ = false;
  Clock mode_set_ = kNever;
  Clock refreshed_ = kNever;
  Clock activated_ = kNever;  ///< any bank

  std::optional<Burst> burst_;
  std::array<std::optional<std::uint16_t>, 8> coming_;  ///< by the clock that they are there
  std::optional<std::uint16_t> driven_;
  bool drove_ = false;
  unsigned last_dqm_ = 0;

  std::vector<Clock> refresh_clocks_;  ///< of the rows
  std::uint64_t rows_refreshed_ = 0;
  Clock set_up_ = kNever;
  bool late_ = false;  ///< has been told

  SdramCounters counters_;
  std::vector<SdramFault> faults_;
};

}  // namespace dynrt::verif
