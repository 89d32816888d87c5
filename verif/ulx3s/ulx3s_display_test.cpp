// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The display of the ULX3S in each of its modes: pictures as large as the display, from the SDRAM
// to the DVI pins, on a board without a core.
#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "Vulx3s_25.h"
#include "Vulx3s_40.h"
#include "host/board/display_mode.h"
#include "host/ulx3s/board_at_link.h"
#include "host/ulx3s/linked_board.h"
#include "ulx3s/verilated_ulx3s.h"
#include "units/memory_format.h"
#include "units/pixel.h"

namespace dynrt::host {
namespace {

constexpr unsigned kMissed = 1u << 5;  ///< of the board's lights
constexpr unsigned kRunning = 1u << 4;

/// A picture of any colours, which is written to the memory and found at the pins.
template <class Top>
void expect_to_show(const StandardMode& standard, double clock_hz) {
  auto owned = std::make_unique<VerilatedUlx3s<Top>>();
  VerilatedUlx3s<Top>& ulx3s = *owned;
  auto link = std::make_unique<BoardLink>(std::move(owned));
  EXPECT_EQ(link->board().pixel_mhz, standard.link_mhz);
  EXPECT_EQ(link->board().clock_hz, clock_hz);
  const LinkedCore& core = linked_core(*link, "ulx3s");
  auto linked = std::make_unique<LinkedBoard>(std::move(link), &ulx3s, [] {});
  BoardAtLink board("ulx3s", core, std::move(linked), &ulx3s);

  std::mt19937 random(7);
  FrameConfig frame;
  frame.width = hls::uint<32>::from(standard.mode.hdisplay);
  frame.height = hls::uint<32>::from(standard.mode.vdisplay);
  // Two pictures fit. This is the second one, which begins with the upper half of the pixels.
  constexpr std::uint32_t kBase = 1u << 19;
  std::vector<std::uint8_t> bytes(std::size_t{2} * standard.mode.hdisplay * standard.mode.vdisplay);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  ulx3s.write(kPixelsAt + 2 * kBase, bytes);
  std::vector<std::uint32_t> expected(bytes.size() / 2), shown(expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto bits = uint<16>::from(unsigned{bytes[2 * i]} | unsigned{bytes[2 * i + 1]} << 8);
    expected[i] = static_cast<std::uint32_t>(HalfPixel::colour(bits).to_u64());
  }
  frame.frame_base = hls::uint<32>::from(kBase);
  board.configure(frame);
  board.read_pixels(kBase, shown);
  EXPECT_TRUE(shown == expected);
  EXPECT_EQ(ulx3s.lights() & (kMissed | kRunning), kRunning);
}

TEST(Ulx3sDisplay, Shows640x480) { expect_to_show<Vulx3s_25>(k640x480, 62.5e6); }

TEST(Ulx3sDisplay, Shows800x600) { expect_to_show<Vulx3s_40>(k800x600, 60e6); }

}  // namespace
}  // namespace dynrt::host
