// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// How many packets, lines and nodes of a line are chosen where the costs of each number are known.
#include "host/specialise/search.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace dynrt::host {
namespace {

const std::map<unsigned, std::uint64_t> kClocks = {{32, 1000}, {16, 1009}, {8, 1100},
                                                   {4, 1700},  {2, 3000},  {1, 6000}};

/// Packets alone, half of which is all that may be slower.
Counts packets_within(double percent, const std::map<unsigned, std::uint64_t>& clocks = kClocks) {
  CountSearch search{.packets = clocks.rbegin()->first, .percent = 2 * percent, .frame = "a frame"};
  search.search_lines = false;
  return choose_counts(search, [&](unsigned packets, unsigned) { return clocks.at(packets); });
}

std::vector<unsigned> numbers_of(const Curve& curve) {
  std::vector<unsigned> numbers;
  for (const auto& point : curve) numbers.push_back(point.first);
  return numbers;
}

TEST(Search, TakesTheSmallestNumberThatCostsLittleEnough) {
  for (const auto& [percent, expected] :
       {std::pair(0.0, 32), {1.0, 16}, {10.0, 8}, {9.9, 16}, {1000.0, 4}}) {
    EXPECT_EQ(packets_within(percent).decisions.at(0).value, expected) << percent;
  }
}

TEST(Search, MeasuresNothingBeyondWhatIsMuchSlower) {
  EXPECT_EQ(packets_within(1).packets, (Curve{{32, 1000}, {16, 1009}, {8, 1100}, {4, 1700}}));
}

TEST(Search, HalvesDownToTheLeast) {
  const auto lines_from = [](unsigned most, unsigned least) {
    CountSearch search{.lines = most, .least_lines = least};
    search.search_packets = false;
    return numbers_of(choose_counts(search, [](unsigned, unsigned) { return 1u; }).lines);
  };
  EXPECT_EQ(lines_from(48, 1), (std::vector<unsigned>{48, 32, 16, 8, 4, 2, 1}));
  EXPECT_EQ(lines_from(16, 4), (std::vector<unsigned>{16, 8, 4}));
  EXPECT_EQ(lines_from(4, 4), (std::vector<unsigned>{4}));
}

TEST(Search, GivesTheNumbersOnBothSidesAsReason) {
  const auto reason = [](double percent, const std::map<unsigned, std::uint64_t>& clocks) {
    return packets_within(percent, clocks).decisions.at(0).reason;
  };
  EXPECT_EQ(reason(1, kClocks),
            "with 32 a frame takes 1,000 clocks, with 16 0.9 % more, with 8 10.0 % more; 1 % are "
            "allowed");
  EXPECT_EQ(reason(1, {{1, 50}}), "with 1 a frame takes 50 clocks; 1 % are allowed");
  EXPECT_EQ(reason(1, {{32, 1000}, {16, 961}, {8, 1100}, {4, 9000}}),
            "with 32 a frame takes 1,000 clocks, with 16 3.9 % fewer, with 8 10.0 % more; 1 % are "
            "allowed");
  EXPECT_EQ(by_percent(-0.04, "fewer"), "0.0 %");
  EXPECT_EQ(by_percent(-3.94, "fewer"), "3.9 % fewer");
}

TEST(Search, MeasuresLinesWithThePacketsThatWereChosen) {
  std::set<unsigned> packets_with_few_lines;
  const Counts counts = choose_counts({.packets = 32, .lines = 512}, [&](unsigned p, unsigned n) {
    if (n < 512) packets_with_few_lines.insert(p);
    return p >= 16 && n >= 64 ? 1000u : 2000u;
  });
  ASSERT_EQ(counts.decisions.size(), 2u);
  EXPECT_EQ(counts.decisions[0].value, 16);
  EXPECT_EQ(counts.decisions[1].value, 64);
  EXPECT_EQ(numbers_of(counts.lines), (std::vector<unsigned>{512, 256, 128, 64, 32}));
  EXPECT_EQ(packets_with_few_lines, std::set<unsigned>{16});
}

const std::map<unsigned, FrameCosts> kCosts = {
    {1, {1010, 6.8}}, {2, {1000, 5.7}}, {4, {1020, 5.1}}, {8, {1200, 9.9}}};

Layouts layouts_of(const std::map<unsigned, FrameCosts>& costs) {
  return {costs.begin(), costs.end()};
}

TEST(Search, BytesDecideAmongLayoutsThatAreAsFast) {
  EXPECT_EQ(best_layout(layouts_of(kCosts)), 4u);
  auto slower = kCosts;
  slower[4] = {1021, 5.1};
  EXPECT_EQ(best_layout(layouts_of(slower)), 2u);
  EXPECT_EQ(best_layout({{1, {10, {}}}, {2, {10, {}}}, {4, {10, {}}}}), 1u);
}

TEST(Search, TriesNoLayoutBeyondOneThatIsWorseInBoth) {
  const auto tried = [](std::map<unsigned, FrameCosts> costs) {
    return try_layouts({1, 2, 4, 8}, [&](unsigned nodes) { return costs.at(nodes); }).size();
  };
  EXPECT_EQ(tried(kCosts), 4u);
  auto worse = kCosts;
  worse[4] = {1001, 5.8};
  EXPECT_EQ(tried(worse), 3u);
}

TEST(Search, GivesAllLayoutsAsReason) {
  EXPECT_EQ(layout_reason({{1, {1010, 6.8}}, {2, {1000, 5.7}}}, 2, "a frame"),
            "with 2 a frame takes 1,000 clocks and 5.70 bytes a ray, with 1 1.0 % more and 6.80 "
            "bytes a ray");
  EXPECT_EQ(layout_reason({{1, {50, {}}}}, 1, "a frame"), "with 1 a frame takes 50 clocks");
}

}  // namespace
}  // namespace dynrt::host
