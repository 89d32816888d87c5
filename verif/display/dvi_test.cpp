// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The display from the scan-out to the pins of the DVI link, with the clocks that an ECP5's PLL
// makes, in each standard mode: a monitor that knows the pins alone finds the mode and the picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "Vdisplay_25.h"
#include "Vdisplay_40.h"
#include "host/board/display.h"
#include "host/board/dvi_monitor.h"
#include "host/board/timed_top.h"

namespace dynrt::verif {
namespace {

using host::DisplayFrame;
using host::DisplayMode;
using host::DviMonitor;
using host::StandardMode;
using Words = std::vector<std::uint32_t>;

constexpr unsigned kLatency = 3;  ///< of the bank, in clocks
constexpr unsigned kBase = 777;   ///< of the picture in it

std::uint32_t colour_of(unsigned word) { return word * 2654435761u >> 3 & 0xffffff; }

/// A display on a board whose bank holds a colour of its own in each word.
template <class Top>
class Board {
 public:
  explicit Board(unsigned core_period) : top_(&context_), run_(top_) {
    context_.randReset(2);
    run_.add_clock(top_.osc_i, 40'000);
    run_.add_clock(top_.clk_i, core_period);
    top_.rst_ni = 0;
    run(1'000'000);
    top_.rst_ni = 1;
  }
  ~Board() { top_.final(); }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  void configure(const DisplayMode& mode, unsigned base, unsigned width, unsigned height) {
    const auto config = host::scan_config(mode, base, width, height);
    unsigned word = 0;
    hls::for_each_leaf(config, [&](const hls::uint<32>& field, unsigned) {
      top_.config_i[word++] = static_cast<std::uint32_t>(field.to_u64());
    });
    top_.on_i = 1;
  }
  void run(std::uint64_t ps) {
    run_.run(ps, [this](std::uint64_t now) {
      monitor_.sample(now, {top_.dvi_p_o, top_.dvi_n_o});
      if (top_.clk_i != 0 && !high_) {
        answers_.push_back(top_.bank_en_o != 0 ? colour_of(top_.bank_addr_o) : 0xdeadbeef);
        if (answers_.size() > kLatency) {
          top_.bank_data_i = answers_.front();
          answers_.pop_front();
        }
      }
      high_ = top_.clk_i != 0;
    });
  }
  Top& top() { return top_; }
  const DviMonitor& monitor() const { return monitor_; }
  void renew_monitor() { monitor_ = {}; }

 private:
  VerilatedContext context_;
  Top top_;
  host::TimedTop<Top> run_;
  DviMonitor monitor_;
  std::deque<std::uint32_t> answers_;
  bool high_ = false;
};

/// The picture in the middle of the display, black around.
Words on_display(const DisplayMode& mode, unsigned base, unsigned width, unsigned height) {
  Words pixels(std::size_t{mode.hdisplay} * mode.vdisplay, 0);
  const unsigned left = (mode.hdisplay - width) / 2;
  const unsigned top = (mode.vdisplay - height) / 2;
  for (unsigned y = 0; y < height; ++y) {
    for (unsigned x = 0; x < width; ++x) {
      pixels[(y + top) * mode.hdisplay + x + left] = colour_of(base + y * width + x);
    }
  }
  return pixels;
}

/// Every frame that the monitor has seen has the picture in it.
template <class Top>
void expect_pictures(const Board<Top>& board, const StandardMode& standard, unsigned width,
                     unsigned height, std::size_t frames) {
  EXPECT_EQ(board.monitor().waits_for(), "");
  ASSERT_EQ(board.monitor().frames().size(), frames);
  for (const DisplayFrame& frame : board.monitor().frames()) {
    EXPECT_EQ(frame.fault, "");
    EXPECT_EQ(frame.mode, standard.mode);
    EXPECT_EQ(frame.pixel_time, 1'000'000 / standard.link_mhz);
    EXPECT_EQ(frame.pixels, on_display(standard.mode, kBase, width, height));
  }
}

std::uint64_t time_of(const StandardMode& standard) {
  return std::uint64_t{standard.mode.htotal} * standard.mode.vtotal * 1'000'000 / standard.link_mhz;
}

template <class Top>
void expect_to_show(const StandardMode& standard, unsigned core_period, unsigned width,
                    unsigned height) {
  Board<Top> board(core_period);
  board.configure(standard.mode, kBase, width, height);
  const std::uint64_t display = time_of(standard);
  board.run(3 * display + display / 8);
  expect_pictures(board, standard, width, height, 2);
  EXPECT_EQ(board.top().starved_o, 0);
  EXPECT_EQ(board.top().frames_o, 3u);
}

TEST(DviDisplay, Shows640x480) { expect_to_show<Vdisplay_25>(host::k640x480, 10'000, 512, 384); }

TEST(DviDisplay, Shows800x600) { expect_to_show<Vdisplay_40>(host::k800x600, 8'330, 800, 600); }

/// As small as can be told from blanking.
constexpr StandardMode kSmall = {"60x40", {60, 64, 70, 90, 40, 41, 43, 46, true, false}, 25, 25};

TEST(DviDisplay, ShowsAPictureWhateverTheCoresClock) {
  for (const unsigned core_period : {5'001u, 7'000u, 13'337u, 20'000u, 39'000u}) {
    SCOPED_TRACE(core_period);
    expect_to_show<Vdisplay_25>(kSmall, core_period, 50, 31);
  }
}

TEST(DviDisplay, BeginsAnewWhenItIsSwitchedOnAgain) {
  Board<Vdisplay_25> board(9'000);
  for (unsigned i = 0; i < 3; ++i) {
    board.configure(kSmall.mode, kBase, 60, 40);
    board.run((3 + i) * time_of(kSmall) + i * 12'345'000);
    expect_pictures(board, kSmall, 60, 40, 2 + i);
    EXPECT_EQ(board.top().starved_o, 0);
    board.top().on_i = 0;
    board.run(10'000);  // a clock
    EXPECT_EQ(board.top().running_o, 0);
    board.renew_monitor();
  }
}

TEST(DviDisplay, TellsThatTheLinkHasStarved) {
  Board<Vdisplay_25> board(60'000);  // fewer clocks than pixels
  board.configure(kSmall.mode, kBase, 60, 40);
  board.run(8 * time_of(kSmall));
  EXPECT_EQ(board.top().starved_o, 1);
  for (const DisplayFrame& frame : board.monitor().frames()) EXPECT_NE(frame.fault, "");
}

}  // namespace
}  // namespace dynrt::verif
