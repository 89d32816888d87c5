// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The way from an FPGA to an SDRAM chip and back: each time kept and missed by a picosecond, and
// the delays of the chip's clock with which a board works.
#include "sdram/sdram_pin_timing.h"

#include <gtest/gtest.h>

namespace dynrt::verif {
namespace {

using Ps = SdramPinTiming::Ps;

const SdramChipPins kRead{.cas_n = false};

std::string fault_of_pins(Ps changed, Ps clock) {
  SdramPinTiming pins(kAnySdram, 2);
  pins.drive(changed, kRead);
  pins.clock(clock, {});
  return pins.fault();
}

TEST(SdramPinTiming, PinsAreThereBeforeTheClock) {
  EXPECT_EQ(fault_of_pins(10'000, 12'000), "");
  EXPECT_EQ(
      fault_of_pins(10'001, 12'000),
      "pins change 1999 ps before an edge of its clock; tIS is 1500 ps, and pins may differ by "
      "500");
}

TEST(SdramPinTiming, PinsStayBehindTheClock) {
  const auto fault = [](Ps change) {
    SdramPinTiming pins(kAnySdram, 2);
    pins.clock(20'000, {});
    pins.drive(change, kRead);
    return pins.fault();
  };
  EXPECT_EQ(fault(21'300), "");
  EXPECT_EQ(
      fault(21'299),
      "pins change 1299 ps behind an edge of its clock; tIH is 800 ps, and pins may differ by "
      "500");
}

TEST(SdramPinTiming, AWordIsThereForSoLong) {
  SdramPinTiming pins(kAnySdram, 2);
  pins.clock(100'000, 7);
  pins.clock(110'000, 8);
  EXPECT_EQ(pins.word_before(111'000), SdramPinTiming::kUnknown) << "4 ns of way, tAC, 1 ns";
  EXPECT_EQ(pins.word_before(111'001), 7);
  EXPECT_EQ(pins.word_before(113'800), 7) << "2.5 ns of way, tOH, less 1.2 ns";
  EXPECT_EQ(pins.word_before(113'801), SdramPinTiming::kUnknown);
  EXPECT_EQ(pins.word_before(121'001), 8);
}

/// Whether a controller and a chip understand each other, if the chip's clock is so much later than
/// the controller's.
bool works(Ps clock, Ps late, unsigned cas_latency = 2) {
  SdramPinTiming pins(kAnySdram, cas_latency);
  for (unsigned i = 0; i < 10; ++i) {
    const Ps edge = (i + 10) * clock;
    if (i >= 2 && pins.word_before(edge) != i - 2) return false;
    pins.drive(edge, {.address = i});
    pins.clock(edge + late, static_cast<std::uint16_t>(i));
  }
  return pins.fault().empty();
}

TEST(SdramPinTiming, TheChipsClockIsThreeQuartersOfAPeriodLate) {
  EXPECT_TRUE(works(10'000, 7'500)) << "the ULX3S";
  EXPECT_FALSE(works(10'000, 5'000)) << "the next word comes too early";
  EXPECT_FALSE(works(10'000, 6'199));
  EXPECT_TRUE(works(10'000, 6'200));
  EXPECT_TRUE(works(10'000, 8'700));
  EXPECT_FALSE(works(10'000, 8'701)) << "a command does not stay long enough";
  EXPECT_TRUE(works(12'000, 9'000));
  EXPECT_FALSE(works(14'000, 7'000));
  EXPECT_FALSE(works(7'500, 5'625));
  EXPECT_FALSE(works(7'500, 4'200)) << "that takes a CAS latency of 3";
  EXPECT_TRUE(works(7'500, 4'200, 3));
}

}  // namespace
}  // namespace dynrt::verif
