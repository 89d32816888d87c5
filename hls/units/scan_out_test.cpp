// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/scan_out.h"

#include <optional>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<>;

/// A mode in small; the real one is 420,000 pixels.
struct Mode {
  unsigned hdisplay, hsync_start, hsync_end, htotal, vdisplay, vsync_start, vsync_end, vtotal;
  unsigned positive_syncs;
  unsigned width, height, left, top;
};
constexpr Mode kSmall = {20, 22, 27, 31, 12, 13, 15, 18, 0, 14, 9, 3, 2};
constexpr Mode kFilled = {16, 17, 18, 20, 10, 11, 12, 13, 3, 16, 10, 0, 0};
constexpr Mode kCropped = {16, 18, 19, 21, 10, 10, 11, 14, 1, 15, 13, 1, 0};
constexpr Mode k640x480 = {640, 656, 752, 800, 480, 490, 492, 525, 0, 512, 384, 64, 48};

class ScanOutTest : public testing::Test {
 protected:
  void set(const Mode& m, unsigned base) {
    bench_.value(bench_.unit.config) = {
        Word::from(base),          Word::from(m.width),         Word::from(m.height),
        Word::from(m.left),        Word::from(m.top),           Word::from(m.hdisplay),
        Word::from(m.hsync_start), Word::from(m.hsync_end),     Word::from(m.htotal),
        Word::from(m.vdisplay),    Word::from(m.vsync_start),   Word::from(m.vsync_end),
        Word::from(m.vtotal),      Word::from(m.positive_syncs)};
    for (unsigned a = 0; a < kBankWords; ++a) {
      bench_.rows(bench_.unit.bank)[a] = Word::from(a * 2654435761u);
    }
  }
  std::vector<ScanPixel> run(unsigned pixels, bool first = false) {
    for (unsigned i = 0; i < pixels; ++i) {
      bench_.feed(bench_.unit.tick, uint<1>(first && i == 0));
    }
    bench_.run();
    return bench_.take(bench_.unit.pixel);
  }
  uint<24> colour_at(unsigned word) {
    return bench_.rows(bench_.unit.bank)[word].template trunc<24>();
  }
  /// Pixels of one display, the picture at `base`; without one, black.
  std::vector<ScanPixel> display(const Mode& m, std::optional<unsigned> base) {
    std::vector<ScanPixel> pixels;
    for (unsigned line = 0; line < m.vtotal; ++line) {
      for (unsigned column = 0; column < m.htotal; ++column) {
        const bool visible = column < m.hdisplay && line < m.vdisplay;
        const bool lit = base && visible && column >= m.left && column < m.left + m.width &&
                         line >= m.top && line < m.top + m.height;
        const bool hpulse = column >= m.hsync_start && column < m.hsync_end;
        const bool vpulse = line >= m.vsync_start && line < m.vsync_end;
        pixels.push_back(
            {lit ? colour_at(*base + (line - m.top) * m.width + column - m.left) : uint<24>(0),
             (m.positive_syncs & 1) != 0 ? hpulse : !hpulse,
             (m.positive_syncs & 2) != 0 ? vpulse : !vpulse, visible});
      }
    }
    return pixels;
  }
  test::UnitBench<ScanOut<C>> bench_;
};

TEST_F(ScanOutTest, ShowsThePictureFromTheFirstVerticalBlankOn) {
  for (const Mode& mode : {kSmall, kFilled, kCropped, k640x480}) {
    SCOPED_TRACE(mode.hdisplay);
    set(mode, 1000);
    const unsigned total = mode.htotal * mode.vtotal;
    EXPECT_TRUE(test::same(run(total, true), display(mode, std::nullopt)));
    for (int frame = 0; frame < 2; ++frame) {
      EXPECT_TRUE(test::same(run(total), display(mode, 1000)));
    }
    EXPECT_TRUE(test::same(bench_.take(bench_.unit.shown), std::vector(3, uint<20>(1000))));
  }
}

TEST_F(ScanOutTest, HasTheTimingOf640x480At60Hz) {
  set(k640x480, 0);
  unsigned visible = 0;
  unsigned in_hsync = 0;
  unsigned in_vsync = 0;
  for (const ScanPixel& p : run(800 * 525, true)) {
    visible += p.visible;
    in_hsync += !p.hsync;
    in_vsync += !p.vsync;
  }
  EXPECT_EQ(visible, 640u * 480);
  EXPECT_EQ(in_hsync, 96u * 525);
  EXPECT_EQ(in_vsync, 2u * 800);
}

TEST_F(ScanOutTest, SwapsBuffersInTheVerticalBlankOnly) {
  set(kSmall, 1000);
  run(kSmall.htotal * kSmall.vtotal, true);
  for (const unsigned after : {0u, 5u, 150u, kSmall.vdisplay * kSmall.htotal}) {
    SCOPED_TRACE(after);
    const unsigned before = static_cast<unsigned>(bench_.value(bench_.unit.config).base.to_u64());
    const unsigned total = kSmall.htotal * kSmall.vtotal;
    std::vector<ScanPixel> pixels = run(after);
    bench_.value(bench_.unit.config).base = Word::from(before + 500);
    const std::vector<ScanPixel> rest = run(total - after);
    pixels.insert(pixels.end(), rest.begin(), rest.end());
    EXPECT_TRUE(test::same(pixels, display(kSmall, before)));
    EXPECT_TRUE(test::same(run(total), display(kSmall, before + 500)));
  }
}

TEST_F(ScanOutTest, TakesTheBaseInTheFirstPixelOfTheBlankAndTellsIt) {
  set(kSmall, 1000);
  run(kSmall.htotal * kSmall.vdisplay, true);
  bench_.value(bench_.unit.config).base = Word::from(2000);
  run(1);
  bench_.value(bench_.unit.config).base = Word::from(3000);
  EXPECT_TRUE(bench_.take(bench_.unit.shown).empty());
  run(1);
  EXPECT_EQ(bench_.take_one(bench_.unit.shown), uint<20>(2000));
  run(kSmall.htotal * (kSmall.vtotal - kSmall.vdisplay) - 2);
  EXPECT_TRUE(test::same(run(kSmall.htotal * kSmall.vtotal), display(kSmall, 2000)));
}

TEST_F(ScanOutTest, BeginsAnewWithAFirstPixel) {
  set(kSmall, 1000);
  run(1234, true);
  EXPECT_TRUE(test::same(run(kSmall.htotal * kSmall.vtotal, true), display(kSmall, std::nullopt)));
}

}  // namespace
}  // namespace dynrt
