// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A display whose picture lies behind a port, from a memory that answers late and with pauses to
// the pins of the DVI link: the monitor finds the picture if the memory keeps up, and if it does
// not, the display says so and shows the next one in its place.
#include <gtest/gtest.h>

#include <vector>

#include "Vdisplay_of_halves.h"
#include "Vdisplay_of_words.h"
#include "host/board/display.h"
#include "host/board/dvi_monitor.h"
#include "host/board/timed_top.h"
#include "verif/display/slow_memory.h"

namespace dynrt::verif {
namespace {

using host::DisplayFrame;
using host::DisplayMode;

constexpr DisplayMode kMode = {60, 64, 70, 90, 40, 41, 43, 46, true, false};
constexpr std::uint64_t kPixelTime = 40'000;
constexpr std::uint64_t kDisplay = std::uint64_t{kMode.htotal} * kMode.vtotal * kPixelTime;

template <class Top, class PixelType, unsigned Beat>
class Board {
 public:
  using Pixel = PixelType;

  explicit Board(unsigned core_period) : top_(&context_), run_(top_), memory(top_) {
    context_.randReset(2);
    run_.add_clock(top_.osc_i, 40'000);
    run_.add_clock(top_.clk_i, core_period);
    top_.on_i = 0;
    top_.rst_ni = 0;
    run(1'000'000);
    top_.rst_ni = 1;
  }
  ~Board() { top_.final(); }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  void show(unsigned base, unsigned width, unsigned height) {
    const auto config = host::scan_config(kMode, base, width, height);
    unsigned word = 0;
    hls::for_each_leaf(config, [&](const hls::uint<32>& field, unsigned) {
      top_.config_i[word++] = static_cast<std::uint32_t>(field.to_u64());
    });
    top_.on_i = 1;
  }
  void run(std::uint64_t ps) {
    run_.run(ps, [this](std::uint64_t now) {
      monitor.sample(now, {top_.dvi_p_o, top_.dvi_n_o});
      if (top_.clk_i != 0 && !high_) memory.clock();
      high_ = top_.clk_i != 0;
    });
  }
  Top& top() { return top_; }

 private:
  VerilatedContext context_;
  Top top_;
  host::TimedTop<Top> run_;
  bool high_ = false;

 public:
  host::DviMonitor monitor;
  SlowMemory<Top, Pixel, Beat> memory;
};
using Words = Board<Vdisplay_of_words, WordPixel, 32>;
using Halves = Board<Vdisplay_of_halves, HalfPixel, 2>;

/// The picture in the middle of the display, black around.
template <class Pixel>
std::vector<std::uint32_t> on_display(unsigned base, unsigned width, unsigned height) {
  std::vector<std::uint32_t> pixels(kMode.hdisplay * kMode.vdisplay, 0);
  const unsigned left = (kMode.hdisplay - width) / 2;
  const unsigned top = (kMode.vdisplay - height) / 2;
  for (unsigned y = 0; y < height; ++y) {
    for (unsigned x = 0; x < width; ++x) {
      pixels[(y + top) * kMode.hdisplay + x + left] =
          colour_of<Pixel>(base + y * row_pitch(width) + x);
    }
  }
  return pixels;
}

template <class B>
class PictureTest : public testing::Test {};
using Boards = testing::Types<Words, Halves>;
TYPED_TEST_SUITE(PictureTest, Boards);

TYPED_TEST(PictureTest, IsShownFromAMemoryThatKeepsUp) {
  for (const auto& [width, height] : {std::pair{60u, 40u}, {37u, 29u}, {1u, 1u}, {9u, 40u}}) {
    SCOPED_TRACE(width);
    TypeParam board(9'000);
    board.show(4096, width, height);
    board.run(4 * kDisplay + kDisplay / 8);
    EXPECT_EQ(board.monitor.waits_for(), "");
    ASSERT_EQ(board.monitor.frames().size(), 3u);
    for (const DisplayFrame& frame : board.monitor.frames()) {
      EXPECT_EQ(frame.fault, "");
      EXPECT_EQ(frame.pixels, (on_display<typename TypeParam::Pixel>(4096, width, height)));
    }
    EXPECT_EQ(board.top().underrun_o, 0);
    EXPECT_EQ(board.top().starved_o, 0);
  }
}

TYPED_TEST(PictureTest, ChangesInTheBlankOnly) {
  TypeParam board(9'000);
  unsigned base = 0;
  for (unsigned i = 0; i < 9; ++i) {
    board.show(base, 60, 40);
    board.run(kDisplay);
    base += 16'000;
  }
  ASSERT_EQ(board.monitor.frames().size(), 8u);
  // A base that is set before the blank is shown after it.
  std::vector<std::vector<std::uint32_t>> expected;
  for (unsigned i = 0; i < 9; ++i) {
    expected.push_back(on_display<typename TypeParam::Pixel>(16'000 * i, 60, 40));
  }
  for (unsigned i = 0; i < 8; ++i) {
    EXPECT_EQ(board.monitor.frames()[i].fault, "");
    EXPECT_EQ(board.monitor.frames()[i].pixels, expected[i]) << i;
  }
  EXPECT_EQ(board.top().underrun_o, 0);
}

TYPED_TEST(PictureTest, TellsOfAnUnderrunAndFindsItsPlaceAgain) {
  TypeParam board(9'000);
  board.memory.manners.pause = 4'000;  // longer than what is read ahead
  board.show(0, 60, 40);
  board.run(40 * kDisplay);
  EXPECT_EQ(board.top().underrun_o, 1);
  EXPECT_EQ(board.top().starved_o, 0);
  const auto picture = on_display<typename TypeParam::Pixel>(0, 60, 40);
  unsigned whole = 0;
  unsigned damaged = 0;
  unsigned found_again = 0;
  for (const DisplayFrame& frame : board.monitor.frames()) {
    ASSERT_EQ(frame.fault, "");
    (frame.pixels == picture ? whole : damaged) += 1;
    for (std::size_t i = 0; i < picture.size(); ++i) {
      ASSERT_TRUE(frame.pixels[i] == picture[i] || frame.pixels[i] == 0) << i;
      found_again += i > 0 && frame.pixels[i] != 0 && frame.pixels[i - 1] != picture[i - 1];
    }
  }
  EXPECT_GT(whole, 3u);
  EXPECT_GT(damaged, 3u);
  EXPECT_GT(found_again, 0u) << "black until the next picture";
  // Switched off and on, it forgets.
  board.memory.manners.pause = 0;
  board.run(2 * kDisplay);
  board.top().on_i = 0;
  board.run(3 * 9'000);
  EXPECT_EQ(board.top().underrun_o, 0);
  board.monitor = {};
  board.show(0, 60, 40);
  board.run(3 * kDisplay);
  EXPECT_EQ(board.top().underrun_o, 0);
  ASSERT_GE(board.monitor.frames().size(), 1u);
  for (const DisplayFrame& frame : board.monitor.frames()) EXPECT_EQ(frame.pixels, picture);
}

TYPED_TEST(PictureTest, SwitchesOffAndOnWhileReadsAreUnderWay) {
  TypeParam board(9'000);
  board.memory.manners.latency = 60;
  std::mt19937 random(3);
  const auto picture = on_display<typename TypeParam::Pixel>(160, 60, 40);
  for (unsigned i = 0; i < 12; ++i) {
    board.monitor = {};
    board.show(160, 60, 40);
    board.run(3 * kDisplay + random() % kDisplay);
    EXPECT_EQ(board.top().underrun_o, 0);
    ASSERT_GE(board.monitor.frames().size(), 1u);
    for (const DisplayFrame& frame : board.monitor.frames()) {
      EXPECT_EQ(frame.fault, "");
      EXPECT_EQ(frame.pixels, picture);
    }
    board.top().on_i = 0;
    board.run(10'000);
  }
}

}  // namespace
}  // namespace dynrt::verif
