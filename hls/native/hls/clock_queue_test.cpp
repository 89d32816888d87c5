// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A FIFO and the buffer behind it, held against a simulation that looks at every clock.
#include "hls/clock_queue.h"

#include <gtest/gtest.h>

#include <deque>

#include "hls/random.h"

namespace {

using hls::ClockQueue;

/// Tokens move from the FIFO to a buffer of two places, a place that becomes free in a clock can be
/// used in the next, and so can a token that arrives.
class EveryClock {
 public:
  explicit EveryClock(unsigned room) : room_(room) {}
  void push(std::uint64_t ready) { fifo_.push_back(ready); }
  void begin(std::uint64_t now) {
    now_ = now;
    has_room_ = waiting() < room_;
    const bool place = buffer_.size() < ClockQueue::kBufferPlaces;
    offers_ = !buffer_.empty();
    moves_ = !fifo_.empty() && fifo_.front() <= now && place;
  }
  bool has_room() const { return has_room_; }
  bool offers() const { return offers_; }
  void take() { taken_ = true; }
  void end() {
    if (taken_) buffer_.pop_front();
    if (moves_) {
      fifo_.pop_front();
      buffer_.push_back(now_ + 1);
    }
    taken_ = false;
  }

 private:
  std::size_t waiting() const {
    std::size_t number = 0;
    while (number < fifo_.size() && fifo_[number] <= now_) ++number;
    return number;
  }
  unsigned room_;
  std::uint64_t now_ = 0;
  bool moves_ = false, has_room_ = false, offers_ = false, taken_ = false;
  std::deque<std::uint64_t> fifo_, buffer_;
};

TEST(ClockQueue, ABufferBehindItTakesATokenAsSoonAsAPlaceIsFree) {
  constexpr unsigned kRoom = 3, kStages = 4;
  hls::testing::Random random(1);
  ClockQueue queue(kRoom);
  queue.put_buffer_behind();
  EveryClock expected(kRoom);
  unsigned sent = 0, taken = 0, refused = 0;
  for (std::uint64_t now = 0; now < 4000; ++now) {
    expected.begin(now);
    ASSERT_EQ(queue.offers(now), expected.offers()) << now;
    // The reader is slow in every other stretch of clocks, so that the FIFO fills.
    const bool reads = random.below(now / 100 % 2 == 0 ? 2 : 8) == 0;
    if (reads && expected.offers()) {
      queue.pop(now);
      expected.take();
      ++taken;
    }
    const bool room = queue.has_room(now);
    ASSERT_EQ(room, expected.has_room()) << now;
    if (room && random.below(3) != 0) {
      queue.push(now + kStages);
      expected.push(now + kStages);
      ++sent;
    }
    if (!room) {
      ++refused;
      ASSERT_GT(queue.has_room_from(now), now);
    }
    expected.end();
  }
  EXPECT_GT(refused, 100u);
  EXPECT_GT(taken, 500u);
  EXPECT_LE(taken, sent);
}

TEST(ClockQueue, APlaceThatBecomesFreeIsUsedInTheNextClock) {
  ClockQueue queue(1);
  queue.push(2);
  EXPECT_TRUE(queue.has_room(1)) << "the token has not come yet";
  EXPECT_FALSE(queue.has_room(2));
  EXPECT_EQ(queue.has_room_from(2), hls::kNever);
  queue.pop(2);
  EXPECT_FALSE(queue.has_room(2));
  EXPECT_EQ(queue.has_room_from(2), 3u);
  EXPECT_TRUE(queue.has_room(3));
}

}  // namespace
