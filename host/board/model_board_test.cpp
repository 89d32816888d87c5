// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/model_board.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "host/format/frame_words.h"
#include "host/test_folder.h"

namespace dynrt::host {
namespace {

/// A core that copies word i of bank 0 to bank 3 for every pixel.
CoreInfo small() {
  CoreInfo core;
  core.name = "thesis";
  core.packets = 8;
  core.lines = 32;
  return core;
}

class CopyingCore final : public NativeCore {
 public:
  void write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) override {
    std::copy(words.begin(), words.end(), banks_[bank].begin() + address);
  }
  void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) override {
    std::copy_n(banks_[bank].begin() + address, words.size(), words.begin());
  }
  std::optional<std::uint64_t> render(const FrameConfig& frame,
                                      const hls::ModuleSchedules* schedule,
                                      FrameWatch* /*watch*/) override {
    std::copy_n(banks_[0].begin(), frame.width.to_u64() * frame.height.to_u64(), banks_[3].begin());
    if (schedule == nullptr) return std::nullopt;
    const auto copy = schedule->find("copy");
    if (copy == schedule->end()) throw std::invalid_argument("there is no schedule of 'copy'");
    return copy->second.stages + copy->second.room + copy->second.ram_stages.at("row");
  }
  std::vector<Counter> counters() override { return {{"copy.transactions", 12, true}}; }

 private:
  std::array<std::vector<std::uint32_t>, 6> banks_ = [] {
    std::array<std::vector<std::uint32_t>, 6> banks;
    banks.fill(std::vector<std::uint32_t>(64));
    return banks;
  }();
};

TEST(ModelBoard, RendersWhatTheCoreRenders) {
  ModelBoard board(small(), std::make_unique<CopyingCore>());
  EXPECT_EQ(board.name(), "model");
  EXPECT_EQ(board.core().name, "thesis");
  EXPECT_EQ(board.core().packets, 8u);
  EXPECT_EQ(board.core().lines, 32u);
  const std::vector<std::uint32_t> words = {5, 6, 7, 8};
  board.write(0, 0, words);
  FrameConfig frame;
  frame.packets = to_word(8);
  frame.width = to_word(2);
  frame.height = to_word(2);
  board.configure(frame);
  board.start();
  std::uint64_t pixels = 0;
  const FrameRun run = board.wait(0, [&](std::uint64_t done) { pixels = done; });
  EXPECT_FALSE(run.cycles.has_value());
  EXPECT_EQ(pixels, 4u);
  std::vector<std::uint32_t> image(4);
  board.read(3, 0, image);
  EXPECT_EQ(image, words);
  EXPECT_EQ(board.counters().at(0).value, 12u);
  EXPECT_EQ(board.traffic().bytes_written, 4u * (4 + kShippedFrameWords + 1));
  EXPECT_EQ(board.traffic().bytes_read, 16u);
}

class ScheduledBoard : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  ModelBoard board() const {
    return ModelBoard(small(), std::make_unique<CopyingCore>(), folder_.path().string());
  }
  std::string refusal(bool render = false) const {
    try {
      ModelBoard made = board();
      if (render) made.wait(0, nullptr);
    } catch (const UserError& error) {
      return error.what();
    }
    return "none";
  }
  const TestFolder folder_;
};

constexpr char kCopy[] =
    R"({"module": "copy", "stages": 3, "room": 6, "ram_stages": {"row": 100}})";

TEST_F(ScheduledBoard, GivesTheCoreTheSchedulesAndTakesItsClocks) {
  write("copy.json", kCopy);
  write("dynrt_core.json", R"({"module": "dynrt_core", "units": []})");
  write("copy.txt", "stages 7");
  const FrameRun run = board().wait(0, nullptr);
  EXPECT_EQ(run.cycles, 109u);
  EXPECT_TRUE(run.scheduled);
}

TEST_F(ScheduledBoard, RefusesWhatIsNoWholeSetOfSchedules) {
  const std::string name = folder_.path().string();
  EXPECT_EQ(refusal(), name +
                           ": the folder has no schedules of hlsc; name the folder of a "
                           "configuration's Verilog, such as build/release/generated/fast");
  write("paste.json", R"({"module": "paste", "stages": 3, "room": 6, "ram_stages": {}})");
  EXPECT_EQ(refusal(true), name +
                               ": there is no schedule of 'copy' of configuration thesis; "
                               "name the folder of that configuration's Verilog");
  write("copy.json", R"({"module": "copy", "stages": 3, "roo)");
  EXPECT_EQ(
      refusal(),
      name +
          "/copy.json: not a complete schedule of hlsc; lower the unit again or remove the file");
  write("copy.json", R"({"module": "copy", "stages": 3})");
  EXPECT_THAT(refusal(), testing::HasSubstr("not a complete schedule of hlsc"));
  std::filesystem::remove_all(folder_.path());
  EXPECT_THAT(refusal(), testing::HasSubstr("the folder has no schedules of hlsc"));
}

TEST(ModelBoard, RefusesToStartWhatTheCoreCannotRender) {
  ModelBoard board(small(), std::make_unique<CopyingCore>());
  FrameConfig frame;
  for (const auto& [packets, lines] : {std::pair{0u, 1u}, {9u, 1u}, {8u, 64u}, {8u, 3u}}) {
    frame.packets = to_word(packets);
    frame.line_mask = to_word(lines - 1);
    board.configure(frame);
    EXPECT_THAT([&] { board.start(); },
                testing::ThrowsMessage<UserError>(fmt::format(
                    "board model: it refused to start a frame with {} packets and {} cache lines; "
                    "its core takes 1 to 8 packets, and a power of two of at most 32 lines",
                    packets, lines)));
  }
  frame.packets = to_word(8);
  frame.line_mask = to_word(31);
  board.configure(frame);
  EXPECT_NO_THROW(board.start());
}

TEST(ModelBoard, RefusesWordsOutsideABank) {
  ModelBoard board(small(), std::make_unique<CopyingCore>());
  std::vector<std::uint32_t> words(2);
  EXPECT_THAT([&] { board.read(1, (1u << 20) - 1, words); },
              testing::ThrowsMessage<std::out_of_range>(
                  "board model: there are no words 1048575 to 1048577 of bank 1; the board has 6 "
                  "banks of 1048576 words"));
  EXPECT_THROW(board.write(6, 0, words), std::out_of_range);
}

}  // namespace
}  // namespace dynrt::host
