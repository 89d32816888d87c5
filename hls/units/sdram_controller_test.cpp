// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The controller's commands in their order. Whether they keep the times of a chip's data sheet is
// tested with the chip's model (verif/sdram).
#include "units/sdram_controller.h"

#include <optional>
#include <vector>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using S = Sdram133;
using T = SdramTiming<S>;

constexpr unsigned kPause = 10;

class SdramControllerTest : public testing::Test {
 protected:
  struct Seen {
    unsigned clock;
    SdramPins pins;
  };
  SdramControllerTest() { bench_.value(bench_.unit.pause) = uint<16>::from(kPause); }

  /// Clocks of which the first has a burst, or none has; gives those with a command.
  std::vector<Seen> run(unsigned clocks, std::optional<SdramBurst> burst = {}) {
    for (unsigned i = 0; i < clocks; ++i) {
      SdramRequest request;
      if (i == 0 && burst) request = {.valid = true, .burst = *burst};
      bench_.feed(bench_.unit.request, request);
    }
    bench_.run();
    std::vector<Seen> seen;
    for (const SdramPins& pins : bench_.take(bench_.unit.pins)) {
      taken_ += static_cast<unsigned>(pins.taken.to_u64());
      if (pins.command != SdramCommand::kNone) seen.push_back({clock_, pins});
      ++clock_;
    }
    return seen;
  }
  /// Until a burst may come, in the first clock of a turn; then its refreshes are far.
  void set_up() {
    run(2 * (kPause + 100));
    clock_ = 0;
  }
  static SdramBurst burst(unsigned bank, unsigned row, unsigned pair, unsigned pairs, bool write,
                          unsigned tag = 0) {
    return {.place = {.pair = uint<8>::from(pair),
                      .bank = uint<2>::from(bank),
                      .row = uint<13>::from(row)},
            .last = uint<3>::from(pairs - 1),
            .write = write,
            .tag = uint<5>::from(tag)};
  }
  static std::vector<SdramCommand> commands(const std::vector<Seen>& seen) {
    std::vector<SdramCommand> commands;
    for (const Seen& s : seen) commands.push_back(s.pins.command);
    return commands;
  }

  test::UnitBench<SdramController<S>> bench_;
  unsigned clock_ = 0;
  unsigned taken_ = 0;
};

TEST_F(SdramControllerTest, SetsTheChipUp) {
  const std::vector<Seen> seen = run(2 * (kPause + 100));
  std::vector expected(10, SdramCommand::kRefresh);
  expected.front() = SdramCommand::kPrecharge;
  expected.back() = SdramCommand::kMode;
  ASSERT_EQ(commands(seen), expected);
  EXPECT_GE(seen.front().clock, 2 * kPause);
  EXPECT_LE(seen.front().clock, 2 * kPause + 4);
  EXPECT_EQ(seen.front().pins.address, uint<13>(1 << 10)) << "all banks";
  EXPECT_EQ(seen.back().pins.address, uint<13>(0x31)) << "CAS latency 3, bursts of 2";
  EXPECT_FALSE(seen[8].pins.ready);
}

TEST_F(SdramControllerTest, TellsWhatTheDataPinsDo) {
  set_up();
  bench_.feed(bench_.unit.request, {.valid = true, .burst = burst(2, 5, 6, 2, true, 19)});
  for (unsigned i = 0; i < 30; ++i) bench_.feed(bench_.unit.request, {});
  bench_.run();
  std::vector<SdramPins> words;
  for (const SdramPins& pins : bench_.take(bench_.unit.pins)) {
    EXPECT_TRUE(pins.ready);
    EXPECT_FALSE(pins.reads);
    if (pins.writes) words.push_back(pins);
  }
  ASSERT_EQ(words.size(), 4u);
  for (unsigned i = 0; i < 4; ++i) {
    EXPECT_EQ(words[i].word, uint<4>::from(12 + i));
    EXPECT_EQ(words[i].last, i == 3);
    EXPECT_EQ(words[i].tag, uint<5>(19));
    EXPECT_EQ(words[i].command, i % 2 == 0 ? SdramCommand::kWrite : SdramCommand::kNone);
  }
  EXPECT_EQ(words[0].address, uint<13>(12));
}

TEST_F(SdramControllerTest, OpensARowOnce) {
  set_up();
  EXPECT_EQ(commands(run(40, burst(1, 7, 0, 1, false))),
            (std::vector{SdramCommand::kActivate, SdramCommand::kRead}));
  EXPECT_EQ(commands(run(40, burst(1, 7, 9, 2, true))),
            (std::vector{SdramCommand::kWrite, SdramCommand::kWrite}));
  EXPECT_EQ(commands(run(40, burst(1, 8, 0, 1, false))),
            (std::vector{SdramCommand::kPrecharge, SdramCommand::kActivate, SdramCommand::kRead}));
  EXPECT_EQ(taken_, 3u);
}

TEST_F(SdramControllerTest, OpensTheNextRowWhileWordsMove) {
  set_up();
  for (unsigned bank = 0; bank < 4; ++bank) {
    bench_.feed(bench_.unit.request, {.valid = true, .burst = burst(bank, 9, 0, 8, false)});
  }
  std::vector<unsigned> reads;
  for (const Seen& s : run(100)) {
    if (s.pins.command == SdramCommand::kRead) reads.push_back(s.clock);
  }
  ASSERT_EQ(reads.size(), 32u);
  EXPECT_EQ(reads.back() - reads.front(), 62u) << "column commands every two clocks";
}

TEST_F(SdramControllerTest, ABankWithoutItsRowHoldsUpNoOther) {
  set_up();
  // The tags of bursts that come one after another, in the order in which pairs move.
  const auto order = [this](const std::vector<SdramBurst>& bursts) {
    for (const SdramBurst& b : bursts)
      bench_.feed(bench_.unit.request, {.valid = true, .burst = b});
    std::vector<unsigned> tags;
    for (const Seen& s : run(200)) {
      const bool column =
          s.pins.command == SdramCommand::kRead || s.pins.command == SdramCommand::kWrite;
      if (column) tags.push_back(static_cast<unsigned>(s.pins.tag.to_u64()));
    }
    return tags;
  };
  EXPECT_EQ(order({burst(0, 1, 0, 1, false, 1), burst(0, 2, 0, 1, false, 2),
                   burst(0, 2, 1, 1, false, 3), burst(1, 7, 0, 1, false, 4)}),
            (std::vector<unsigned>{1, 4, 2, 3}));
}

TEST_F(SdramControllerTest, RefreshesInTimeUnderLoad) {
  set_up();
  unsigned refreshes = 0;
  unsigned pairs = 0;
  constexpr unsigned kRounds = 2000;
  for (unsigned i = 0; i < kRounds; ++i) {
    for (const Seen& s : run(18, burst(i, i * 7, 0, 8, i % 5 == 0))) {
      if (s.pins.command == SdramCommand::kRefresh) ++refreshes;
      if (s.pins.command == SdramCommand::kRead || s.pins.command == SdramCommand::kWrite) ++pairs;
    }
    ASSERT_LE(i + 1 - taken_, kSdramQueue);
  }
  run(500);
  EXPECT_EQ(taken_, kRounds) << "each is told once";
  EXPECT_NEAR(refreshes, kRounds * 9 / T::kRefreshTurns, 1);
  EXPECT_GT(pairs, kRounds * 7);
}

}  // namespace
}  // namespace dynrt
