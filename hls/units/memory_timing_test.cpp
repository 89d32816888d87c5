// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_timing.h"

#include <gtest/gtest.h>

#include <vector>

namespace dynrt {
namespace {

struct Read {
  std::uint64_t at;
  unsigned byte;
  unsigned beats;
};
struct Answer {
  std::size_t read;
  std::uint64_t first_beat;
  friend bool operator==(const Answer&, const Answer&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Answer& a) {
    return out << a.read << " in clock " << a.first_beat;
  }
};

/// The clocks in which the first beats of some reads are at the port.
std::vector<Answer> answers(const MemoryTiming& timing, const std::vector<Read>& reads) {
  MemorySchedule<std::size_t> schedule(timing);
  std::vector<Answer> found;
  std::size_t next = 0;
  for (std::uint64_t now = 0; next < reads.size() || !schedule.is_idle(); ++now) {
    if (next < reads.size() && reads[next].at == now) {
      schedule.take(now, reads[next].byte, reads[next].beats, next);
      ++next;
    }
    if (const auto read = schedule.answer(now)) found.push_back({*read, now + 1});
  }
  return found;
}

TEST(MemoryTiming, TheFirstBeatComesAfterTheLatency) {
  for (const unsigned latency : {1u, 30u, 200u}) {
    EXPECT_EQ(answers({latency, 0}, {{7, 0, 1}}), (std::vector<Answer>{{0, 7 + latency}}));
  }
}

TEST(MemoryTiming, TheBusCarriesABeatAClock) {
  EXPECT_EQ(answers({10, 0}, {{0, 0, 4}, {1, 64, 2}, {30, 0, 1}}),
            (std::vector<Answer>{{0, 10}, {1, 14}, {2, 40}}));
}

TEST(MemoryTiming, ARowIsOpenedOnce) {
  EXPECT_EQ(answers({10, 20}, {{0, 0, 1}, {50, 512, 1}, {100, kMemoryBanks * kMemoryRowBytes, 1}}),
            (std::vector<Answer>{{0, 30}, {1, 60}, {2, 130}}));
}

TEST(MemoryTiming, ABankOpensOneRowAfterTheOther) {
  constexpr unsigned kSameBank = kMemoryBanks * kMemoryRowBytes;
  EXPECT_EQ(answers({10, 20}, {{0, 0, 1}, {1, kSameBank, 1}}),
            (std::vector<Answer>{{0, 30}, {1, 50}}));
}

TEST(MemoryTiming, AnOpenRowOvertakesAClosedOne) {
  constexpr unsigned kOtherBank = kMemoryRowBytes;
  EXPECT_EQ(answers({10, 20}, {{0, 0, 1}, {40, kOtherBank, 1}, {41, 8, 1}}),
            (std::vector<Answer>{{0, 30}, {2, 51}, {1, 70}}));
}

TEST(MemoryTiming, AWriteTakesTheBusForAClock) {
  MemorySchedule<int> schedule({4, 0});
  schedule.take(0, 0, 1, 7);
  schedule.write(2, 64);
  schedule.write(3, 80);
  EXPECT_FALSE(schedule.answer(3));
  EXPECT_FALSE(schedule.answer(3));
  EXPECT_EQ(schedule.answer(4), 7);
}

TEST(MemoryTiming, AWriteOpensItsRow) {
  MemorySchedule<int> schedule({1, 5});
  schedule.write(0, 0);
  schedule.take(1, 8, 1, 1);
  EXPECT_EQ(schedule.next(), 5u);
}

}  // namespace
}  // namespace dynrt
