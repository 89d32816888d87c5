// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board's Verilog around the stand-in core of test/dynrt_core.v: its registers, the window into
// the SRAM, the interrupt and the time-out.
#include "host/board/rtl_board.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "host/board/registers.h"
#include "host/board/sram.h"
#include "host/board/test/named.h"
#include "host/error.h"
#include "host/format/frame_words.h"
#include "units/start.h"

namespace dynrt::host {

std::unique_ptr<ClockedBoard> make_stand_in_board();
std::unique_ptr<ClockedBoard> make_stand_in_board_traced(const std::string& trace, int seed);

namespace {

namespace reg = registers;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::uint32_t kWidth = 24;
constexpr std::uint32_t kHeight = 10;
constexpr std::uint32_t kPixels = kWidth * kHeight;
constexpr std::uint32_t kFrameBase = 1000;
constexpr std::uint32_t kLines = 16;
constexpr std::uint32_t kPackets = 4;
constexpr std::uint32_t kTokens = kLines + kPackets;
constexpr std::uint32_t kHang = 0xdeadbeef;
constexpr std::uint32_t kViolation = 0x00badbad;  ///< of an assertion

std::vector<Counter> stand_in_counters() {
  return {{"stand_in.transactions", 0, true}, {"start.tokens", 0, true}};
}

std::vector<std::uint32_t> random_words(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> words(count);
  for (auto& word : words) word = static_cast<std::uint32_t>(random());
  return words;
}

FrameConfig frame_config(std::uint32_t background = 0) {
  FrameConfig frame;
  frame.packets = to_word(kPackets);
  frame.line_mask = to_word(kLines - 1);
  frame.width = to_word(kWidth);
  frame.height = to_word(kHeight);
  frame.frame_base = to_word(kFrameBase);
  frame.background = to_word(background);
  return frame;
}

class RtlBoardTest : public testing::Test {
 protected:
  RtlBoard board_{named("stand_in"), make_stand_in_board(), stand_in_counters()};

  std::vector<std::uint32_t> read(unsigned bank, std::uint32_t address, std::size_t count) {
    std::vector<std::uint32_t> words(count);
    board_.read(bank, address, words);
    return words;
  }
};

TEST_F(RtlBoardTest, SaysWhatItIs) {
  EXPECT_EQ(board_.name(), "rtl");
  EXPECT_EQ(board_.core().name, "stand_in");
  EXPECT_EQ(board_.core().packets, 64u);
  EXPECT_EQ(board_.core().lines, 512u);
  EXPECT_EQ(board_.read_register(reg::kRegId), reg::kIdValue);
  EXPECT_EQ(board_.read_register(reg::kRegVersion), reg::kVersionValue);
  EXPECT_EQ(board_.read_register(reg::kRegStatus), 0u);
}

/// A board that answers every read with zero, or not at all.
class DeadBoard final : public ClockedBoard {
 public:
  explicit DeadBoard(bool hangs) : hangs_(hangs) {}
  void reset() override {}
  bool write(std::uint32_t, std::span<const std::uint32_t>) override { return !hangs_; }
  bool read(std::uint32_t, std::span<std::uint32_t>) override { return !hangs_; }
  bool run_until_interrupt(std::uint64_t) override { return false; }
  bool interrupt() const override { return false; }
  void watch(VgaMonitor*) override {}
  std::uint64_t clocks() const override { return 0; }
  std::optional<std::uint64_t> frame_writes() const override { return 0; }

 private:
  bool hangs_;
};

TEST(RtlBoardErrors, ABoardThatIsNoneIsRefused) {
  EXPECT_THAT([] { RtlBoard(named("thesis"), std::make_unique<DeadBoard>(false), {}); },
              ThrowsMessage<UserError>(
                  "board rtl: its registers give the id 0x0 and the version 0x0, but the host "
                  "expects 0x44595254 and 0x20004; rebuild the Verilog and the host together"));
  EXPECT_THAT(
      [] { RtlBoard(named("thesis"), std::make_unique<DeadBoard>(true), {}); },
      ThrowsMessage<UserError>(
          "board rtl: the bus waits for ever at address 0x0; the Verilog behind it is broken"));
}

TEST_F(RtlBoardTest, FrameRegistersKeepWhatIsWritten) {
  const auto words = random_words(kShippedFrameWords, 1);
  for (std::uint32_t i = 0; i < kShippedFrameWords; ++i) {
    board_.write_register(reg::kRegFrame + 4 * i, words[i]);
  }
  for (std::uint32_t i = 0; i < kShippedFrameWords; ++i) {
    EXPECT_EQ(board_.read_register(reg::kRegFrame + 4 * i), words[i]) << i;
  }
  // The room above holds nothing, and does not lead back to the first of them.
  constexpr std::uint32_t kRoom = 1u << reg::kFrameWordBits;
  for (std::uint32_t i = kShippedFrameWords; i < kRoom; ++i) {
    board_.write_register(reg::kRegFrame + 4 * i, 1);
    EXPECT_EQ(board_.read_register(reg::kRegFrame + 4 * i), 0u) << i;
  }
  EXPECT_EQ(board_.read_register(reg::kRegFrame), words[0]);
}

TEST_F(RtlBoardTest, SramWindowRoundTrip) {
  // Both ends and a burst in the middle of every bank, each with words of its own.
  for (unsigned bank = 0; bank < kBanks; ++bank) {
    board_.write(bank, 0, random_words(3, bank));
    board_.write(bank, 4000, random_words(1500, 10 + bank));
    board_.write(bank, kBankWords - 2, random_words(2, 20 + bank));
  }
  for (unsigned bank = 0; bank < kBanks; ++bank) {
    EXPECT_EQ(read(bank, 0, 3), random_words(3, bank));
    EXPECT_EQ(read(bank, 4000, 1500), random_words(1500, 10 + bank));
    EXPECT_EQ(read(bank, kBankWords - 2, 2), random_words(2, 20 + bank));
  }
}

TEST_F(RtlBoardTest, RegistersAndWindowAnswerInOrder) {
  board_.write(1, 7, std::vector<std::uint32_t>{77});
  EXPECT_EQ(read(1, 7, 1).front(), 77u);
  EXPECT_EQ(board_.read_register(reg::kRegId), reg::kIdValue);
  EXPECT_EQ(read(1, 7, 1).front(), 77u);
}

TEST_F(RtlBoardTest, RendersAndInterrupts) {
  const auto words0 = random_words(kPixels, 1);
  const auto words1 = random_words(kPixels, 2);
  const auto words2 = random_words(kPixels, 3);
  board_.write(0, 0, words0);
  board_.write(1, 0, words1);
  board_.write(2, 0, words2);
  for (int frame = 0; frame < 2; ++frame) {
    board_.configure(frame_config());
    board_.start();
    EXPECT_EQ(board_.read_register(reg::kRegStatus), 1u << reg::kStatusBusy);
    std::uint64_t pixels = 0;
    const FrameRun run = board_.wait(100'000, [&](std::uint64_t done) { pixels = done; });
    EXPECT_EQ(pixels, kPixels);
    // Tokens and pixels go by at one a clock.
    ASSERT_TRUE(run.cycles.has_value());
    EXPECT_GE(*run.cycles, kTokens + kStartPause + kPixels);
    EXPECT_LE(*run.cycles, kTokens + kStartPause + kPixels + 10);
    EXPECT_EQ(board_.read_register(reg::kRegStatus), 1u << reg::kStatusDone);
    EXPECT_EQ(board_.read_register(reg::kRegIrqPending), 0u);

    const auto image = read(3, kFrameBase, kPixels);
    const auto copy = read(4, 0, kPixels);
    const auto inverse = read(5, 0, kPixels);
    for (std::uint32_t p = 0; p < kPixels; ++p) {
      ASSERT_EQ(image[p], words0[p] ^ words1[p]) << p;
      ASSERT_EQ(copy[p], words2[p]) << p;
      ASSERT_EQ(inverse[p], ~words0[p]) << p;
    }
    const auto counters = board_.counters();
    EXPECT_EQ(counters.at(0).value, kPixels);  // the first frame's are cleared
    EXPECT_EQ(counters.at(1).value, kTokens);
  }
}

TEST_F(RtlBoardTest, FeedsATokenForEveryPacketAndCacheLineInUse) {
  FrameConfig frame = frame_config();
  for (const auto& [packets, lines] : {std::pair{4u, 1u}, {1u, 8u}, {3u, 4u}, {64u, 512u}}) {
    frame.packets = to_word(packets);
    frame.line_mask = to_word(lines - 1);
    board_.configure(frame);
    board_.start();
    board_.wait(5000, {});
    EXPECT_EQ(board_.counters().at(1).value, packets + lines);
  }
}

TEST_F(RtlBoardTest, InterruptIsPendingUntilAcknowledgedAndCanBeMasked) {
  const auto clocked = make_stand_in_board();
  clocked->reset();
  clocked->run_until_interrupt(100);  // the core's reset
  const auto get = [&](std::uint32_t address) {
    std::uint32_t value = 0;
    EXPECT_TRUE(clocked->read(address, {&value, 1}));
    return value;
  };
  const auto put = [&](std::uint32_t address, std::uint32_t value) {
    ASSERT_TRUE(clocked->write(address, {&value, 1}));
    get(reg::kRegId);  // a register has the value a clock after the bus took it
  };
  put(reg::kRegFrame, 1);
  put(reg::kRegFrame + 8, 1);
  put(reg::kRegFrame + 12, 1);
  put(reg::kRegControl, 1u << reg::kControlStart);
  EXPECT_FALSE(clocked->run_until_interrupt(1000));  // masked
  EXPECT_EQ(get(reg::kRegIrqPending), 1u);
  put(reg::kRegIrqEnable, 1);
  EXPECT_TRUE(clocked->interrupt());
  put(reg::kRegIrqPending, 0);  // writing a zero acknowledges nothing
  EXPECT_TRUE(clocked->interrupt());
  put(reg::kRegIrqPending, 1);
  EXPECT_FALSE(clocked->interrupt());
  EXPECT_EQ(get(reg::kRegStatus), 1u << reg::kStatusDone);
}

TEST_F(RtlBoardTest, RefusesTheHostWhileBusy) {
  constexpr std::uint32_t kBusy = 1u << reg::kStatusBusy;
  board_.write(0, 0, std::vector<std::uint32_t>(kPixels, 123));
  board_.configure(frame_config(kHang));
  board_.start();
  EXPECT_EQ(board_.read_register(reg::kRegStatus), kBusy);
  EXPECT_EQ(read(0, 5, 1).front(), 0u);
  EXPECT_EQ(board_.read_register(reg::kRegStatus), kBusy | 1u << reg::kStatusRefused);
  board_.write(0, 5, std::vector<std::uint32_t>{456});
  board_.write_register(reg::kRegControl, 1u << reg::kControlReset);
  for (int i = 0; i < 20; ++i) board_.read_register(reg::kRegId);
  EXPECT_EQ(board_.read_register(reg::kRegStatus), 0u);
  EXPECT_EQ(read(0, 5, 1).front(), 123u);

  board_.start();
  board_.write_register(reg::kRegFrame, 99);
  EXPECT_EQ(board_.read_register(reg::kRegFrame), 4u);
  EXPECT_EQ(board_.read_register(reg::kRegStatus), kBusy | 1u << reg::kStatusRefused);
}

TEST_F(RtlBoardTest, RefusesToStartWhatTheCoreCannotRender) {
  constexpr char kNoPackets[] =
      "board rtl: it refused to start a frame with 0 packets and 16 cache lines; its core takes 1 "
      "to "
      "64 packets, and a power of two of at most 512 lines";
  FrameConfig frame = frame_config();
  for (const auto& [packets, lines] : {std::pair{0u, kLines},
                                       {65u, kLines},
                                       {512u + 4, kLines},
                                       {0x10004u, kLines},
                                       {4u, 3u},
                                       {4u, 513u},
                                       {4u, 1024u},
                                       {4u, 0u}}) {
    SCOPED_TRACE(fmt::format("{} packets, {} lines", packets, lines));
    frame.packets = to_word(packets);
    frame.line_mask = to_word(lines - 1);
    board_.configure(frame);
    EXPECT_THAT([&] { board_.start(); },
                ThrowsMessage<UserError>(HasSubstr("it refused to start a frame with")));
    EXPECT_EQ(board_.read_register(reg::kRegStatus), 1u << reg::kStatusRefused);
    board_.idle(1000);
    EXPECT_EQ(board_.read_register(reg::kRegStatus), 1u << reg::kStatusRefused) << "it started";
    EXPECT_EQ(board_.read_register(reg::kRegIrqPending), 0u);
  }
  frame.packets = to_word(0);
  frame.line_mask = to_word(kLines - 1);
  board_.configure(frame);
  EXPECT_THAT([&] { board_.start(); }, ThrowsMessage<UserError>(kNoPackets));
  board_.write_register(reg::kRegControl, 1u << reg::kControlReset);
  board_.idle(100);
  EXPECT_EQ(board_.read_register(reg::kRegStatus), 0u) << "a reset clears it";
  EXPECT_THAT([&] { board_.start(); }, ThrowsMessage<UserError>(kNoPackets));
  board_.configure(frame_config());
  board_.start();
  board_.wait(5000, {});
  EXPECT_EQ(board_.read_register(reg::kRegStatus), 1u << reg::kStatusDone) << "a start clears it";
}

TEST_F(RtlBoardTest, RefusesToStartTwice) {
  board_.configure(frame_config(kHang));
  board_.start();
  EXPECT_THAT([&] { board_.start(); },
              ThrowsMessage<std::logic_error>(HasSubstr("it refused an access during the frame")));
}

TEST_F(RtlBoardTest, TimeOutTellsWhereTheUnitsStandAndTheBoardRecovers) {
  board_.configure(frame_config(kHang));
  board_.start();
  EXPECT_THAT(
      [&] { board_.wait(5000, {}); },
      ThrowsMessage<TimeoutError>(
          "board rtl: no interrupt and no pixel for 5000 clocks (a longer timeout allows more); "
          "240 pixels are written, the status is 0x1, the units: without input: stand_in 240"));
  board_.configure(frame_config());
  board_.start();
  EXPECT_NO_THROW(board_.wait(5000, {}));
}

TEST_F(RtlBoardTest, CountsWhatGoesOverTheBus) {
  const BusTraffic before = board_.traffic();
  board_.write(0, 0, random_words(300, 1));  // bursts of 256 and 44
  read(0, 0, 10);
  const BusTraffic after = board_.traffic();
  EXPECT_EQ(after.transactions - before.transactions, 3u);
  EXPECT_EQ(after.bytes_written - before.bytes_written, 1200u);
  EXPECT_EQ(after.bytes_read - before.bytes_read, 40u);
  EXPECT_EQ(after.bus_clocks - before.bus_clocks, 300u + 2 * 2 + 10 + 5);
}

TEST(RtlBoardTrace, WritesWaveforms) {
  const auto file = std::filesystem::path(testing::TempDir()) / "board_test.fst";
  std::filesystem::remove(file);
  {
    RtlBoard board(named("stand_in"), make_stand_in_board_traced(file, 1), stand_in_counters());
    board.configure(frame_config());
    board.start();
    board.wait(5000, {});
  }
  EXPECT_GT(std::filesystem::file_size(file), 1000u);
  std::filesystem::remove(file);
}

TEST(RtlBoardTrace, AnAssertionThatFailsIsADefect) {
  const auto render = [](std::unique_ptr<ClockedBoard> clocked) {
    RtlBoard board(named("stand_in"), std::move(clocked), stand_in_counters());
    board.configure(frame_config(kViolation));
    board.start();
    board.wait(5000, {});
  };
  EXPECT_NO_THROW(render(make_stand_in_board())) << "made for speed";
  EXPECT_THAT(
      [&] { render(make_stand_in_board_traced("", 1)); },
      ThrowsMessage<std::logic_error>(testing::MatchesRegex(
          "an assertion of the Verilog, printed above, fails in clock [0-9]+ of the board")));
}

TEST(RtlBoardTrace, AFileThatCannotBeWrittenIsAnError) {
  EXPECT_THAT([] { make_stand_in_board_traced("/nowhere/at/all.fst", 1); },
              ThrowsMessage<UserError>("/nowhere/at/all.fst: cannot write this file; name a file "
                                       "in a folder that can be written"));
}

}  // namespace
}  // namespace dynrt::host
