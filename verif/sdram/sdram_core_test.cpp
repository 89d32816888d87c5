// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Frames of the native core with an SDRAM behind its port: the pixels are those of the emulated
// memory, and nothing that the data sheet forbids is found. The slow test prints how much of the
// memory's peak whole frames use, and what they cost; docs/explanation/sdram.md has its figures.
#include <gtest/gtest.h>

#include <cstdlib>

#include "configs/fast_port.h"
#include "core/scenes.h"
#include "host/board/native_core.h"
#include "host/format/core_info.h"
#include "host/render/compare.h"
#include "host/render/render.h"
#include "sdram/sdram_memory.h"
#include "sdram/sdram_stages.h"

namespace dynrt::verif {
namespace {

using C = config::fast_port;
using S = Sdram133;
using Bench = SdramBench<kBeatBytes<C>>;
using host::Frame;
using host::FrameOptions;

/// Clocks of `fast` placed and routed (README.md), and a display of 640x480 at 60 Hz, 16 bits.
constexpr double kCoreNanoseconds = 1000 / 104.8;
constexpr double kDisplayBytes = 640. * 480 * 2 * 60;

Frame rendered(const std::string& scene, FrameOptions options,
               const CoreModel<C>::MakeMemory& memory) {
  host::CoreInfo info = host::core_info_of<C>();
  info.name = "fast_port";
  auto core = std::make_unique<host::NativeCoreOf<C>>();
  if (memory) core->model().set_memory(memory);
  host::ModelBoard board(std::move(info), std::move(core), FAST_PORT_SCHEDULES);
  const host::MemoryImage image =
      host::laid_out(scene, options.width, options.height, board.core());
  return host::render(board, options, image);
}

struct WithSdram {
  Frame frame;
  SdramUse use;
  std::string report;
};
WithSdram rendered(const std::string& scene, const FrameOptions& options,
                   const SdramSystem& system) {
  SdramPart part = kAnySdram;
  part.pause = 2 * SdramMemory<C, S>::kPauseTurns * S::kClockPicoseconds;
  Bench bench(SdramChip(part, S::kClockPicoseconds));
  WithSdram result;
  const auto memory = [&](Core<C>& core, Banks<C>& banks) -> std::unique_ptr<hls::Device> {
    return std::make_unique<SdramMemory<C, S>>(core.read, core.beat, core.write, banks, system,
                                               stages_of(SDRAM_133_SCHEDULE), bench, result.use);
  };
  result.frame = rendered(scene, options, memory);
  result.report = bench.report();
  return result;
}

FrameOptions of_size(unsigned width, unsigned height, bool hits) {
  FrameOptions options;
  options.width = width;
  options.height = height;
  options.hits = hits;
  return options;
}

TEST(SdramCore, HasTheSamePicture) {
  for (const char* scene : {"office", "trees4000"}) {
    const FrameOptions options = of_size(64, 48, true);
    const Frame expected = rendered(scene, options, CoreModel<C>::MakeMemory{});
    const WithSdram sdram = rendered(
        scene, options, {.core_nanoseconds = kCoreNanoseconds, .display_bytes = kDisplayBytes});
    EXPECT_EQ(sdram.report, "");
    const host::Comparison comparison = host::compare(sdram.frame, expected);
    EXPECT_GT(comparison.hits, comparison.pixels / 8) << scene;
    EXPECT_TRUE(comparison.identical()) << scene;
    EXPECT_GT(sdram.use.core_writes, 64u * 48 * 4);
  }
}

struct Size {
  unsigned width, height;
};
void print_row(const std::string& scene, Size size, const SdramSystem& system) {
  const FrameOptions options = of_size(size.width, size.height, false);
  const Frame emulated = rendered(scene, options, CoreModel<C>::MakeMemory{});
  const WithSdram sdram = rendered(scene, options, system);
  ASSERT_EQ(sdram.report, "");
  EXPECT_EQ(sdram.frame.pixels, emulated.pixels);
  const SdramUse& use = sdram.use;
  const auto clocks = static_cast<double>(*sdram.frame.run.cycles);
  const double microseconds = clocks * system.core_nanoseconds / 1000;
  const auto percent = [](auto part, auto whole) {
    return 100 * static_cast<double>(part) / static_cast<double>(whole);
  };
  const auto rate = [&](std::uint64_t bytes) { return static_cast<double>(bytes) / microseconds; };
  fmt::print(
      "| `{}` | {:.1f} | {:.1f} % | {:.0f} | {:.0f} | {:.0f} | {:.1f} % | {:.2f} | {:.0f} |\n",
      scene, 1e6 / microseconds, percent(*emulated.run.cycles, clocks), rate(use.core_reads),
      rate(use.core_writes), rate(use.display_reads), percent(use.chip.busy(), use.chip.clocks),
      percent(use.chip.activations, use.bursts) / 100,
      use.read_nanoseconds / static_cast<double>(use.reads));
  std::fflush(stdout);
}

TEST(SdramCore, SlowSharesOfThePeak) {
  const char* small = std::getenv("SDRAM_SMALL_FRAMES");
  const Size size = small != nullptr ? Size{128, 96} : Size{512, 384};
  fmt::print(
      "| | frames per second | of those with the emulated memory | MB/s read | written | displayed "
      "| of the peak | rows opened per burst | ns of a read |\n");
  for (const char* scene : {"office", "cistern", "conference", "trees4000"}) {
    print_row(scene, size, {.core_nanoseconds = kCoreNanoseconds, .display_bytes = kDisplayBytes});
  }
}

}  // namespace
}  // namespace dynrt::verif
