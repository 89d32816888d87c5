// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/ports.h"

#include <gtest/gtest.h>

#include <deque>

#include "hls/random.h"

namespace {

using Word = hls::uint<32>;

/// Bursts of pushes and pops, against a deque: the tokens move within the queue's row, and to a
/// longer one, with any number waiting.
TEST(Fifo, KeepsOrderAndCountThroughBursts) {
  hls::testing::Random random(1);
  hls::Fifo<Word> fifo;
  std::deque<Word> expected;
  std::uint64_t pushed = 0;
  std::size_t longest = 0;
  for (int burst = 0; burst < 2000; ++burst) {
    for (std::uint64_t n = random.below(100); n > 0; --n) {
      const Word token = Word::from(random.next());
      fifo.push(token);
      expected.push_back(token);
      ++pushed;
    }
    longest = std::max(longest, expected.size());
    for (std::uint64_t n = random.below(100); n > 0 && !expected.empty(); --n) {
      ASSERT_FALSE(fifo.empty());
      ASSERT_EQ(fifo.pop(), expected.front());
      expected.pop_front();
    }
    ASSERT_EQ(fifo.size(), expected.size());
    ASSERT_EQ(fifo.empty(), expected.empty());
    ASSERT_EQ(fifo.pushed(), pushed);
  }
  EXPECT_GT(longest, 200u) << "the row never grew twice";
}

}  // namespace
