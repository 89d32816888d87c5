// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/timing_wheel.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace {

using Acts = std::vector<std::pair<std::uint64_t, std::size_t>>;  ///< clock, actor

TEST(TimingWheel, ActorsWorkInTheOrderOfClocksAndOfTheirNumbers) {
  hls::TimingWheel wheel(130);
  wheel.wake(129, 7);
  wheel.wake(1, 7);
  wheel.wake(1, 7);  // once is enough
  wheel.wake(64, 3);
  wheel.wake(0, 100'000);  // far beyond the wheel
  wheel.wake(2, 600);
  Acts acts;
  wheel.run([&](std::size_t actor, std::uint64_t now) {
    acts.emplace_back(now, actor);
    if (actor == 1) wheel.wake(65, now);  // in the same clock
    if (actor == 2) wheel.wake(3, now + 255);
    if (actor == 64 && now < 2'000) wheel.wake(64, now + 1'000);  // later than the wheel reaches
  });
  const Acts expected = {{3, 64},  {7, 1},      {7, 65},     {7, 129},    {600, 2},
                         {855, 3}, {1'003, 64}, {2'003, 64}, {100'000, 0}};
  EXPECT_EQ(acts, expected);
}

TEST(TimingWheel, EndsWhenNobodyHasWork) {
  hls::TimingWheel wheel(1);
  unsigned left = 1'000;
  wheel.wake(0, 0);
  wheel.run([&](std::size_t, std::uint64_t now) {
    if (--left > 0) wheel.wake(0, now + left);
  });
  EXPECT_EQ(left, 0u);
}

}  // namespace
