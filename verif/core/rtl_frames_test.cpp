// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joined core, RTL against model, to the last bit: every configuration of this build that has
// its Verilog, with the choices that a frame offers; tests that are slow have all of them. Each is
// rendered twice, on the board that the program uses and on the one that checks the Verilog's
// assertions and starts with random values. The model counts its clocks by hlsc's schedules, and
// they are the Verilog's, to the last one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "core/scenes.h"
#include "host/board/configurations.h"
#include "host/board/rtl_board.h"
#include "host/error.h"
#include "host/format/frame_words.h"
#include "host/render/compare.h"
#include "host/render/render.h"

namespace dynrt::host {
namespace {

constexpr unsigned kAll = 0;  ///< as many as the configuration has

std::vector<std::string> names_with_rtl() {
  const auto names = names_of(configurations(), [](const Configuration& c) { return c.lowered; });
  return {names.begin(), names.end()};
}

std::unique_ptr<Board> make_checked_board(const std::string& name, int seed) {
  const Configuration& c = find_configuration(configurations(), name, true);
  CoreInfo info = c.core();
  info.name = name;
  return std::make_unique<RtlBoard>(std::move(info), c.traced("", seed),
                                    counters_of(c.core_json()));
}

std::unique_ptr<Board> make_scheduled_model(const std::string& name) {
  return make_board(configurations(), {"model", name, "", GENERATED_FOLDER "/" + name});
}

MemoryImage prepare_scene(const char* name, const FrameOptions& options, const CoreInfo& core) {
  return laid_out(name, options.width, options.height, core);
}

/// One that asks for all rays that the configuration has.
const char* scene_for(const CoreInfo& board) { return board.lights > 0 ? "lamps" : "blocks"; }

void expect_identical(const Frame& rtl, const Frame& model) {
  const Comparison comparison = compare(rtl, model);
  EXPECT_EQ(comparison.pixels, std::uint64_t{rtl.width} * rtl.height);
  EXPECT_GT(comparison.hits, 0u);
  EXPECT_GT(comparison.counters, 30u);
  EXPECT_TRUE(comparison.identical()) << comparison.first->text("rtl", "model");
  ASSERT_TRUE(model.run.scheduled);
  EXPECT_EQ(rtl.run.cycles, model.run.cycles);
  // So even that is equal which depends on the order in which packets are served: misses, stalls.
  for (const Counter& counter : rtl.counters) {
    const auto found = std::ranges::find(model.counters, counter.name, &Counter::name);
    ASSERT_NE(found, model.counters.end()) << counter.name;
    EXPECT_EQ(counter.value, found->value) << counter.name;
  }
}

constexpr std::array kPackets = {1u, 5u, kAll}, kLines = {1u, 2u, kAll};
using Choice = std::tuple<std::string, RayOrder, bool, unsigned, unsigned>;

void expect_rtl_is_the_model(const Choice& choice) {
  const auto& [name, order, uncompressed, packets, lines] = choice;
  const auto rtl = make_board(configurations(), {"rtl", name, ""});
  const auto checked = make_checked_board(name, 1);
  const auto model = make_scheduled_model(name);
  FrameOptions options;
  // A pixel with lights and mirrors takes many rays.
  const bool many_rays = rtl->core().lights > 0;
  options.width = many_rays ? 12 : 20;
  options.height = many_rays ? 8 : 14;
  options.order = order;
  options.uncompressed = uncompressed;
  if (packets != kAll) options.packets = std::min(packets, rtl->core().packets);
  if (lines != kAll) {
    options.lines = std::clamp(lines, rtl->core().least_lines(), rtl->core().lines);
  }
  options.timeout = 10'000'000;
  const MemoryImage scene = prepare_scene(scene_for(model->core()), options, model->core());
  const Frame expected = render(*model, options, scene);
  const Frame frame = render(*rtl, options, scene);
  expect_identical(frame, expected);
  const Frame frame_checked = render(*checked, options, scene);
  expect_identical(frame_checked, expected);
  EXPECT_EQ(frame.run.cycles, frame_checked.run.cycles)
      << "a word that was never written has an effect";
}

std::string name_of(const testing::TestParamInfo<Choice>& info) {
  const auto& [name, order, uncompressed, packets, lines] = info.param;
  const auto number = [](unsigned n) { return n == kAll ? "all" : fmt::format("{}", n); };
  return fmt::format("{}_{}_{}_{}_packets_{}_lines", name,
                     order == RayOrder::kMorton ? "morton" : "scanline",
                     uncompressed ? "uncompressed" : "compressed", number(packets), number(lines));
}

/// A quarter of the choices, in which each two values of two choices occur together.
std::vector<Choice> pairs_of_choices() {
  std::vector<Choice> choices;
  for (const std::string& name : names_with_rtl()) {
    for (unsigned p = 0; p < kPackets.size(); ++p) {
      for (unsigned l = 0; l < kLines.size(); ++l) {
        const bool scanline = (p + l) % 2 == 1, uncompressed = (p + 2 * l) % 3 == 1;
        choices.emplace_back(name, scanline ? RayOrder::kScanline : RayOrder::kMorton, uncompressed,
                             kPackets[p], kLines[l]);
      }
    }
  }
  return choices;
}

class Frames : public testing::TestWithParam<Choice> {};
TEST_P(Frames, RtlIsTheModel) { expect_rtl_is_the_model(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Every, Frames, testing::ValuesIn(pairs_of_choices()), name_of);

class AllFrames : public testing::TestWithParam<Choice> {};
TEST_P(AllFrames, SlowRtlIsTheModel) { expect_rtl_is_the_model(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Every, AllFrames,
                         testing::Combine(testing::ValuesIn(names_with_rtl()),
                                          testing::Values(RayOrder::kMorton, RayOrder::kScanline),
                                          testing::Bool(), testing::ValuesIn(kPackets),
                                          testing::ValuesIn(kLines)),
                         name_of);

/// Latency and clocks to open a row of the memory behind a port.
using Timing = std::tuple<std::string, std::pair<unsigned, unsigned>>;
class Timings : public testing::TestWithParam<Timing> {};

TEST_P(Timings, TheEmulatedMemoryIsTheModels) {
  const auto& [name, clocks] = GetParam();
  const auto rtl = make_checked_board(name, 1);
  const auto model = make_scheduled_model(name);
  FrameOptions options{.width = 40, .height = 30, .timeout = 10'000'000};
  options.memory_latency = clocks.first;
  options.row_clocks = clocks.second;
  const MemoryImage scene = prepare_scene("office", options, model->core());
  const Frame expected = render(*model, options, scene);
  expect_identical(render(*rtl, options, scene), expected);
  // The first frame has left rows open.
  expect_identical(render(*rtl, options, scene), expected);
}

std::vector<std::string> names_with_port() {
  std::vector<std::string> names;
  for (const Configuration& c : configurations()) {
    if (c.lowered && c.core().memory == MemoryPath::kPort) names.emplace_back(c.name);
  }
  return names;
}

std::string name_of_timing(const testing::TestParamInfo<Timing>& info) {
  const auto& [name, clocks] = info.param;
  return fmt::format("{}_{}_clocks_{}_a_row", name, clocks.first, clocks.second);
}

INSTANTIATE_TEST_SUITE_P(
    Every, Timings,
    testing::Combine(testing::ValuesIn(names_with_port()),
                     testing::Values(std::pair{1u, 0u}, std::pair{30u, 0u}, std::pair{200u, 0u},
                                     std::pair{8u, 1u}, std::pair{8u, 30u}, std::pair{100u, 200u})),
    name_of_timing);

class Starts : public testing::TestWithParam<std::string> {};

/// The board's message if it refuses to start the frame with these packets; empty: it starts.
std::string refusal(Board& board, FrameConfig frame, unsigned packets) {
  frame.packets = to_word(packets);
  board.configure(frame);
  try {
    board.start();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

/// Without packets no ray comes to an end, and the core has no place for one packet more than it
/// has.
TEST_P(Starts, ABoardRefusesPacketsThatTheCoreHasNot) {
  const auto rtl = make_checked_board(GetParam(), 1);
  const auto model = make_scheduled_model(GetParam());
  FrameOptions options;
  options.width = 12;
  options.height = 8;
  options.timeout = 10'000'000;
  const MemoryImage scene = prepare_scene(scene_for(model->core()), options, model->core());
  const FrameConfig frame = frame_config(model->core(), options, scene.frame);
  const unsigned most = model->core().packets;
  for (const unsigned packets : {0u, most + 1}) {
    for (Board* board : {rtl.get(), model.get()}) {
      EXPECT_EQ(
          refusal(*board, frame, packets),
          fmt::format("board {}: it refused to start a frame with {} packets and {} cache "
                      "lines; its core takes 1 to {} packets, and a power of two of at most "
                      "{} lines",
                      board->name(), packets, model->core().lines, most, model->core().lines));
    }
  }
  const Frame expected = render(*model, options, scene);
  expect_identical(render(*rtl, options, scene), expected);
}

INSTANTIATE_TEST_SUITE_P(Every, Starts, testing::ValuesIn(names_with_rtl()),
                         [](const auto& info) { return info.param; });

class Assertions : public testing::TestWithParam<std::string> {};

/// Renders on the checked board, once for each seed; without a scene, the one for its
/// configuration.
void expect_assertions_hold(const std::string& configuration, const char* scene_name,
                            unsigned width, unsigned height, std::initializer_list<int> seeds) {
  const auto model = make_scheduled_model(configuration);
  FrameOptions options;
  options.width = width;
  options.height = height;
  options.timeout = 10'000'000;
  const MemoryImage scene = prepare_scene(
      scene_name != nullptr ? scene_name : scene_for(model->core()), options, model->core());
  const Frame expected = render(*model, options, scene);
  for (const int seed : seeds) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const auto checked = make_checked_board(configuration, seed);
    expect_identical(render(*checked, options, scene), expected);
  }
}

TEST_P(Assertions, HoldWhateverTheCoreStartsWith) {
  expect_assertions_hold(GetParam(), nullptr, 32, 24, {2, 3, 4});
}

TEST_P(Assertions, SlowHoldInTheOffice) {
  expect_assertions_hold(GetParam(), "office", 256, 192, {5});
}

INSTANTIATE_TEST_SUITE_P(Every, Assertions, testing::ValuesIn(names_with_rtl()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace dynrt::host
