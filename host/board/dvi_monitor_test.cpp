// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/dvi_monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace dynrt::host {
namespace {

using testing::HasSubstr;

constexpr DisplayMode kMode = {8, 10, 20, 28, 5, 6, 8, 9, false, true};
constexpr unsigned kPixels = kMode.htotal * kMode.vtotal;
constexpr unsigned kPeriod = 40'000;

/// A pixel as its three characters: blue, green, red.
using Characters = std::array<unsigned, 3>;

std::uint32_t colour_at(unsigned column, unsigned line) {
  return 0x332211u * (1 + column) + 0x010704u * line & 0xffffff;
}

/// Displays from their top left corner on, bit by bit.
class Signal {
 public:
  explicit Signal(unsigned displays, bool keeps_disparity = true) {
    std::array<tmds::Channel, 3> channels;
    for (unsigned i = 0; i < displays * kPixels; ++i) {
      const unsigned column = i % kMode.htotal;
      const unsigned line = i / kMode.htotal % kMode.vtotal;
      const bool hpulse = column >= kMode.hsync_start && column < kMode.hsync_end;
      const bool vpulse = line >= kMode.vsync_start && line < kMode.vsync_end;
      if (column < kMode.hdisplay && line < kMode.vdisplay) {
        const std::uint32_t colour = colour_at(column, line);
        Characters c{};
        for (unsigned n = 0; n < 3; ++n) {
          if (!keeps_disparity) channels[n] = {};
          c[n] = channels[n].encode(colour >> (16 - 8 * n) & 0xff);
        }
        characters.push_back(c);
      } else {
        const unsigned syncs =
            (hpulse == kMode.positive_hsync ? 1u : 0u) | (vpulse == kMode.positive_vsync ? 2u : 0u);
        characters.push_back({tmds::kControl[syncs], tmds::kControl[0], tmds::kControl[0]});
        channels = {};
      }
    }
  }

  /// What a monitor sees; `change` may turn the pins of a bit of a pixel about.
  DviMonitor monitor(const std::function<void(unsigned pixel, unsigned bit, DviPins&)>& change =
                         [](unsigned, unsigned, DviPins&) {}) const {
    DviMonitor monitor;
    std::uint64_t time = 12'345;
    for (unsigned i = 0; i < characters.size(); ++i) {
      for (unsigned bit = 0; bit < 10; ++bit) {
        DviPins pins;
        pins.positive = bit < 5 ? 8 : 0;
        for (unsigned n = 0; n < 3; ++n) {
          // A channel that is late sends the end of the pixel before.
          const unsigned sent = 10 * (i + 1) + bit - late[n];
          if (sent < 10) continue;
          pins.positive |= (characters[sent / 10 - 1][n] >> sent % 10 & 1) << n;
        }
        pins.negative = ~pins.positive & 15;
        change(i, bit, pins);
        monitor.sample(time, pins);
        time += period_of(i) / 10;
      }
    }
    return monitor;
  }

  std::vector<Characters> characters;
  std::array<unsigned, 3> late{};  ///< bits that each channel lags behind the clock pair
  std::function<unsigned(unsigned pixel)> period_of = [](unsigned) { return kPeriod; };
};

void expect_pictures(const DviMonitor& monitor, std::size_t frames) {
  EXPECT_EQ(monitor.waits_for(), "");
  ASSERT_EQ(monitor.frames().size(), frames);
  for (const DisplayFrame& frame : monitor.frames()) {
    EXPECT_EQ(frame.fault, "");
    EXPECT_EQ(frame.mode, kMode);
    EXPECT_EQ(frame.pixel_time, kPeriod);
    ASSERT_EQ(frame.pixels.size(), kMode.hdisplay * kMode.vdisplay);
    for (unsigned i = 0; i < frame.pixels.size(); ++i) {
      ASSERT_EQ(frame.pixels[i], colour_at(i % kMode.hdisplay, i / kMode.hdisplay)) << i;
    }
  }
}

TEST(DviMonitor, MeasuresModeAndPicture) { expect_pictures(Signal(4).monitor(), 3); }

TEST(DviMonitor, FindsWhereCharactersBegin) {
  for (unsigned late = 0; late < 10; ++late) {
    Signal signal(4);
    signal.late = {late, late, late};
    SCOPED_TRACE(late);
    expect_pictures(signal.monitor(), 3);
  }
  Signal apart(4);
  apart.late = {0, 4, 9};
  expect_pictures(apart.monitor(), 3);
}

TEST(DviMonitor, SaysThatAChannelIsAPixelLate) {
  Signal signal(4);
  signal.late = {0, 10, 0};
  ASSERT_FALSE(signal.monitor().frames().empty());
  EXPECT_THAT(signal.monitor().frames()[0].fault, HasSubstr("green is blanked, blue is visible"));
}

std::string fault_of(const DviMonitor& monitor) {
  EXPECT_FALSE(monitor.frames().empty());
  return monitor.frames().empty() ? "" : monitor.frames().front().fault;
}

TEST(DviMonitor, HoldsCharactersAgainstTheSpecification) {
  EXPECT_THAT(fault_of(Signal(3, false).monitor()), HasSubstr("at the disparity"));

  Signal flipped(3);
  flipped.characters[kPixels + kMode.htotal + 4][2] ^= 1;
  EXPECT_THAT(fault_of(flipped.monitor()), HasSubstr(": red sends the character "));
  EXPECT_THAT(fault_of(flipped.monitor()), HasSubstr("of line "));

  Signal preamble(3);
  preamble.characters[kPixels + kMode.hdisplay + 1][1] = tmds::kControl[1];
  EXPECT_THAT(fault_of(preamble.monitor()),
              HasSubstr("green has the control signals 1; a DVI link"));
}

TEST(DviMonitor, SaysThatChannelsAreSwapped) {
  Signal swapped(4);
  for (Characters& c : swapped.characters) std::swap(c[0], c[2]);
  const DviMonitor monitor = swapped.monitor();
  EXPECT_TRUE(monitor.frames().empty());  // blue has no syncs, so no frame begins
  Signal other(4);
  for (Characters& c : other.characters) std::swap(c[1], c[2]);
  EXPECT_EQ(fault_of(other.monitor()), "");
  EXPECT_EQ(other.monitor().frames()[0].pixels[0], (colour_at(0, 0) & 0xff) << 8 |
                                                       (colour_at(0, 0) >> 8 & 0xff) |
                                                       (colour_at(0, 0) & 0xff0000));
}

TEST(DviMonitor, LooksAtBothWiresOfAPair) {
  const DviMonitor monitor = Signal(3).monitor([](unsigned pixel, unsigned bit, DviPins& pins) {
    if (pixel == kPixels + 5 && bit == 3) pins.negative ^= 2;
  });
  EXPECT_THAT(fault_of(monitor), HasSubstr("both wires of green are "));
}

TEST(DviMonitor, MeasuresTheClockPair) {
  Signal signal(3);
  signal.period_of = [](unsigned pixel) { return pixel == kPixels + 5 ? kPeriod + 10 : kPeriod; };
  EXPECT_THAT(fault_of(signal.monitor()), HasSubstr("the clock rises after 40010 ps at "));
}

TEST(DviMonitor, SaysWhatItWaitsFor) {
  EXPECT_EQ(DviMonitor().waits_for(), "the clock pair has no period yet");
  Signal dark(1);
  for (Characters& c : dark.characters) c[1] = 0x1ff;
  EXPECT_THAT(dark.monitor().waits_for(), HasSubstr("green has sent no 12 characters of blanking"));
  Signal blank(1);
  for (Characters& c : blank.characters) c.fill(tmds::kControl[0]);
  EXPECT_EQ(blank.monitor().waits_for(), "no row of pixels has ended yet");
}

}  // namespace
}  // namespace dynrt::host
