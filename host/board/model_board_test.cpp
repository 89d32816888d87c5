// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/model_board.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/board/frame_words.h"

namespace dynrt::host {
namespace {

/// A core that copies word i of bank 0 to bank 3 for every pixel.
class CopyingCore final : public NativeCore {
 public:
  void write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) override {
    std::copy(words.begin(), words.end(), banks_[bank].begin() + address);
  }
  void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) override {
    std::copy_n(banks_[bank].begin() + address, words.size(), words.begin());
  }
  void render(const FrameConfig& frame) override {
    std::copy_n(banks_[0].begin(), frame.width.to_u64() * frame.height.to_u64(), banks_[3].begin());
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
  ModelBoard board({"", "thesis", 8, 32}, std::make_unique<CopyingCore>());
  EXPECT_EQ(board.info().name, "model");
  EXPECT_EQ(board.info().configuration, "thesis");
  EXPECT_EQ(board.info().packets, 8u);
  EXPECT_EQ(board.info().cache_lines, 32u);
  const std::vector<std::uint32_t> words = {5, 6, 7, 8};
  board.write(0, 0, words);
  FrameConfig frame;
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
  EXPECT_EQ(board.traffic().bytes_written, 4u * (4 + kFrameWords + 1));
  EXPECT_EQ(board.traffic().bytes_read, 16u);
}

TEST(ModelBoard, RefusesWordsOutsideABank) {
  ModelBoard board({"", "thesis", 8, 32}, std::make_unique<CopyingCore>());
  std::vector<std::uint32_t> words(2);
  EXPECT_THAT(
      [&] { board.read(1, (1u << 20) - 1, words); },
      testing::ThrowsMessage<std::out_of_range>(
          "board model: words 1048575 to 1048577 of bank 1 are asked for; there are 6 banks of "
          "1048576 words"));
  EXPECT_THROW(board.write(6, 0, words), std::out_of_range);
}

}  // namespace
}  // namespace dynrt::host
