// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Who has work in which clock: a timing wheel (Varghese and Lauck, "Hashed and hierarchical timing
// wheels", 1987), with a bit for each actor in each of the next clocks. Clocks without work cost
// nothing, and neither do actors that wait.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "hls/clock_queue.h"

namespace hls {

class TimingWheel {
 public:
  explicit TimingWheel(std::size_t actors = 0)
      : words_((actors + kWordBits - 1) / kWordBits), due_(kSlots * words_), waking_(kSlots) {}

  /// Actor number `actor` has work in clock `at`, which is not before the present one.
  void wake(std::size_t actor, std::uint64_t at) {
    if (at < first_ + kSlots) {
      set(actor, at);
    } else {
      wake_later(actor, at);
    }
  }

  /// Calls act(actor, clock) in the order of clocks, in each in the order of the actors' numbers,
  /// until nobody has work. An actor may wake one with a higher number in the same clock.
  template <class Act>
  void run(Act&& act) {
    while (go_on()) {
      std::uint64_t* const due = &due_[first_ % kSlots * words_];
      for (std::size_t w = 0; w < words_; ++w) {
        while (due[w] != 0) {
          const auto bit = static_cast<std::size_t>(std::countr_zero(due[w]));
          due[w] &= due[w] - 1;
          act(w * kWordBits + bit, first_);
        }
      }
      waking_[first_ % kSlots] = false;
    }
  }

 private:
  static constexpr std::size_t kWordBits = 64;
  static constexpr std::uint64_t kSlots = 256;  ///< clocks ahead, more than a unit has stages

  void set(std::size_t actor, std::uint64_t at) {
    due_[at % kSlots * words_ + actor / kWordBits] |= std::uint64_t{1} << (actor % kWordBits);
    waking_[at % kSlots] = true;
  }
  [[gnu::noinline]] void wake_later(std::size_t actor, std::uint64_t at) {
    far_.emplace(at, actor);
  }
  /// Goes to the first clock in which somebody has work; false if nobody has.
  bool go_on() {
    std::uint64_t soonest = far_.empty() ? kNever : far_.top().first;
    for (std::uint64_t at = first_; at < first_ + kSlots && at < soonest; ++at) {
      if (waking_[at % kSlots]) soonest = at;
    }
    if (soonest == kNever) return false;
    first_ = soonest;
    for (; !far_.empty() && far_.top().first < first_ + kSlots; far_.pop()) {
      set(far_.top().second, far_.top().first);
    }
    return true;
  }

  using Far = std::pair<std::uint64_t, std::size_t>;  ///< clock, actor
  std::uint64_t first_ = 0;  ///< of the clocks that have slots: the present one
  std::size_t words_;
  std::vector<std::uint64_t> due_;
  std::vector<char> waking_;  ///< whether anybody is due, by slot
  std::priority_queue<Far, std::vector<Far>, std::greater<>> far_;
};

}  // namespace hls
