// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/vga_monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dynrt::host {
namespace {

using testing::HasSubstr;

constexpr DisplayMode kMode = {8, 9, 12, 14, 5, 6, 8, 9, false, true};
constexpr unsigned kPixels = kMode.htotal * kMode.vtotal;

struct Pins {
  bool hsync, vsync, visible;
  std::uint32_t colour;
  unsigned clocks = 3;  ///< that the pixel takes
};

/// Displays from their top left corner on, each visible pixel with a colour of its own.
class Signal {
 public:
  explicit Signal(unsigned displays) {
    for (unsigned i = 0; i < displays * kPixels; ++i) {
      const unsigned column = i % kMode.htotal;
      const unsigned line = i / kMode.htotal % kMode.vtotal;
      const bool hpulse = column >= kMode.hsync_start && column < kMode.hsync_end;
      const bool vpulse = line >= kMode.vsync_start && line < kMode.vsync_end;
      const bool visible = column < kMode.hdisplay && line < kMode.vdisplay;
      pins.push_back({hpulse == kMode.positive_hsync, vpulse == kMode.positive_vsync, visible,
                      visible ? 0x010000 + 100 * line + column : 0});
    }
  }
  std::vector<DisplayFrame> frames() const {
    VgaMonitor monitor(kMode.positive_hsync, kMode.positive_vsync);
    for (const Pins& p : pins) {
      for (unsigned clock = 0; clock < p.clocks; ++clock) {
        monitor.sample(clock > 0, p.hsync, p.vsync, p.visible, p.colour);
      }
    }
    return monitor.frames();
  }
  std::vector<Pins> pins;
};

TEST(VgaMonitor, MeasuresModeAndPicture) {
  const std::vector<DisplayFrame> frames = Signal(4).frames();
  ASSERT_EQ(frames.size(), 3u);  // the pulses of four displays begin three whole ones
  for (const DisplayFrame& frame : frames) {
    EXPECT_EQ(frame.fault, "");
    EXPECT_EQ(frame.mode, kMode);
    EXPECT_EQ(frame.pixel_time, 3u);
    ASSERT_EQ(frame.pixels.size(), kMode.hdisplay * kMode.vdisplay);
    for (unsigned i = 0; i < frame.pixels.size(); ++i) {
      ASSERT_EQ(frame.pixels[i], 0x010000 + 100 * (i / kMode.hdisplay) + i % kMode.hdisplay);
    }
  }
}

/// What the monitor says of a display with one pixel's pins changed.
template <class Change>
std::string fault_of(unsigned column, unsigned line, Change change) {
  Signal signal(3);
  change(signal.pins[kPixels + line * kMode.htotal + column]);
  const std::vector<DisplayFrame> frames = signal.frames();
  EXPECT_EQ(frames.size(), 2u);
  return frames.empty() ? "" : frames.front().fault;
}

TEST(VgaMonitor, SaysWhatIsIrregular) {
  EXPECT_THAT(fault_of(3, 2, [](Pins& p) { p.hsync = false; }), HasSubstr("has its pulse from"));
  EXPECT_THAT(fault_of(10, 2, [](Pins& p) { p.hsync = true; }), HasSubstr("has its pulse from"));
  EXPECT_THAT(fault_of(9, 0, [](Pins& p) { p.hsync = true; }), HasSubstr("has its pulse from"));
  EXPECT_THAT(fault_of(3, 2, [](Pins& p) { p.visible = false; }),
              HasSubstr("do not form a rectangle"));
  EXPECT_THAT(fault_of(9, 2, [](Pins& p) { p.visible = true; }),
              HasSubstr("do not form a rectangle"));
  EXPECT_EQ(fault_of(9, 2, [](Pins& p) { p.colour = 1; }),
            "pixel 79 has a colour but lies in the blanking");
  EXPECT_THAT(fault_of(3, 2, [](Pins& p) { p.clocks = 4; }), HasSubstr("comes after 3 clocks"));
}

TEST(VgaMonitor, AnotherModeMeasuresOtherwise) {
  // The wrong polarity turns pulse and rest about.
  VgaMonitor monitor(!kMode.positive_hsync, kMode.positive_vsync);
  for (const Pins& p : Signal(3).pins) {
    monitor.sample(false, p.hsync, p.vsync, p.visible, p.colour);
    monitor.sample(true, p.hsync, p.vsync, p.visible, p.colour);
  }
  ASSERT_FALSE(monitor.frames().empty());
  EXPECT_NE(monitor.frames().front().mode, kMode);
}

TEST(VgaMonitor, SaysThatNothingIsVisible) {
  Signal signal(3);
  for (Pins& p : signal.pins) p.visible = false, p.colour = 0;
  EXPECT_EQ(signal.frames().front().fault, "no pixel is visible");
}

}  // namespace
}  // namespace dynrt::host
