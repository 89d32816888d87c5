// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/morton_blocks.h"

#include <algorithm>
#include <map>
#include <vector>

#include "units/test_bench.h"

namespace dynrt {
namespace {

struct Three : test::Config<64> {
  static constexpr unsigned kPipelines = 3;
};
constexpr unsigned kCounterBits = 12;
constexpr unsigned kBlock = 64;  ///< packets
using Blocks = MortonBlocks<Three, kCounterBits>;

struct Handed {
  std::vector<std::vector<unsigned>> of_pipeline;  ///< places, in the order of the packets
  std::map<unsigned, unsigned> times;              ///< by place
};

/// Hands the blocks up to `last` to pipelines that ask in random order, until none gets a packet.
/// Of the blocks, those for which `inside` holds lie in the image.
template <class Inside>
Handed hand_out(unsigned last, const Inside& inside) {
  Blocks blocks;
  Handed handed;
  handed.of_pipeline.resize(Three::kPipelines);
  test::Random random(last);
  std::vector<bool> is_over(Three::kPipelines);
  while (std::ranges::count(is_over, true) != Three::kPipelines) {
    const unsigned pipeline = test::below(random, Three::kPipelines);
    const auto id = PipelineId<Three>::from(pipeline);
    const auto next = blocks.next(id);
    is_over[pipeline] = next.is_over;
    const auto place = static_cast<unsigned>(next.counter.to_u64());
    if (!next.is_over) {
      handed.of_pipeline[pipeline].push_back(place);
      ++handed.times[place];
    }
    const auto corner = static_cast<unsigned>(blocks.corner().to_u64());
    blocks.advance(id, inside(corner / kBlock), Blocks::Counter::from(last));
    if (handed.times.size() > 1u << kCounterBits) break;
  }
  return handed;
}

TEST(MortonBlocks, EveryPlaceIsHandedOutOnce) {
  for (const unsigned count : {1u, 2u, 16u, 64u}) {
    const Handed handed = hand_out(count * kBlock - 1, [](unsigned) { return true; });
    EXPECT_EQ(handed.times.size(), count * kBlock);
    for (const auto& [place, times] : handed.times) {
      EXPECT_EQ(times, 1u) << place;
      EXPECT_LT(place, count * kBlock);
    }
  }
}

TEST(MortonBlocks, APipelineEndsItsBlockBeforeItTakesTheNext) {
  const Handed handed = hand_out(64 * kBlock - 1, [](unsigned) { return true; });
  for (const std::vector<unsigned>& places : handed.of_pipeline) {
    EXPECT_GT(places.size(), 10 * kBlock) << "each pipeline has about a third";
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(places[i] % kBlock, i % kBlock);
  }
}

TEST(MortonBlocks, OfABlockOutsideTheImageOnePacketIsHandedOut) {
  const auto inside = [](unsigned block) { return block % 4 < 2; };
  const Handed handed = hand_out(64 * kBlock - 1, inside);
  std::map<unsigned, unsigned> packets;
  for (const auto& [place, times] : handed.times) {
    EXPECT_EQ(times, 1u) << place;
    ++packets[place / kBlock];
  }
  ASSERT_EQ(packets.size(), 64u);
  for (const auto& [block, count] : packets) EXPECT_EQ(count, inside(block) ? kBlock : 1) << block;
}

TEST(MortonBlocks, ACurveShorterThanABlockIsOne) {
  const Handed handed = hand_out(3, [](unsigned) { return true; });
  EXPECT_EQ(handed.times.size(), kBlock) << "places beyond its end lie outside the image";
}

}  // namespace
}  // namespace dynrt
