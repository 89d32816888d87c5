// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The host's end of the line against the model of the board's end, on a line that makes mistakes:
// whatever it does, the data arrive unchanged, each write is carried out once, and the host gives
// up in bounded time.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "host/error.h"
#include "host/link/link.h"
#include "link/simulated_line.h"
#include "link/test_board.h"

namespace dynrt::host {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr std::size_t kLoad = 100'000;

struct Session {
  explicit Session(SimulatedLine::Settings settings) {
    auto owned = std::make_unique<SimulatedLine>(
        [this](std::span<const std::uint8_t> bytes) { return board.model.answer(bytes); },
        settings);
    line = owned.get();
    link = std::make_unique<BoardLink>(std::move(owned));
  }
  TestBoard board;
  SimulatedLine* line;
  std::unique_ptr<BoardLink> link;
};

/// Loads a memory, reads it back, and so for registers.
void load_and_read_back(Session& session, std::size_t bytes, std::uint64_t seed) {
  const Bytes data = random_bytes(bytes, seed);
  session.link->write_memory(1234, data);
  const std::span memory = std::span(session.board.model.memory()).subspan(1234, bytes);
  ASSERT_TRUE(std::ranges::equal(data, memory)) << "the memory holds what was sent";
  Bytes back(bytes);
  session.link->read_memory(1234, back);
  ASSERT_EQ(back, data);
  for (std::uint32_t round = 0; round < 20; ++round) {
    std::vector<std::uint32_t> words(1 + round * 3);
    for (std::uint32_t i = 0; i < words.size(); ++i) words[i] = 1000 * round + i;
    session.link->write_registers(0x100, words);
    std::vector<std::uint32_t> read(words.size());
    session.link->read_registers(0x100, read);
    ASSERT_EQ(read, words);
  }
  EXPECT_EQ(session.board.register_writes, 20u + 3 * 190u) << "each once";
}

TEST(HostLink, KnowsTheBoard) {
  const Session session({});
  EXPECT_EQ(session.link->board().configuration, "fast");
  EXPECT_EQ(session.link->board().clock_hz, 120'000'000u);
  EXPECT_EQ(session.link->board().memory_bytes, 1u << 20);
  EXPECT_EQ(session.link->board().divisor, 40u);
  EXPECT_EQ(session.link->board().pixel_mhz, 25u);
  session.link->expect_configuration("fast");
  try {
    session.link->expect_configuration("full");
    ADD_FAILURE() << "another configuration is taken";
  } catch (const UserError& error) {
    EXPECT_STREQ(error.what(),
                 "board simulated: its bitstream has configuration fast, but configuration full is "
                 "asked for; load a bitstream of that one, or ask for configuration fast");
  }
}

/// Prints the share of the line's bytes that are data, and of its time.
TEST(HostLink, UsesTheLine) {
  for (const auto latency : {0ms, 1ms, 2ms}) {
    Session session({.latency = latency});
    const auto measure = [&](const char* what, auto&& move) {
      const LinkCounts before = session.link->counts();
      const auto begin = session.line->now();
      move();
      const std::chrono::duration<double> time = session.line->now() - begin;
      const LinkCounts& after = session.link->counts();
      const auto carried = static_cast<double>(after.carried - before.carried);
      const auto line =
          static_cast<double>(std::max(after.sent - before.sent, after.received - before.received));
      const double of_time = carried * kLineBitsOfByte / kLinkBaud / time.count();
      fmt::print("latency {} ms, {}: {:.1f} % of the bytes, {:.1f} % of the time, {:.0f} KB/s\n",
                 latency.count(), what, 100 * carried / line, 100 * of_time,
                 carried / time.count() / 1000);
      EXPECT_GT(carried / line, 0.94);
      EXPECT_GT(of_time, 0.90);
    };
    const Bytes data = random_bytes(kLoad, 1);
    measure("write", [&] { session.link->write_memory(0, data); });
    Bytes back(kLoad);
    measure("read", [&] { session.link->read_memory(0, back); });
    EXPECT_EQ(back, data);
    EXPECT_EQ(session.link->counts().repeats, 0u);
  }
}

struct Named {
  const char* name;
  LineMistakes mistakes;
};
class HostLinkMistakes : public testing::TestWithParam<Named> {};

TEST_P(HostLinkMistakes, ArriveUnchanged) {
  LinkCounts sum;
  std::uint64_t mistakes = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Session session({.mistakes = GetParam().mistakes, .latency = 1ms, .seed = seed});
    load_and_read_back(session, kLoad, seed);
    if (HasFatalFailure()) return;
    const LinkCounts& counts = session.link->counts();
    sum.requests += counts.requests;
    sum.repeats += counts.repeats;
    sum.missed += counts.missed;
    sum.bad_answers += counts.bad_answers;
    sum.timeouts += counts.timeouts;
    mistakes += session.line->mistakes();
  }
  fmt::print(
      "{}: {} mistakes; {} requests, {} repeats, {} times missed, {} bad answers, {} "
      "time-outs\n",
      GetParam().name, mistakes, sum.requests, sum.repeats, sum.missed, sum.bad_answers,
      sum.timeouts);
  EXPECT_GT(mistakes, 50u);
  if (GetParam().mistakes.delay == 0) EXPECT_GT(sum.repeats, 20u);
  EXPECT_LT(sum.repeats, 40 * mistakes);
}
INSTANTIATE_TEST_SUITE_P(EachKind, HostLinkMistakes,
                         testing::Values(Named{"lost", {.lose = 1e-4}},
                                         Named{"changed", {.change = 1e-4}},
                                         Named{"repeated", {.repeat = 1e-4}},
                                         Named{"added", {.add = 1e-4}},
                                         Named{"delayed", {.delay = 1e-3}},
                                         Named{"everything", {3e-4, 3e-4, 3e-4, 3e-4, 3e-4}}),
                         [](const auto& info) { return info.param.name; });

/// What the host says of a board, and in how many seconds of the line's time.
std::pair<std::string, double> refusal(BoardFunction board, std::size_t bytes = 10'000) {
  ByteStream::Time clock{};
  std::string said = "none";
  try {
    BoardLink link(std::make_unique<SimulatedLine>(std::move(board),
                                                   SimulatedLine::Settings{.clock = &clock}));
    link.write_memory(0, random_bytes(bytes, 1));
  } catch (const UserError& error) {
    said = error.what();
  }
  return {said, std::chrono::duration<double>(clock).count()};
}

TEST(HostLink, GivesUpOnABoardThatIsSilent) {
  const auto [said, seconds] = refusal([](auto) { return Bytes{}; });
  EXPECT_EQ(said,
            "board simulated: nothing answers; switch the board on, and load a bitstream of dynrt "
            "into it");
  EXPECT_LT(seconds, 3);
}

TEST(HostLink, GivesUpOnABoardThatTalksNonsense) {
  hls::testing::Random random(1);
  const auto [said, seconds] = refusal(
      [&](std::span<const std::uint8_t>) { return random_bytes(random.below(3), random.next()); });
  EXPECT_THAT(said, HasSubstr("bytes, but no answer of dynrt"));
  EXPECT_LT(seconds, 3);
}

TEST(HostLink, GivesUpOnABoardThatEchoes) {
  const auto [said, seconds] = refusal(
      [](std::span<const std::uint8_t> bytes) { return Bytes(bytes.begin(), bytes.end()); });
  EXPECT_THAT(said, HasSubstr("but no answer of dynrt"));
  EXPECT_LT(seconds, 3);
}

/// The board is cut off after so many bytes of its answers.
TEST(HostLink, GivesUpOnABoardThatStops) {
  unsigned in_frame = 0;
  for (unsigned bytes = 70; bytes < 130; ++bytes) {
    TestBoard board;
    std::size_t left = bytes;
    const auto [said, seconds] = refusal([&](std::span<const std::uint8_t> asked) {
      Bytes answer = board.model.answer(asked);
      if (answer.size() > left) answer.resize(left);
      left -= answer.size();
      return answer;
    });
    EXPECT_LT(seconds, 5) << bytes;
    if (said.find("stopped in the middle of an answer") != std::string::npos) {
      EXPECT_THAT(said, HasSubstr("of 20 requests, although each was repeated 8 times"));
      ++in_frame;
    } else {
      EXPECT_THAT(said, testing::AnyOf(HasSubstr("it stopped answering after"),
                                       HasSubstr("but no answer of dynrt")));
    }
  }
  EXPECT_GT(in_frame, 20u);
}

/// A board that says to every frame that it misses the first.
TEST(HostLink, GivesUpOnABoardThatMissesEverything) {
  TestBoard board;
  bool identified = false;
  const auto [said, seconds] = refusal([&](std::span<const std::uint8_t> asked) {
    Bytes answer = board.model.answer(asked);
    if (!identified || answer.empty()) {
      identified = identified || !answer.empty();
      return answer;
    }
    Bytes misses;
    append_framed(misses, {kLinkExpected, 0, 0, 0});
    return misses;
  });
  EXPECT_THAT(said, HasSubstr("it stopped answering after 0 of 20 requests"));
  EXPECT_LT(seconds, 5);
}

/// A board that loses its state, at any place of the sequence, acknowledges no write from before.
TEST(HostLink, GivesUpOnABoardThatIsResetMeanwhile) {
  for (const unsigned requests : {20u, 100u, 150u, 200u, 230u}) {
    TestBoard before, after;
    unsigned writes = 0;
    const auto board = [&](std::span<const std::uint8_t> asked) {
      if (writes >= requests) return after.model.answer(asked);
      Bytes answer = before.model.answer(asked);
      if (!answer.empty()) ++writes;
      return answer;
    };
    const auto [said, seconds] = refusal(board, 240 * kLinkDataBytes);
    EXPECT_THAT(said, HasSubstr("it stopped answering after")) << requests;
    EXPECT_LT(seconds, 5);
    EXPECT_EQ(after.model.writes(), 0u);
  }
}

TEST(HostLink, SaysByHowMuchTheMemoryIsTooSmall) {
  const Session session({});
  try {
    session.link->write_memory(TestBoard::kMemoryBytes - 100, Bytes(150));
    ADD_FAILURE() << "it is written";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("do not fit into its memory of 1048576 bytes, by 50 bytes"));
  }
}

TEST(HostLink, RefusesALinkOfAnotherVersion) {
  const auto [said, seconds] = refusal([](std::span<const std::uint8_t> asked) {
    Bytes answer;
    if (asked[0] != 0) return answer;  // as the sequence is, and the length
    Bytes plain = {kLinkAnswer | static_cast<unsigned>(LinkCommand::kIdentify),
                   0,
                   4 * kLinkIdentityWords,
                   0,
                   'D',
                   'L',
                   'N',
                   'K',
                   9,
                   0,
                   16,
                   0};
    plain.resize(kLinkAnswerBytes + 4 * kLinkIdentityWords);
    append_framed(answer, plain);
    return answer;
  });
  EXPECT_THAT(said, HasSubstr("its link has version 9, but this program speaks version 1"));
}

}  // namespace
}  // namespace dynrt::host
