// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The host's end on a serial device that is a pseudo-terminal; a thread is the board at its other
// end.
#include "link/pseudo_terminal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "host/error.h"
#include "host/link/link.h"
#include "host/link/serial_device.h"
#include "link/test_board.h"

namespace dynrt::host {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

BoardFunction answers_of(TestBoard& board) {
  return [&board](std::span<const std::uint8_t> bytes) { return board.model.answer(bytes); };
}

TEST(PseudoTerminal, LoadsAndReadsBack) {
  TestBoard board;
  const BoardAtTerminal terminal(answers_of(board));
  BoardLink link(std::make_unique<SerialDevice>(terminal.path()));
  link.expect_configuration("fast");
  const Bytes data = random_bytes(100'000, 7);
  std::uint64_t moved = 0;
  const MemoryBytes parts[] = {{64, data}};
  link.write_memory(parts, [&moved](std::uint64_t bytes) {
    EXPECT_GT(bytes, moved);
    moved = bytes;
  });
  EXPECT_EQ(moved, data.size());
  Bytes back(data.size());
  link.read_memory(64, back);
  EXPECT_EQ(back, data);
  const std::vector<std::uint32_t> words = {1, 0x7d7e7d7e, 3, ~0u};
  link.write_registers(0x100, words);
  std::vector<std::uint32_t> read(4);
  link.read_registers(0x100, read);
  EXPECT_EQ(read, words);
  EXPECT_EQ(link.counts().carried, 200'000u + 16 + 16);
}

/// A second session goes on where the first ended, even within a frame.
TEST(PseudoTerminal, BeginsAnewAfterAProgramThatWasKilled) {
  TestBoard board;
  const BoardAtTerminal terminal(answers_of(board));
  for (unsigned round = 0; round < 3; ++round) {
    {
      BoardLink link(std::make_unique<SerialDevice>(terminal.path()));
      link.write_memory(0, Bytes(5000, static_cast<std::uint8_t>(round)));
    }
    SerialDevice killed(terminal.path());
    const Bytes part = {kLinkFlag, 2, static_cast<std::uint8_t>(10 * round + 10), 0, 2, 0, 0, 0};
    EXPECT_EQ(killed.write(part), part.size());
    std::this_thread::sleep_for(50ms);
  }
  EXPECT_EQ(board.model.memory()[4999], 2);
}

std::string refusal(const std::string& path) {
  try {
    BoardLink link(std::make_unique<SerialDevice>(path), {.quiet = 20ms, .repeats = 3});
    link.write_memory(0, random_bytes(20'000, 1));
    return "none";
  } catch (const UserError& error) {
    return error.what();
  }
}
/// The device is free for the next program.
void expect_released(const std::string& path) { EXPECT_NO_THROW(SerialDevice{path}); }

TEST(PseudoTerminal, SaysThatNothingAnswers) {
  const BoardAtTerminal terminal([](auto) { return Bytes{}; });
  EXPECT_THAT(refusal(terminal.path()), HasSubstr("nothing answers"));
  expect_released(terminal.path());
}

TEST(PseudoTerminal, SaysThatTheAnswersAreNonsense) {
  const BoardAtTerminal terminal(
      [](std::span<const std::uint8_t> bytes) { return Bytes(bytes.size(), 'x'); });
  EXPECT_THAT(refusal(terminal.path()), HasSubstr("bytes, but no answer of dynrt"));
  expect_released(terminal.path());
}

TEST(PseudoTerminal, SaysThatTheBoardStopsInTheMiddleOfAFrame) {
  TestBoard board;
  std::size_t left = 110;  // of its answers' bytes: the identification, and some of the next
  const BoardAtTerminal terminal([&](std::span<const std::uint8_t> bytes) {
    Bytes answer = board.model.answer(bytes);
    if (answer.size() > left) answer.resize(left);
    left -= answer.size();
    return answer;
  });
  EXPECT_THAT(refusal(terminal.path()), HasSubstr("stopped in the middle of an answer"));
  expect_released(terminal.path());
}

TEST(PseudoTerminal, SaysThatTheDeviceIsInUse) {
  TestBoard board;
  const BoardAtTerminal terminal(answers_of(board));
  const SerialDevice first(terminal.path());
  EXPECT_THAT(refusal(terminal.path()), HasSubstr("another program uses the device"));
}

}  // namespace
}  // namespace dynrt::host
