// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/render.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/error.h"
#include "host/render/fake_board.h"
#include "units/memory_format.h"

namespace dynrt::host {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const CoreInfo kBoard = small_core();

auto configuring(const FrameOptions& options) {
  return [options] { frame_config(kBoard, options, {}); };
}

TEST(FrameConfig, TakesAllThatTheConfigurationHas) {
  const FrameConfig frame =
      frame_config(kBoard, {.width = 512, .height = 384}, {.start_node = 77, .camera_matrix = 99});
  EXPECT_EQ(frame.packets.to_u64(), 8u);
  EXPECT_EQ(frame.line_mask.to_u64(), 15u);
  EXPECT_EQ(frame.width.to_u64(), 512u);
  EXPECT_EQ(frame.height.to_u64(), 384u);
  EXPECT_EQ(frame.scanline.to_u64(), 0u);
  EXPECT_EQ(frame.start_node.to_u64(), 77u);
  EXPECT_EQ(frame.camera_matrix.to_u64(), 99u);
  EXPECT_EQ(frame.write_hits.to_u64(), 1u);
}

TEST(FrameConfig, MortonBitsCoverTheLargerSide) {
  const auto bits = [](unsigned width, unsigned height) {
    return frame_config(kBoard, {.width = width, .height = height}, {}).morton_bits.to_u64();
  };
  EXPECT_EQ(bits(1, 1), 0u);
  EXPECT_EQ(bits(2, 2), 0u);
  EXPECT_EQ(bits(3, 2), 2u);
  EXPECT_EQ(bits(4, 4), 2u);
  EXPECT_EQ(bits(5, 4), 4u);
  EXPECT_EQ(bits(512, 384), 16u);
  EXPECT_EQ(bits(300, 514), 18u);
  EXPECT_EQ(bits(1024, 100), 18u);
}

TEST(FrameConfig, MortonBitsCountPacketsOfEightRays) {
  CoreInfo core = kBoard;
  core.packet_rays = 8;
  const auto bits = [&core](unsigned width, unsigned height) {
    return frame_config(core, {.width = width, .height = height}, {}).morton_bits.to_u64();
  };
  EXPECT_EQ(bits(1, 1), 1u) << "a square of four pixels a side has two packets";
  EXPECT_EQ(bits(5, 4), 3u);
  EXPECT_EQ(bits(512, 384), 15u);
}

TEST(FrameConfig, RefusesSizesThatTheBoardCannotHold) {
  for (const auto& [width, height] :
       {std::pair{0u, 10u}, {10u, 0u}, {1025u, 1u}, {1u, 1025u}, {1024u, 1024u}}) {
    EXPECT_THAT(configuring({.width = width, .height = height}),
                ThrowsMessage<UserError>("an image of " + std::to_string(width) + "x" +
                                         std::to_string(height) +
                                         " pixels is impossible: it has 1 to 1024 pixels a side "
                                         "and at most 349525 in all; "
                                         "the board's framebuffer and hit records hold no more"));
  }
  EXPECT_NO_THROW(check_size(1024, 341));
}

TEST(FrameConfig, RefusesWhatTheConfigurationLacks) {
  EXPECT_THAT(configuring({.packets = 0}),
              ThrowsMessage<UserError>("configuration small holds 1 to 8 packets, not 0"));
  EXPECT_THAT(configuring({.packets = 9}),
              ThrowsMessage<UserError>("configuration small holds 1 to 8 packets, not 9"));
  EXPECT_THAT(configuring({.lines = 32}),
              ThrowsMessage<UserError>(
                  "the caches of configuration small have 1, 2, 4 up to 16 lines, not 32"));
  EXPECT_THAT(configuring({.lines = 3}),
              ThrowsMessage<UserError>(
                  "the caches of configuration small have 1, 2, 4 up to 16 lines, not 3"));
  EXPECT_NO_THROW(configuring({.packets = 1, .lines = 1})());
  CoreInfo core = kBoard;
  core.ways = 2;
  EXPECT_THAT([&core] { frame_config(core, {.lines = 1}, {}); },
              ThrowsMessage<UserError>(
                  "the caches of configuration small have 2, 4, 8 up to 16 lines, not 1"));
  core.line_nodes = 2;
  EXPECT_THAT([&core] { frame_config(core, {.lines = 4}, {}); },
              ThrowsMessage<UserError>(
                  "the caches of configuration small have 8, 16, 32 up to 16 lines, not 4"));
  EXPECT_THAT(
      configuring({.reflections = 1}),
      ThrowsMessage<UserError>("configuration small traces at most 0 reflections of a ray, not 1"));
}

TEST(FrameConfig, AMemoryBehindAPortHasClocksThatCanBeChosen) {
  EXPECT_EQ(memory_timing(kBoard, {}), std::nullopt);
  EXPECT_THAT(
      configuring({.memory_latency = 30}),
      ThrowsMessage<UserError>("the scene of configuration small lies in banks of SRAM, whose "
                               "clocks are its own; a configuration with \"memory\": \"port\" has "
                               "a memory whose clocks can be chosen"));
  CoreInfo core = kBoard;
  core.memory = MemoryPath::kPort;
  EXPECT_EQ(memory_timing(core, {}), MemoryTiming{});
  EXPECT_EQ(memory_timing(core, {.memory_latency = 200, .row_clocks = 0}), (MemoryTiming{200, 0}));
  EXPECT_THAT([&core] { frame_config(core, {.memory_latency = 0}, {}); },
              ThrowsMessage<UserError>("the emulated memory takes 1 to 200 clocks, not 0"));
  EXPECT_THAT([&core] { frame_config(core, {.row_clocks = 201}, {}); },
              ThrowsMessage<UserError>("the emulated memory takes 0 to 200 clocks, not 201"));
}

TEST(Render, RefusesAnImageThatWasLaidOutForAnotherCore) {
  FakeBoard board;
  const auto rendering = [&](const std::function<void(CoreInfo&)>& change) {
    CoreInfo core = small_core();
    change(core);
    MemoryImage image(core);
    image.scene.name = "s";
    return [&board, image] { render(board, {.width = 3, .height = 2}, image); };
  };
  EXPECT_THAT(
      rendering([](CoreInfo& core) { core.triangle_matrix = TriangleMatrix::kMemoryEfficient; }),
      ThrowsMessage<UserError>(
          "scene 's' is laid out for a core with triangle_matrix \"memory_efficient\", and "
          "configuration small has \"normal_consistent\"; lay it out for the core that renders "
          "it"));
  EXPECT_THAT(rendering([](CoreInfo& core) { core.levels = 1; }),
              ThrowsMessage<UserError>(HasSubstr("with levels 1, and configuration small has 2")));
  EXPECT_THAT(rendering([](CoreInfo& core) { core = CoreInfo(); }),
              ThrowsMessage<UserError>(HasSubstr("with stack_depth 0,")));
  const auto beside_the_memory = [](CoreInfo& core) {
    core.packets = core.lines = 1;
    core.reflections = 2;
  };
  EXPECT_NO_THROW(rendering(beside_the_memory)()) << "no word of the memory depends on them";
}

TEST(Render, UploadsRendersAndReadsBack) {
  FakeBoard board;
  board.counter_values = {{"step.tokens", 5, true}};
  board.on_start = [](const FrameConfig&, FakeBoard::Memory& memory) {
    EXPECT_EQ(memory[1][20], 1u);
    EXPECT_EQ(memory[1][21], 2u);
    EXPECT_EQ(memory[2][0], 3u);
    for (std::uint32_t p = 0; p < 6; ++p) memory[3][p] = 0x10 + p;
    // Pixel 4 is hit: object 7, triangle 9.
    memory[4][12] = 0x111;
    memory[4][13] = 0x333;
    memory[4][14] = 0x80000007;
    memory[5][12] = 0x222;
    memory[5][13] = 0x444;
    memory[5][14] = 9;
  };
  const std::vector<std::uint32_t> nodes = {1, 2};
  const std::vector<std::uint32_t> list = {3};
  const std::vector<MemoryRun> memory = {{1, 20, nodes}, {2, 0, list}};
  const Frame frame = render(board, {.width = 3, .height = 2, .timeout = 123}, {}, memory, {});
  EXPECT_EQ(board.timeout, 123u);
  EXPECT_EQ(board.frame.width.to_u64(), 3u);
  EXPECT_EQ(frame.pixels, (std::vector<std::uint32_t>{0x10, 0x11, 0x12, 0x13, 0x14, 0x15}));
  ASSERT_EQ(frame.hits.size(), 6u);
  EXPECT_EQ(frame.hits[4], (HitRecord{true, 7, 9, 0x111, 0x222, 0x333, 0x444}));
  EXPECT_EQ(frame.hits[3], HitRecord{});
  EXPECT_EQ(frame.hit_count(), 1u);
  EXPECT_EQ(frame.counters.at(0).value, 5u);
  EXPECT_EQ(frame.run.cycles, 1000u);
}

TEST(Render, ReadsPixelsOfSixteenBits) {
  CoreInfo core = small_core();
  core.memory = MemoryPath::kPort;
  core.pixel_bits = 16;
  FakeBoard board(core);
  // Two rows of five, each from a multiple of four pixels on; the gaps hold anything.
  board.on_start = [](const FrameConfig& config, FakeBoard::Memory& memory) {
    EXPECT_EQ(config.frame_base.to_u64() % 16, 0u) << "a display's burst begins with a picture";
    for (std::uint32_t p = 0; p < 16; ++p) {
      const std::uint32_t shift = p % 2 * 16;
      const std::uint32_t pixel = p % 8 < 5 ? p : 0xffff;
      memory[3][(config.frame_base.to_u64() + p) / 2] |= pixel << shift;
    }
  };
  const FrameOptions options{.width = 5, .height = 2, .hits = false, .buffer = 1};
  const Frame frame = render(board, options, {}, {}, {});
  std::vector<std::uint32_t> expected;
  for (std::uint32_t p = 0; p < 16; ++p) {
    if (p % 8 < 5) expected.push_back(p << 3 | p >> 2);  // five bits of red, stretched
  }
  EXPECT_EQ(frame.pixels, expected);
  EXPECT_EQ(frame.traffic.bytes_read, 4u * 16 / 2);
}

TEST(BoardPixels, MayBeginAndEndWithinAWord) {
  CoreInfo core = small_core();
  core.pixel_bits = 16;
  FakeBoard board(core);
  board.memory[3][4] = 0xffff'0000;
  board.memory[3][5] = 0x07e0'001f;
  board.memory[3][6] = 0x0000'f800;
  std::vector<std::uint32_t> pixels(4);
  board.read_pixels(9, pixels);
  EXPECT_EQ(pixels, (std::vector<std::uint32_t>{0xffffff, 0x0000ff, 0x00ff00, 0xff0000}));
  pixels.resize(1);
  board.read_pixels(10, pixels);
  EXPECT_EQ(pixels.front(), 0x0000ffu);
}

TEST(Render, EveryBufferIsItsOwnAndHitsAreReadOnRequest) {
  FakeBoard board;
  std::uint32_t colour = 1;
  board.on_start = [&](const FrameConfig& config, FakeBoard::Memory& memory) {
    EXPECT_EQ(config.write_hits.to_u64(), 0u);
    for (std::uint32_t p = 0; p < 6; ++p) memory[3][config.frame_base.to_u64() + p] = colour;
    ++colour;
  };
  FrameOptions options{.width = 3, .height = 2, .hits = false};
  const Frame first = render(board, options, {}, {}, {});
  options.buffer = 1;
  const Frame second = render(board, options, {}, {}, {});
  EXPECT_EQ(first.pixels, std::vector<std::uint32_t>(6, 1));
  EXPECT_EQ(second.pixels, std::vector<std::uint32_t>(6, 2));
  EXPECT_EQ(board.memory[3][0], 1u) << "the first is still shown";
  EXPECT_EQ(board.memory[3][1u << 19], 2u);
  EXPECT_TRUE(first.hits.empty());
  EXPECT_EQ(first.traffic.bytes_read, 4u * 6);
}

TEST(Render, MetersTheBusOfEachFrameByItself) {
  FakeBoard board;
  const std::vector<std::uint32_t> nodes(100);
  const std::vector<MemoryRun> all = {{0, 1, nodes}, {1, 1, nodes}};
  const Frame first = render(board, {.width = 4, .height = 2}, {}, all, {});
  EXPECT_EQ(first.upload.bytes_written, 800u);
  EXPECT_EQ(first.upload.bytes_read, 0u);
  EXPECT_EQ(first.traffic.bytes_written, 800u);
  // A word of colour and six of the hit record for each of 8 pixels.
  EXPECT_EQ(first.traffic.bytes_read, 4u * 8 * 7);

  const std::vector<MemoryRun> changed = {{0, 5, {nodes.begin(), nodes.begin() + 10}}};
  const Frame second = render(board, {.width = 4, .height = 2}, {}, changed, {});
  EXPECT_EQ(second.upload, (BusTraffic{1, 40, 0, 12}));
  EXPECT_EQ(second.traffic.bytes_written, 40u);
  EXPECT_EQ(second.traffic.bytes_read, first.traffic.bytes_read);
}

}  // namespace
}  // namespace dynrt::host
