// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board's scan-out around the stand-in core of test/dynrt_core.v, which writes a pixel every
// two clocks, the fastest that shading does: what a monitor makes of the pins is what lies in bank
// 3, whatever core and host do meanwhile. The board is the one that checks the Verilog's
// assertions.
#include "host/board/display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "host/board/registers.h"
#include "host/board/test/named.h"
#include "host/error.h"
#include "host/format/frame_words.h"

namespace dynrt::host {

std::unique_ptr<ClockedBoard> make_stand_in_board_traced(const std::string& trace, int seed);

namespace {

namespace reg = registers;
using testing::ThrowsMessage;

constexpr DisplayMode kMode = {28, 30, 33, 36, 14, 15, 17, 20, false, true};
constexpr unsigned kWidth = 24;
constexpr unsigned kHeight = 10;
constexpr unsigned kPixels = kWidth * kHeight;
constexpr std::uint32_t kFront = 1000;
constexpr std::uint32_t kBack = 70'000;

using Words = std::vector<std::uint32_t>;

Words random_words(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  Words words(count);
  for (auto& word : words) word = static_cast<std::uint32_t>(random()) & 0xffffff;
  return words;
}

/// The display with the picture in its middle and black around.
Words on_display(const Words& picture) {
  Words pixels(kMode.hdisplay * kMode.vdisplay, 0);
  for (unsigned y = 0; y < kHeight; ++y) {
    for (unsigned x = 0; x < kWidth; ++x)
      pixels[(y + 2) * kMode.hdisplay + x + 2] = picture[y * kWidth + x];
  }
  return pixels;
}

class DisplayTest : public testing::Test {
 protected:
  void expect_shows(const DisplayFrame& frame, const Words& picture, unsigned clocks_per_pixel) {
    EXPECT_EQ(frame.fault, "");
    EXPECT_EQ(frame.mode, kMode);
    EXPECT_EQ(frame.pixel_time, clocks_per_pixel);
    EXPECT_EQ(frame.pixels, on_display(picture));
  }
  /// The stand-in's picture is bank 0 ^ bank 1.
  void start(const Words& picture, std::uint32_t base) {
    board_.write(0, 0, picture);
    board_.write(1, 0, Words(kPixels, 0));
    FrameConfig frame;
    frame.packets = to_word(4);
    frame.line_mask = to_word(15);
    frame.width = to_word(kWidth);
    frame.height = to_word(kHeight);
    frame.frame_base = to_word(base);
    frame.scanline = to_word(1);
    board_.configure(frame);
    board_.start();
  }
  std::uint64_t render(const Words& picture, std::uint32_t base) {
    start(picture, base);
    return *board_.wait(100'000, {}).cycles;
  }
  Words read(std::uint32_t base) {
    Words words(kPixels);
    board_.read(kFrameBank, base, words);
    return words;
  }

  RtlBoard board_{named("stand_in"), make_stand_in_board_traced("", 1), {}};
};

TEST_F(DisplayTest, ShowsThePictureAtEveryPixelClock) {
  const Words picture = random_words(kPixels, 1);
  board_.write(kFrameBank, kFront, picture);
  for (const unsigned clocks : {2u, 3u, 4u, 255u}) {
    SCOPED_TRACE(clocks);
    Display display(board_, kMode, clocks, kFront, kWidth, kHeight);
    expect_shows(display.wait(1), picture, clocks);
    expect_shows(display.wait(1), picture, clocks);
    EXPECT_EQ(display.shown(), kFront);
    EXPECT_GE(board_.read_register(reg::kRegScanFrames), 2u);
  }
}

TEST_F(DisplayTest, GoesOnWhileTheCoreWritesTheOtherBuffer) {
  const Words first = random_words(kPixels, 1);
  const Words second = random_words(kPixels, 2);
  const std::uint64_t alone = render(first, kFront);
  for (const unsigned clocks : {2u, 3u, 4u, 5u, 7u}) {
    SCOPED_TRACE(clocks);
    render(first, kFront);
    Display display(board_, kMode, clocks, kFront, kWidth, kHeight);
    display.wait(1);
    EXPECT_EQ(render(second, kBack), alone);  // the core has not been kept waiting
    display.wait(1);
    for (const DisplayFrame& frame : display.frames()) expect_shows(frame, first, clocks);
    EXPECT_EQ(read(kFront), first);
    EXPECT_EQ(read(kBack), second);

    display.show(kBack);
    while (display.shown() != kBack) expect_shows(display.wait(1), first, clocks);
    display.wait(1);
    expect_shows(display.wait(1), second, clocks);
    board_.write(kFrameBank, kBack, Words(kPixels, 0));
  }
}

TEST_F(DisplayTest, MakesTheHostWaitAndNotTheDisplay) {
  const Words picture = random_words(kPixels, 1);
  const Words other = random_words(kPixels, 2);
  board_.write(kFrameBank, kFront, picture);
  Display display(board_, kMode, 2, kFront, kWidth, kHeight);
  while (display.frames().size() < 4) {
    board_.write(kFrameBank, kBack, other);
    ASSERT_EQ(read(kFront), picture);
    ASSERT_EQ(read(kBack), other);
  }
  for (const DisplayFrame& frame : display.frames()) expect_shows(frame, picture, 2);
}

TEST_F(DisplayTest, APixelThatIsWrongIsSeen) {
  const Words picture = random_words(kPixels, 1);
  board_.write(kFrameBank, kFront, picture);
  Display display(board_, kMode, 2, kFront, kWidth, kHeight);
  display.wait(1);
  board_.write(kFrameBank, kFront + 77, Words{picture[77] ^ 1});
  display.wait(1);
  EXPECT_NE(display.wait(1).pixels, on_display(picture));
}

TEST_F(DisplayTest, IsDarkWhenSwitchedOff) {
  {
    Display display(board_, kMode, 2, kFront, kWidth, kHeight);
  }
  VgaMonitor monitor(false, true);
  board_.watch(&monitor);
  board_.idle(10'000);
  EXPECT_TRUE(monitor.frames().empty());
  EXPECT_EQ(board_.read_register(reg::kRegScanFrames), 0u);
  board_.watch(nullptr);
}

TEST_F(DisplayTest, KeepsItsRegistersAndTakesThemDuringAFrame) {
  start(Words(kPixels, 0), kFront);
  for (std::uint32_t i = 0; i < 16; ++i) board_.write_register(reg::kRegScan + 4 * i, 100 + i);
  for (std::uint32_t i = 0; i < 16; ++i) {
    EXPECT_EQ(board_.read_register(reg::kRegScan + 4 * i), i < kScanWords ? 100 + i : 0) << i;
  }
  board_.wait(100'000, {});  // nothing was refused
}

TEST_F(DisplayTest, RefusesWhatItCannotShow) {
  EXPECT_THAT(([&] { Display(board_, kMode, 2, 0, 29, 10); }),
              ThrowsMessage<UserError>("a picture of 29x10 does not fit the display of 28x14; "
                                       "render a smaller one"));
}

}  // namespace
}  // namespace dynrt::host
