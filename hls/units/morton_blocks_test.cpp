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
using Blocks = MortonBlocks<Three, kCounterBits>;

/// The packets of a block, of a curve whose last place this is.
unsigned block_of(unsigned last) {
  return static_cast<unsigned>(Blocks::last_of_block(Blocks::Counter::from(last)).to_u64()) + 1;
}

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
  unsigned asked = 0;
  while (std::ranges::count(is_over, true) != Three::kPipelines) {
    if (++asked > 8u << kCounterBits) {
      ADD_FAILURE() << "the curve has no end";
      break;
    }
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
    blocks.advance(id, inside(corner / block_of(last)), Blocks::Counter::from(last));
  }
  return handed;
}

TEST(MortonBlocks, ABlockIsA64thOfTheCurve) {
  EXPECT_EQ(block_of((1u << 12) - 1), 64u);
  EXPECT_EQ(block_of((1u << 9) - 1), 8u);
  for (unsigned bits = 0; bits < 9; ++bits) EXPECT_EQ(block_of((1u << bits) - 1), 4u) << bits;
  using OfLargest = MortonBlocks<Three, 17>;
  for (const unsigned bits : {15u, 16u, 17u}) {
    const auto last = OfLargest::last_of_block(OfLargest::Counter::from((1u << bits) - 1));
    EXPECT_EQ(last.to_u64(), 511u) << bits;
  }
}

TEST(MortonBlocks, EveryPlaceIsHandedOutOnce) {
  for (unsigned bits = 2; bits <= kCounterBits; ++bits) {
    const unsigned count = 1u << bits;
    const Handed handed = hand_out(count - 1, [](unsigned) { return true; });
    EXPECT_EQ(handed.times.size(), count);
    for (const auto& [place, times] : handed.times) {
      EXPECT_EQ(times, 1u) << place;
      EXPECT_LT(place, count);
    }
  }
}

TEST(MortonBlocks, APipelineEndsItsBlockBeforeItTakesTheNext) {
  constexpr unsigned kLast = (1u << kCounterBits) - 1;
  const unsigned block = block_of(kLast);
  const Handed handed = hand_out(kLast, [](unsigned) { return true; });
  for (const std::vector<unsigned>& places : handed.of_pipeline) {
    EXPECT_GT(places.size(), 10 * block) << "each pipeline has about a third";
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(places[i] % block, i % block);
  }
}

TEST(MortonBlocks, OfABlockOutsideTheImageOnePacketIsHandedOut) {
  const auto inside = [](unsigned block) { return block % 4 < 2; };
  for (const unsigned bits : {8u, 9u, kCounterBits}) {
    const unsigned last = (1u << bits) - 1, size = block_of(last);
    const Handed handed = hand_out(last, inside);
    std::map<unsigned, unsigned> packets;
    for (const auto& [place, times] : handed.times) {
      EXPECT_EQ(times, 1u) << place;
      ++packets[place / size];
    }
    ASSERT_EQ(packets.size(), 64u);
    for (const auto& [block, count] : packets) EXPECT_EQ(count, inside(block) ? size : 1) << block;
  }
}

TEST(MortonBlocks, ACurveShorterThanABlockIsOne) {
  for (const unsigned last : {0u, 1u, 3u}) {
    const Handed handed = hand_out(last, [](unsigned) { return true; });
    EXPECT_EQ(handed.times.size(), 4u) << "places beyond its end lie outside the image";
  }
}

}  // namespace
}  // namespace dynrt
