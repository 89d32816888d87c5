// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// SDR SDRAMs of 16 data bits, four banks and 8192 rows: the figures of their data sheets, one
// constant a speed grade, and what a controller for all of them has to keep. Times are in
// picoseconds. The controller (units/sdram_controller.h) counts its clocks from them, and the
// model of the chip (verif/sdram) checks them.
#pragma once

#include <algorithm>

namespace dynrt {

struct SdramPart {
  unsigned column_bits;
  unsigned clock_cas2;  ///< tCK, the shortest clock period at CAS latency 2
  unsigned clock_cas3;  ///< and at 3
  unsigned rcd;         ///< tRCD: activate to read or write
  unsigned rp;          ///< tRP: precharge to activate, refresh or mode register
  unsigned ras;         ///< tRAS: activate to precharge, at least
  unsigned ras_most;    ///< and at most
  unsigned rc;          ///< tRC: activate to activate, same bank
  unsigned rrd;         ///< tRRD: activate to activate, other bank
  unsigned wr;          ///< tWR, also called tDPL: last data written to precharge
  unsigned mrd;         ///< tMRD: mode register to any command
  unsigned rfc;         ///< tRFC: refresh to activate or refresh

  unsigned access_cas2 = 6'000;  ///< tAC: from the clock's edge to a word, at CAS latency 2
  unsigned access_cas3 = 5'400;  ///< and at 3
  unsigned hold = 2'500;         ///< tOH: from the next edge on until the word may change
  unsigned set_up_in = 1'500;    ///< tIS of commands, addresses and words, before the clock's edge
  unsigned hold_in = 800;        ///< tIH, behind it

  unsigned pause = 200'000'000;  ///< from power and clock to the first command
  unsigned first_refreshes = 8;  ///< before the first access; 2 to 8, as the sheets' editions
  unsigned refreshes = 8192;     ///< in each `refresh_time`
  unsigned long long refresh_time = 64'000'000'000;
};
inline constexpr unsigned kSdramBanks = 4;
inline constexpr unsigned kSdramRowBits = 13;

/// ISSI IS42S16160, 32 MB: AC Electrical Characteristics, grades -6 and -7. The sheet gives one
/// figure for tRC and tRFC.
inline constexpr SdramPart kIs42s16160Grade6{9,           10'000, 6'000,  18'000, 18'000, 42'000,
                                             100'000'000, 60'000, 12'000, 12'000, 12'000, 60'000};
inline constexpr SdramPart kIs42s16160Grade7{9,           10'000, 7'000,  15'000, 15'000, 37'000,
                                             100'000'000, 60'000, 14'000, 14'000, 14'000, 60'000};
/// Alliance AS4C32M16SB, 64 MB: Table 16, grades -6 and -7. Table 16 of AS4C16M16SA, 32 MB, has the
/// same figures. The defaults above are of these tables, of grade -7 where grades differ; the parts
/// of ISSI are taken to have the same.
inline constexpr SdramPart kAs4c32m16Grade6{10,          10'000, 6'000,  18'000, 18'000, 42'000,
                                            120'000'000, 60'000, 12'000, 12'000, 12'000, 60'000};
inline constexpr SdramPart kAs4c32m16Grade7{10,          10'000, 7'000,  21'000, 21'000, 42'000,
                                            120'000'000, 63'000, 14'000, 14'000, 14'000, 63'000};

/// What both parts allow.
constexpr SdramPart stricter(SdramPart a, const SdramPart& b) {
  a.column_bits = std::min(a.column_bits, b.column_bits);
  a.ras_most = std::min(a.ras_most, b.ras_most);
  a.refresh_time = std::min(a.refresh_time, b.refresh_time);
  a.hold = std::min(a.hold, b.hold);
  for (const auto field :
       {&SdramPart::clock_cas2, &SdramPart::clock_cas3, &SdramPart::rcd, &SdramPart::rp,
        &SdramPart::ras, &SdramPart::rc, &SdramPart::rrd, &SdramPart::wr, &SdramPart::mrd,
        &SdramPart::rfc, &SdramPart::pause, &SdramPart::first_refreshes, &SdramPart::refreshes,
        &SdramPart::access_cas2, &SdramPart::access_cas3, &SdramPart::set_up_in,
        &SdramPart::hold_in}) {
    a.*field = std::max(a.*field, b.*field);
  }
  return a;
}
/// A board may carry any of them.
inline constexpr SdramPart kAnySdram = stricter(stricter(kIs42s16160Grade6, kIs42s16160Grade7),
                                                stricter(kAs4c32m16Grade6, kAs4c32m16Grade7));

/// Clocks that a time takes, rounded up.
constexpr unsigned clocks_of(unsigned picoseconds, unsigned clock_picoseconds) {
  return (picoseconds + clock_picoseconds - 1) / clock_picoseconds;
}

}  // namespace dynrt
