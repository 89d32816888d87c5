// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The program dynrt with a board at a serial device, which is a pseudo-terminal: a frame of the
// whole simulated ULX3S, and the messages of the program about a faulty board. Each of
// its errors is one sentence, and leaves the device to the next program.
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "configs/fast_port.h"
#include "host/board/configurations.h"
#include "host/board/registers.h"
#include "host/link/serial_device.h"
#include "host/run_program.h"
#include "host/test_folder.h"
#include "host/ulx3s/simulated_ulx3s.h"
#include "link/pseudo_terminal.h"
#include "link/test_board.h"

namespace dynrt::host {
namespace {

namespace reg = registers;
using testing::HasSubstr;
using testing::StartsWith;

constexpr int kMistakeInTheInput = 2;

/// Runs the program in a folder of its own.
class Program : public testing::Test {
 public:
  /// Gives the exit code, and that of `timeout` if it takes so many seconds.
  int run(const std::string& arguments, unsigned seconds = 60, const std::string& before = "") {
    const Outcome outcome = run_program(
        "timeout", fmt::format("{} env {} {} {}", seconds, before, DYNRT_PROGRAM, arguments),
        folder_.path());
    output_ = outcome.out;
    errors_ = outcome.err;
    return outcome.code;
  }
  std::string picture() const { return (folder_ / "picture.png").string(); }
  std::string render_on(const std::string& board) const {
    return fmt::format("render blocks --size 16x12 --board {} --out {}", board, picture());
  }
  /// One sentence and no picture.
  void expect_error(const std::string& arguments, const std::string& sentence) {
    EXPECT_EQ(run(arguments), kMistakeInTheInput) << output_;
    EXPECT_THAT(errors_, StartsWith("dynrt: board "));
    EXPECT_THAT(errors_, HasSubstr(sentence));
    EXPECT_EQ(std::ranges::count(errors_, '\n'), 1) << errors_;
    EXPECT_FALSE(std::filesystem::exists(picture()));
  }
  void expect_refusal(const std::string& device, const std::string& sentence,
                      const std::string& flags = "") {
    expect_error(render_on("serial:" + device) + flags, sentence);
    EXPECT_THAT(errors_, StartsWith("dynrt: board serial:" + device + ": "));
  }
  /// The same; the device is free then.
  void expect_refusal(const BoardAtTerminal& board, const std::string& sentence,
                      const std::string& flags = "") {
    expect_refusal(board.path(), sentence, flags);
    EXPECT_FALSE(board.terminal().is_exclusive());
    EXPECT_NO_THROW(SerialDevice{board.path()});
  }

  const TestFolder folder_;
  std::string output_, errors_;
};

/// A board of fast_port as the program finds it before a frame: the registers that it asks for. It
/// falls silent when a frame starts.
struct IdleBoard : TestBoard {
  IdleBoard() : TestBoard(32u << 20, "fast_port") {
    const CoreInfo core = core_info_of_listed<config::fast_port>("fast_port");
    registers = {{reg::kRegId, reg::kIdValue},
                 {reg::kRegVersion, reg::kVersionValue},
                 {reg::kRegFrameWords, static_cast<std::uint32_t>(core.frame_words({}).size())},
                 {reg::kRegLimits, core.packets | core.lines << 16}};
  }
  Bytes answer(std::span<const std::uint8_t> bytes) {
    const bool works = (registers[reg::kRegControl] >> reg::kControlStart & 1) != 0;
    return works ? Bytes{} : model.answer(bytes);
  }
};

TEST_F(Program, SaysThatThereIsNoDevice) {
  expect_refusal((folder_ / "none").string(), "there is no such device");
}

TEST_F(Program, SaysThatTheFileIsNoDevice) {
  const std::string file = (folder_ / "file").string();
  std::ofstream(file) << "text";
  expect_refusal(file, "this is no serial device");
}

TEST_F(Program, SaysThatTheDeviceIsInUse) {
  TestBoard board;
  const BoardAtTerminal terminal([&](auto bytes) { return board.model.answer(bytes); });
  {
    const SerialDevice other(terminal.path());
    EXPECT_TRUE(terminal.terminal().is_exclusive());
    expect_refusal(terminal.path(), "another program uses the device");
    EXPECT_TRUE(terminal.terminal().is_exclusive()) << "the other program still has it";
  }
  EXPECT_NO_THROW(SerialDevice{terminal.path()});
}

TEST_F(Program, SaysThatNothingAnswers) {
  const BoardAtTerminal terminal([](auto) { return Bytes{}; });
  expect_refusal(terminal, "nothing answers; switch the board on");
}

TEST_F(Program, SaysThatTheAnswersAreNonsense) {
  const BoardAtTerminal terminal([](auto bytes) { return Bytes(bytes.size(), 'x'); });
  expect_refusal(terminal, "bytes, but no answer of dynrt");
}

TEST_F(Program, RefusesABitstreamOfAnotherConfiguration) {
  TestBoard board;
  const BoardAtTerminal terminal([&](auto bytes) { return board.model.answer(bytes); });
  expect_refusal(
      terminal,
      "its bitstream has configuration fast, which this program does not know at a serial "
      "line; load a bitstream that has fast_ulx3s or fast_port");
}

TEST_F(Program, RefusesABitstreamOfAnotherConfigurationThanIsAskedFor) {
  IdleBoard board;
  const BoardAtTerminal terminal([&](auto bytes) { return board.answer(bytes); });
  expect_refusal(terminal,
                 "its bitstream has configuration fast_port, but configuration fast_ulx3s is asked "
                 "for",
                 " --config fast_ulx3s");
}

TEST_F(Program, RefusesAConfigurationThatNoSuchBoardHolds) {
  expect_error(render_on("ulx3s") + " --config fast_port",
               "board ulx3s holds configuration fast_ulx3s, not fast_port; name the one that it "
               "holds, or leave --config out");
  expect_error(render_on("ulx3s") + " --config fast",
               "board ulx3s holds configuration fast_ulx3s, not fast; name the one that it holds, "
               "or leave --config out");
  expect_error(
      render_on("serial:any") + " --config thesis",
      "board serial:any holds configuration fast_ulx3s or fast_port, not thesis; name the one "
      "that it holds, or leave --config out");
}

TEST_F(Program, RefusesToShowAPictureBesideThatOfTheBoard) {
  expect_error(
      render_on("ulx3s") + " --scan-out display.png",
      "board ulx3s has a display of its own, which --scan-out does not read; leave out --scan-out, "
      "or take board rtl");
}

TEST_F(Program, HasNoUseForACoreMadeForTheScene) {
  for (const char* board : {"ulx3s", "serial:any"}) {
    expect_error(
        render_on(board) + " --specialise",
        std::string("board ") + board +
            " has the core of its bitstream and takes no other, so leave out --specialise");
  }
}

TEST_F(Program, SaysThatNoDeviceIsNamed) {
  expect_error(render_on("serial:"),
               "board serial:: it names no device; write one after the colon");
}

TEST_F(Program, SaysThatTheBoardStopsInTheMiddleOfAnAnswer) {
  IdleBoard board;
  std::size_t left = 110;  // of its answers' bytes: the identification, and some of the next
  const BoardAtTerminal terminal([&](auto bytes) {
    Bytes answer = board.answer(bytes);
    if (answer.size() > left) answer.resize(left);
    left -= answer.size();
    return answer;
  });
  expect_refusal(terminal, "it stopped in the middle of an answer");
}

TEST_F(Program, SaysThatTheBoardStopsInTheMiddleOfAFrame) {
  IdleBoard board;
  const BoardAtTerminal terminal([&](auto bytes) { return board.answer(bytes); });
  expect_refusal(terminal, "it stopped answering after");
  EXPECT_GT(board.model.writes(), 100u) << "it got the scene";
}

TEST_F(Program, SaysThatTheBoardCountsNoClocks) {
  IdleBoard board;
  const BoardAtTerminal terminal([&](auto bytes) { return board.model.answer(bytes); });
  expect_refusal(terminal, "its core stopped in the middle of a frame, after 0 clocks");
  EXPECT_GT(board.model.writes(), 100u) << "it got the scene";
}

TEST_F(Program, ResetsABoardThatAnotherProgramHasLeftBusy) {
  IdleBoard board;
  board.registers[reg::kRegStatus] = 1u << reg::kStatusBusy;
  bool resets = false;
  const BoardAtTerminal terminal([&](auto bytes) {
    Bytes answer = board.answer(bytes);
    if (board.registers[reg::kRegControl] >> reg::kControlReset & 1) {
      resets = true;
      board.registers[reg::kRegStatus] = 0;
    }
    return answer;
  });
  expect_refusal(terminal, "it stopped answering after");
  EXPECT_TRUE(resets);
  EXPECT_GT(board.model.writes(), 100u) << "it got the scene";
}

TEST_F(Program, SaysThatTheBoardStaysBusyAfterAReset) {
  IdleBoard board;
  board.registers[reg::kRegStatus] = 1u << reg::kStatusBusy;
  const BoardAtTerminal terminal([&](auto bytes) { return board.answer(bytes); });
  expect_refusal(terminal, "its core stays busy after a reset");
  EXPECT_EQ(board.registers[reg::kRegControl], 1u << reg::kControlReset);
}

TEST_F(Program, HasNoUseForSchedulesWhereTheBoardHasClocks) {
  expect_error(render_on("serial:any") + " --schedule any",
               "board serial:any counts its own clocks and takes no schedules");
}

/// The simulated board at a pseudo-terminal. Its time is in a file.
class SimulatedAtTerminal {
 public:
  explicit SimulatedAtTerminal(const std::filesystem::path& clock) {
    std::ofstream(clock, std::ios::binary) << std::string(sizeof(*now_), '\0');
    const int file = ::open(clock.c_str(), O_RDWR | O_CLOEXEC);
    void* const mapped =
        ::mmap(nullptr, sizeof(*now_), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    if (mapped == MAP_FAILED) throw std::logic_error("the clock cannot be mapped");
    now_ = static_cast<std::atomic<std::uint64_t>*>(mapped);
    thread_ = std::thread([this] { run(); });
  }
  ~SimulatedAtTerminal() {
    ends_ = true;
    thread_.join();
    ::munmap(now_, sizeof(*now_));
  }
  SimulatedAtTerminal(const SimulatedAtTerminal&) = delete;
  SimulatedAtTerminal& operator=(const SimulatedAtTerminal&) = delete;

  const std::string& path() const { return terminal_.path(); }
  std::uint64_t words_written() const { return words_written_; }

 private:
  void run() {
    const auto board = make_simulated_ulx3s();
    Bytes answer;
    while (!ends_) {
      board->write(terminal_.read(0));
      board->run(std::chrono::microseconds(20));
      Bytes bytes(4096);
      bytes.resize(board->read(bytes));
      answer.insert(answer.end(), bytes.begin(), bytes.end());
      const std::size_t sent = answer.empty() ? 0 : terminal_.write(answer);
      answer.erase(answer.begin(), answer.begin() + static_cast<std::ptrdiff_t>(sent));
      words_written_ = board->memory_use().words_written;
      *now_ = static_cast<std::uint64_t>(board->now().count());
    }
  }

  PseudoTerminal terminal_;
  std::atomic<std::uint64_t>* now_ = nullptr;
  std::atomic<std::uint64_t> words_written_ = 0;
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

TEST_F(Program, SlowlyRendersTheModelsPictureOnTheUlx3s) {
  ASSERT_EQ(run(render_on("model") + " --config fast_ulx3s", 300), 0) << errors_;
  const std::string expected = text_of(picture());
  ASSERT_GT(expected.size(), 100u);
  std::filesystem::remove(picture());
  const SimulatedAtTerminal board(folder_ / "clock");
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(run(render_on("serial:" + board.path()), 3000,
                fmt::format("DYNRT_BOARD_CLOCK={} LD_PRELOAD={}", (folder_ / "clock").string(),
                            BOARD_CLOCK)),
            0)
      << errors_;
  fmt::print("{}{:.0f} s\n", output_,
             std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  EXPECT_EQ(text_of(picture()), expected);
  EXPECT_GT(board.words_written(), 1000u);
  EXPECT_NO_THROW(SerialDevice{board.path()});
}

}  // namespace
}  // namespace dynrt::host
