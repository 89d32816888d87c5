// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clocks of an SDRAM controller, at compile time from a part's times and the clock period. The
// controller has two clocks a turn: in the first it may give a column command, in the second a row
// command. A rule of so many clocks between two commands thus costs so many turns.
#pragma once

#include "units/sdram_parts.h"

namespace dynrt {

/// A part, a clock and a CAS latency: the template argument of the controller.
struct Sdram133 {
  static constexpr SdramPart kPart = kAnySdram;
  static constexpr unsigned kClockPicoseconds = 7'500;
  static constexpr unsigned kCasLatency = 3;
};
/// That of the ULX3S (rtl/ulx3s/ulx3s_clocks.v).
struct Sdram100 {
  static constexpr SdramPart kPart = kAnySdram;
  static constexpr unsigned kClockPicoseconds = 10'000;
  static constexpr unsigned kCasLatency = 2;
};

/// Words of 16 bits that a column command moves: the burst length in the mode register.
inline constexpr unsigned kSdramBurst = 2;

template <class S>
struct SdramTiming {
  static constexpr SdramPart kPart = S::kPart;
  static_assert(S::kCasLatency == 2 || S::kCasLatency == 3);
  static_assert(S::kClockPicoseconds >= (S::kCasLatency == 2 ? kPart.clock_cas2 : kPart.clock_cas3),
                "the part is too slow for this clock at this CAS latency");

  /// Turns that a command has to let pass after another one `least` clocks before it, which is the
  /// first that is possible `first` clocks after it.
  static constexpr unsigned turns(unsigned least, unsigned first) {
    return least <= first ? 0 : (least - first + 1) / 2;
  }
  static constexpr unsigned clocks(unsigned picoseconds) {
    return clocks_of(picoseconds, S::kClockPicoseconds);
  }
  // From a row command to the next column command is one clock, as from a column command to the
  // next row command.
  static constexpr unsigned kActivateToColumn = turns(clocks(kPart.rcd), 1);
  static constexpr unsigned kPrechargeToActivate = turns(clocks(kPart.rp), 2);
  static constexpr unsigned kActivateToPrecharge = turns(clocks(kPart.ras), 2);
  static constexpr unsigned kActivateToActivate = turns(clocks(kPart.rc), 2);
  static constexpr unsigned kRefreshToActivate = turns(clocks(kPart.rfc), 2);
  static constexpr unsigned kModeToActivate = turns(clocks(kPart.mrd), 2);
  static_assert(clocks(kPart.rrd) <= 2, "activates come every two clocks");
  /// A precharge earlier than that would cut off the last word.
  static constexpr unsigned kReadToPrecharge = turns(kSdramBurst, 1);
  static constexpr unsigned kWriteToPrecharge = turns(kSdramBurst - 1 + clocks(kPart.wr), 1);
  /// The bus stands idle for a clock between the chip's last word and the controller's first.
  static constexpr unsigned kReadToWrite = turns(S::kCasLatency + kSdramBurst + 1, 2);

  /// Turns between two refreshes: rounded down by so much that one which waits for a burst is in
  /// time.
  static constexpr unsigned kLongestWait = 128;  ///< clocks
  static constexpr unsigned kRefreshTurns = static_cast<unsigned>(
      (kPart.refresh_time / S::kClockPicoseconds - kLongestWait) / kPart.refreshes / 2);
  static_assert(2ull * kRefreshTurns * S::kClockPicoseconds < kPart.ras_most);
  /// Clocks of the pause before the first command.
  static constexpr unsigned kPauseTurns = (clocks(kPart.pause) + 1) / 2;
  /// Sequential bursts, reads and writes alike.
  static constexpr unsigned kModeRegister = S::kCasLatency << 4 | 0b001;
};

}  // namespace dynrt
