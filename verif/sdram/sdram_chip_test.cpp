// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The chip's model itself: it stores the data written, and each rule of the data sheet is broken
// once, in every speed grade, by one clock where the rule is a time.
#include "sdram/sdram_chip.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sdram/sdram_driver.h"

namespace dynrt::verif {
namespace {

constexpr SdramPart kParts[] = {kIs42s16160Grade6, kIs42s16160Grade7, kAs4c32m16Grade6,
                                kAs4c32m16Grade7, kAnySdram};

/// `act` on a chip that is set up breaks `rule`, says so with `words`, and breaks nothing else.
template <class Act>
void expect_fault(SdramRule rule, const std::string& words, Act act) {
  for (const SdramPart& part : kParts) {
    SdramDriver d(part);
    d.set_up();
    ASSERT_TRUE(d.chip().is_set_up());
    ASSERT_TRUE(d.chip().faults().empty()) << d.chip().faults()[0].text;
    act(d);
    ASSERT_EQ(d.chip().faults().size(), 1u)
        << (d.chip().faults().empty() ? "no fault" : d.chip().faults()[1].text);
    EXPECT_EQ(d.chip().faults()[0].rule, rule) << d.chip().faults()[0].text;
    EXPECT_NE(d.chip().faults()[0].text.find(words), std::string::npos)
        << d.chip().faults()[0].text;
  }
}
/// The same, and with one clock more nothing is wrong; `act` gets the clocks to wait.
template <class Act>
void expect_time(SdramRule rule, const std::string& name, unsigned SdramPart::* time, Act act) {
  expect_fault(rule, name, [&](SdramDriver& d) { act(d, d.clocks(d.part().*time) - 1); });
  for (const SdramPart& part : kParts) {
    SdramDriver d(part);
    d.set_up();
    act(d, d.clocks(part.*time));
    EXPECT_TRUE(d.chip().faults().empty()) << d.chip().faults()[0].text;
  }
}

TEST(SdramChip, KeepsWhatIsWritten) {
  for (const unsigned cas : {2u, 3u}) {
    SdramDriver d(kIs42s16160Grade7, 10'000, cas);
    d.set_up();
    d.open(2, 77);
    d.write(2, 8, 0x1111);
    d.data(0x2222);
    d.write(2, 10, 0x3333);
    d.data(0x4444, 2);  // the lower byte only
    d.chip().word(2, 77, 11);
    d.words();
    d.read(2, 8);
    d.none();
    d.read(2, 10);
    d.none(6);
    std::vector<int> expected(cas, -1);
    const int kept = (d.chip().word(2, 77, 11) & 0xff00) | 0x44;
    for (const int word : {0x1111, 0x2222, 0x3333, kept}) expected.push_back(word);
    expected.resize(9, -1);
    EXPECT_EQ(d.words(), expected) << "CAS latency " << cas;
    EXPECT_TRUE(d.chip().faults().empty()) << d.chip().faults()[0].text;
    EXPECT_EQ(d.chip().counters().reads, 2u);
    EXPECT_EQ(d.chip().counters().writes, 2u);
    EXPECT_EQ(d.chip().counters().busy(), 8u);
    EXPECT_EQ(d.chip().counters().activations, 1u);
  }
}

TEST(SdramChip, OrdersAndCutsBursts) {
  SdramDriver d(kIs42s16160Grade7);
  d.set_up(0b0010);  // four words, from within their block
  d.open(0, 0);
  for (unsigned i = 0; i < 8; ++i) d.chip().word(0, 0, i) = static_cast<std::uint16_t>(i);
  d.words();
  d.read(0, 2);
  d.none(8);
  EXPECT_EQ(d.words(), (std::vector{-1, -1, -1, 2, 3, 0, 1, -1, -1}));
  d.read(0, 0);
  d.read(0, 4);
  d.none();
  d.terminate();
  d.none(5);
  EXPECT_EQ(d.words(), (std::vector{-1, -1, -1, 0, 4, 5, -1, -1, -1}));
  d.read(0, 0);
  d.none();
  d.mask_next(3);
  d.none(6);
  EXPECT_EQ(d.words(), (std::vector{-1, -1, -1, 0, -1, 2, 3, -1}));
  EXPECT_TRUE(d.chip().faults().empty()) << d.chip().faults()[0].text;
}

TEST(SdramChip, ClosesARowByItself) {
  expect_time(SdramRule::kRp, "tRP", &SdramPart::rp, [](SdramDriver& d, unsigned clocks) {
    d.open(1, 3);
    d.none(d.clocks(d.part().rc));
    d.read(1, 0, true);
    d.none(1 + clocks);  // it begins after the burst
    d.activate(1, 4);
  });
  expect_fault(SdramRule::kClosedRow, "READ", [](SdramDriver& d) {
    d.open(1, 3);
    d.write(1, 0, 1, true);
    d.data(2);
    d.read(1, 2);
  });
}

TEST(SdramChip, AsksForThePauseAndTheSetup) {
  for (const SdramPart& part : kParts) {
    SdramDriver early(part);
    early.none(SdramDriver::kPauseClocks - 1);
    early.precharge_all();
    ASSERT_EQ(early.chip().faults().size(), 1u);
    EXPECT_EQ(early.chip().faults()[0].rule, SdramRule::kPause);

    SdramDriver open(part);
    open.none(SdramDriver::kPauseClocks);
    open.refresh();
    ASSERT_EQ(open.chip().faults().size(), 1u);
    EXPECT_EQ(open.chip().faults()[0].rule, SdramRule::kSetup);

    SdramDriver mode(part);
    mode.none(SdramDriver::kPauseClocks);
    mode.mode(0x31);
    ASSERT_EQ(mode.chip().faults().size(), 1u);
    EXPECT_EQ(mode.chip().faults()[0].rule, SdramRule::kSetup);

    SdramDriver few(part);
    few.none(SdramDriver::kPauseClocks);
    few.precharge_all();
    few.none(2);
    for (unsigned i = 0; i + 1 < part.first_refreshes; ++i) {
      few.refresh();
      few.none(few.clocks(part.rfc) - 1);
    }
    few.mode(0x31);
    few.none(10);
    few.activate(0, 0);
    ASSERT_EQ(few.chip().faults().size(), 1u) << few.chip().faults()[0].text;
    EXPECT_EQ(few.chip().faults()[0].rule, SdramRule::kSetup);
  }
}

TEST(SdramChip, RefusesModesThatThereAreNot) {
  for (const unsigned mode : {0x34u, 0x41u, 0x11u, 0x3fu, 0xb1u}) {
    expect_fault(SdramRule::kMode, "reserves", [mode](SdramDriver& d) { d.mode(mode); });
  }
  expect_fault(SdramRule::kMode, "CAS latency 2", [](SdramDriver& d) { d.mode(0x21); });
}

TEST(SdramChip, RefusesRowsThatAreClosedOrOpen) {
  expect_fault(SdramRule::kClosedRow, "READ", [](SdramDriver& d) { d.read(0, 0); });
  expect_fault(SdramRule::kClosedRow, "WRITE", [](SdramDriver& d) {
    d.open(0, 5);
    d.write(1, 0, 0);
  });
  expect_fault(SdramRule::kOpenRow, "row 5 is open", [](SdramDriver& d) {
    d.open(0, 5);
    d.none(10);
    d.activate(0, 6);
  });
  expect_fault(SdramRule::kOpenRow, "REFRESH", [](SdramDriver& d) {
    d.open(0, 5);
    d.none(10);
    d.refresh();
  });
  SdramDriver d(kIs42s16160Grade7);
  d.set_up();
  d.open(0, 5);
  d.read(0, 512);
  ASSERT_EQ(d.chip().faults().size(), 1u);
  EXPECT_EQ(d.chip().faults()[0].rule, SdramRule::kColumn);
}

TEST(SdramChip, KeepsEachTime) {
  expect_time(SdramRule::kRcd, "tRCD", &SdramPart::rcd, [](SdramDriver& d, unsigned clocks) {
    d.activate(3, 9);
    d.none(clocks - 1);
    d.read(3, 0);
  });
  expect_time(SdramRule::kRp, "tRP", &SdramPart::rp, [](SdramDriver& d, unsigned clocks) {
    d.open(3, 9);
    d.none(20);
    d.precharge(3);
    d.none(clocks - 1);
    d.activate(3, 8);
  });
  expect_time(SdramRule::kRas, "tRAS", &SdramPart::ras, [](SdramDriver& d, unsigned clocks) {
    d.activate(3, 9);
    d.none(clocks - 1);
    d.precharge_all();
  });
  expect_time(SdramRule::kRrd, "tRRD", &SdramPart::rrd, [](SdramDriver& d, unsigned clocks) {
    d.activate(0, 9);
    d.none(clocks - 1);
    d.activate(1, 9);
  });
  expect_time(SdramRule::kWr, "tWR", &SdramPart::wr, [](SdramDriver& d, unsigned clocks) {
    d.open(0, 9);
    d.none(10);
    d.write(0, 0, 1);
    d.data(2);
    d.none(clocks - 1);
    d.precharge(0);
  });
  expect_time(SdramRule::kMrd, "tMRD", &SdramPart::mrd, [](SdramDriver& d, unsigned clocks) {
    d.mode(0x31);
    d.none(clocks - 1);
    d.activate(0, 0);
  });
  expect_time(SdramRule::kRfc, "tRFC", &SdramPart::rfc, [](SdramDriver& d, unsigned clocks) {
    d.refresh();
    d.none(clocks - 1);
    d.activate(0, 0);
  });
}

TEST(SdramChip, KeepsTheCycleOfARow) {
  // In most grades tRC is tRAS and tRP, so a longer one is asked for alone.
  SdramPart part = kAs4c32m16Grade7;
  part.rc = 90'000;
  for (const unsigned less : {1u, 0u}) {
    SdramDriver d(part);
    d.set_up();
    const unsigned ras = d.clocks(part.ras);
    d.activate(0, 1);
    d.none(ras - 1);
    d.precharge(0);
    d.none(d.clocks(part.rc) - ras - 1 - less);
    d.activate(0, 2);
    ASSERT_EQ(d.chip().faults().size(), less);
    if (less != 0) EXPECT_EQ(d.chip().faults()[0].rule, SdramRule::kRc);
  }
}

TEST(SdramChip, SaysHowLongItWasAndHasToBe) {
  SdramDriver d(kAs4c32m16Grade7);
  d.set_up();
  const std::uint64_t before = d.chip().counters().clocks;
  d.activate(2, 9);
  d.none();
  d.read(2, 0);
  ASSERT_EQ(d.chip().faults().size(), 1u);
  EXPECT_NE(before, 0u);
  EXPECT_NE(
      d.chip().faults()[0].text.find(
          ", bank 2: READ after ACTIVATE came after 15 ns (2 clocks); tRCD is 21 ns, 3 clocks"),
      std::string::npos)
      << d.chip().faults()[0].text;
}

TEST(SdramChip, LetsNoRowStayOpen) {
  for (const SdramPart& part : kParts) {
    SdramDriver d(part);
    d.set_up();
    d.activate(0, 1);
    const unsigned most = part.ras_most / 7'500;
    for (unsigned i = 0; i < most; ++i) d.none();
    for (const SdramFault& f : d.chip().faults()) EXPECT_EQ(f.rule, SdramRule::kRefresh);
    const std::size_t before = d.chip().faults().size();
    d.none(2);
    ASSERT_EQ(d.chip().faults().size(), before + 1);
    EXPECT_EQ(d.chip().faults().back().rule, SdramRule::kRasMost);
  }
}

TEST(SdramChip, AsksForRefreshesInTime) {
  const SdramPart part = kIs42s16160Grade7;
  const unsigned interval = static_cast<unsigned>(part.refresh_time / part.refreshes / 7'500);
  SdramDriver late(part);
  late.set_up();
  late.none((SdramChip::kMostLate + 1) * interval);
  EXPECT_TRUE(late.chip().faults().empty());
  late.none(interval);
  ASSERT_EQ(late.chip().faults().size(), 1u);
  EXPECT_EQ(late.chip().faults()[0].rule, SdramRule::kRefresh);

  // All rows early, and then none for as long as a row keeps.
  SdramPart small = part;
  small.refreshes = 16;
  small.refresh_time /= 512;
  SdramDriver burst(small);
  burst.set_up();
  for (unsigned i = 0; i < 40; ++i) {
    burst.refresh();
    burst.none(9);
  }
  burst.none(15 * interval - 400);
  EXPECT_TRUE(burst.chip().faults().empty());
  burst.none(2 * interval + 400);
  ASSERT_EQ(burst.chip().faults().size(), 1u);
  EXPECT_EQ(burst.chip().faults()[0].rule, SdramRule::kRefresh);
}

TEST(SdramChip, WatchesTheDataPins) {
  expect_fault(SdramRule::kContention, "both drive", [](SdramDriver& d) {
    d.open(0, 1);
    d.read(0, 0);
    d.none(3);
    d.data(1);
  });
  expect_fault(SdramRule::kTurnaround, "for one clock", [](SdramDriver& d) {
    d.open(0, 1);
    d.read(0, 0);
    d.none(4);
    d.data(1);
  });
  expect_fault(SdramRule::kNoData, "does not drive", [](SdramDriver& d) {
    d.open(0, 1);
    d.write(0, 0, 1);
    d.none();
  });
  expect_fault(SdramRule::kClockEnable, "CKE", [](SdramDriver& d) {
    d.stop_clock_enable();
    d.none();
  });
}

TEST(SdramChip, HasNoPlaceBeyondItsLast) {
  SdramChip chip(kIs42s16160Grade7, 7'500);
  chip.word(3, 8191, 511) = 1;
  EXPECT_THROW(chip.word(4, 0, 0), std::out_of_range);
  EXPECT_THROW(chip.word(0, 8192, 0), std::out_of_range);
  EXPECT_THROW(chip.word(0, 0, 512), std::out_of_range);
}

}  // namespace
}  // namespace dynrt::verif
