// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/sram.h"

#include <gtest/gtest.h>

namespace dynrt::host {
namespace {

TEST(Sram, DataArrivesAfterItsLatency) {
  for (unsigned latency = 1; latency <= 4; ++latency) {
    Sram sram(latency);
    for (std::uint32_t i = 0; i < 8; ++i) {
      sram.access(2, true, i, 100 + i);
      sram.advance();
    }
    for (std::uint32_t clock = 0; clock < 8; ++clock) {
      sram.access(2, false, clock, 0);
      const std::uint32_t data = sram.advance()[2];
      if (clock + 1 >= latency) EXPECT_EQ(data, 100 + clock + 1 - latency) << latency;
    }
  }
}

TEST(Sram, ABankThatIsNotReadKeepsItsData) {
  Sram sram(2);
  sram.access(0, true, 5, 7);
  sram.advance();
  sram.access(0, false, 5, 0);
  sram.advance();
  sram.access(0, true, 5, 8);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(sram.advance()[0], 7u);
}

TEST(Sram, CountsWritesToTheFramebuffer) {
  Sram sram(1);
  sram.access(kFrameBank, true, 0, 1);
  sram.access(kFrameBank, false, 0, 1);
  sram.access(4, true, 0, 1);
  EXPECT_EQ(sram.frame_writes(), 2u) << "halves of words";
  sram.write_half(kFrameBank, 0, 0, 1);
  sram.write_half(kFrameBank, 0, 1, 1);
  sram.write_half(kFrameBank, 7, 1, 1);
  sram.write_half(kHitBank, 0, 0, 1);
  EXPECT_EQ(sram.frame_writes(), 5u);
  EXPECT_EQ(sram.word(kFrameBank, 0), 0x10001u);
}

}  // namespace
}  // namespace dynrt::host
