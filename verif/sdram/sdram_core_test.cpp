// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Frames of the native core with an SDRAM behind its port: the pixels are those of the emulated
// memory, and nothing that the data sheet forbids is found. dynrt report board measures such
// frames.
#include <gtest/gtest.h>

#include "configs/fast_port.h"
#include "host/render/compare.h"
#include "sdram/sdram_frame.h"

namespace dynrt::verif {
namespace {

using C = config::fast_port;

/// A clock near that of `fast` placed and routed.
constexpr double kCoreNanoseconds = 1000 / 104.8;
constexpr unsigned kWidth = 64, kHeight = 48;

SdramFrame rendered(const char* scene, const host::FrameOptions& options) {
  const SdramSystem system{.core_nanoseconds = kCoreNanoseconds, .display_bytes = kDisplayed<C>};
  return sdram_frame<C, Sdram133>(host::core_info_of_listed<C>("fast_port"), scene, options, system,
                                  {FAST_PORT_SCHEDULES, SDRAM_133_SCHEDULE});
}

TEST(SdramCore, HasTheSamePicture) {
  for (const char* scene : {"office", "trees4000"}) {
    const host::FrameOptions options{.width = kWidth, .height = kHeight};
    const host::Frame expected = native_frame<C>(host::core_info_of_listed<C>("fast_port"), scene,
                                                 options, FAST_PORT_SCHEDULES);
    const SdramFrame sdram = rendered(scene, options);
    EXPECT_EQ(sdram.report, "");
    const host::Comparison comparison = host::compare(sdram.frame, expected);
    EXPECT_GT(comparison.hits, comparison.pixels / 8) << scene;
    EXPECT_TRUE(comparison.identical()) << scene;
    EXPECT_GT(sdram.use.core_writes, kWidth * kHeight * 2);
  }
}

TEST(SdramCore, CountsWhatAFrameMoves) {
  const host::FrameOptions options{.width = kWidth, .height = kHeight, .hits = false};
  const SdramFrame sdram = rendered("office", options);
  const SdramUse& use = sdram.use;
  EXPECT_EQ(use.core_writes, kWidth * kHeight * 2);
  // Each part is read, and every byte is of one of them.
  for (const std::uint64_t bytes : use.core_reads_of) EXPECT_GT(bytes, 1000u);
  EXPECT_EQ(use.core_reads_of[0] + use.core_reads_of[1] + use.core_reads_of[2], use.core_reads);
  // The data pins carry what was asked for, but for the bursts that are under way at the end.
  EXPECT_GE(2 * use.chip.busy() + 1024, use.core_reads + use.core_writes + use.display_reads);
  EXPECT_GT(use.idle_clocks, use.chip.clocks / 20);
  EXPECT_LT(use.idle_clocks + use.chip.busy(), use.chip.clocks);
}

}  // namespace
}  // namespace dynrt::verif
