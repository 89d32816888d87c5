// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/render/figures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/board/configurations.h"
#include "host/render/counter_names.h"
#include "host/test_folder.h"

namespace dynrt::host {
namespace {

Frame a_frame() {
  Frame frame;
  frame.width = 10;
  frame.height = 10;
  frame.lines = 16;
  frame.pixels.resize(100);
  frame.run = {.cycles = 1000, .seconds = 0.5};
  frame.counters = {{"list.transactions", 250},
                    {"traversal.transactions", 900},
                    {"step.tokens", 900},
                    {"list.stalls", 10},
                    {"node_lookup.transactions", 400},
                    {"node_fill.transactions", 116}};
  return frame;
}

TEST(Figures, UnitsAreSharesOfTheCycles) {
  const FrameFigures figures = figures_of(a_frame(), 85e6);
  ASSERT_EQ(figures.units.size(), 4u);
  EXPECT_EQ(figures.units[0].name, "traversal");
  EXPECT_EQ(figures.units[0].transactions, 900u);
  EXPECT_DOUBLE_EQ(*figures.units[0].utilisation, 0.9);
  EXPECT_FALSE(figures.units[0].stalled.has_value());
  EXPECT_EQ(figures.units[2].name, "list");
  EXPECT_DOUBLE_EQ(*figures.units[2].stalled, 0.01);
}

TEST(Figures, EmptyingTheLinesIsNoMiss) {
  const FrameFigures figures = figures_of(a_frame(), 85e6);
  ASSERT_EQ(figures.caches.size(), 1u);
  EXPECT_EQ(figures.caches[0].name, "node");
  EXPECT_EQ(figures.caches[0].lookups, 400u);
  EXPECT_EQ(figures.caches[0].misses, 100u);
  EXPECT_DOUBLE_EQ(figures.caches[0].hit_rate, 0.75);
}

TEST(Figures, MissesAreBytesFromTheMemory) {
  Frame frame = a_frame();
  frame.hits.resize(100);
  const MemoryFigures memory = figures_of(frame, 85e6).memory;
  EXPECT_EQ(memory.read, 100u * 8);
  EXPECT_EQ(memory.pixels, 100u * 4);
  EXPECT_EQ(memory.hits, 100u * 24);
  frame.counters.clear();
  EXPECT_FALSE(figures_of(frame, 85e6).memory.read);
}

TEST(Figures, BeatsAreBytesFromThePort) {
  Frame frame = a_frame();
  frame.core.memory = MemoryPath::kPort;
  frame.core.port_bytes = 16;
  frame.core.second_level = 64;
  frame.core.line_nodes = 4;
  frame.counters.push_back({counters::kBeats, 40});
  frame.counters.push_back({counters::kPortLines, 100});
  const FrameFigures figures = figures_of(frame, 85e6);
  EXPECT_EQ(figures.memory.read, 40u * 16);
  EXPECT_EQ(figures.caches.back().name, "second");
  EXPECT_EQ(figures.caches.back().misses, 20u);
  EXPECT_DOUBLE_EQ(figures.caches.back().hit_rate, 0.8);
  EXPECT_EQ(figures.memory.pixels, 100u * 4);
  frame.core.pixel_bits = 16;
  EXPECT_EQ(figures_of(frame, 85e6).memory.pixels, 100u * 2);
}

TEST(Figures, DroppedPushesAreTokensOfFullStacks) {
  Frame frame = a_frame();
  EXPECT_FALSE(figures_of(frame, 85e6).dropped_pushes);  // nothing counts them
  frame.counters.push_back({"stack_full.tokens", 29});
  EXPECT_EQ(figures_of(frame, 85e6).dropped_pushes, 29u);
}

TEST(Figures, TheCoreHasTheirCounters) {
  const std::vector<Counter> counters = counters_of(text_of(DYNRT_THESIS_CORE));
  ASSERT_FALSE(counters.empty());
  const auto expect_counter = [&](std::string_view name) {
    EXPECT_NE(std::ranges::find(counters, name, &Counter::name), counters.end()) << name;
  };
  expect_counter(counters::kDroppedPushes);
  for (const counters::OfCache& of : counters::kCaches) {
    expect_counter(of.lookups);
    expect_counter(of.fills);
  }
}

TEST(Figures, Speeds) {
  const FrameFigures figures = figures_of(a_frame(), 85e6);
  EXPECT_DOUBLE_EQ(*figures.frames_per_second, 85e3);
  EXPECT_DOUBLE_EQ(*figures.rays_per_clock, 0.1);
  EXPECT_DOUBLE_EQ(*figures.clocks_per_second, 2000);
  EXPECT_DOUBLE_EQ(figures.rays_per_second, 200);
}

TEST(Figures, WithoutAClockThereIsNoUtilisation) {
  Frame frame = a_frame();
  frame.run.cycles.reset();
  const FrameFigures figures = figures_of(frame, 85e6);
  EXPECT_FALSE(figures.units[0].utilisation.has_value());
  EXPECT_FALSE(figures.frames_per_second.has_value());
  EXPECT_DOUBLE_EQ(figures.rays_per_second, 200);
}

}  // namespace
}  // namespace dynrt::host
