// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs a Verilated top in time: clocks that the bench drives, as an oscillator does, and models in
// the Verilog that keep time of their own, as a PLL's. Verilate it with TIMING
// (cmake/Verilate.cmake).
#pragma once

#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dynrt::host {

template <class Top>
class TimedTop {
 public:
  explicit TimedTop(Top& top) : top_(top) {}
  TimedTop(const TimedTop&) = delete;
  TimedTop& operator=(const TimedTop&) = delete;

  /// A clock at a pin of one bit, which rises first after half a period. In ps; a period of odd
  /// length is high for the shorter part.
  void add_clock(CData& pin, std::uint64_t period_ps) {
    pin = 0;
    clocks_.push_back({&pin, period_ps, now() + period_ps / 2});
  }

  /// Runs for so many ps. `look(now)` is called with the time, in ps, after everything that
  /// happens at one time has happened.
  template <class Look>
  void run(std::uint64_t ps, Look look) {
    run(ps, look, [](std::uint64_t) {});
  }
  /// `before(next)` is called before that, to drive pins that change until then.
  template <class Look, class Before>
  void run(std::uint64_t ps, Look look, Before before) {
    const std::uint64_t end = now() + ps;
    top_.eval();
    while (!top_.contextp()->gotFinish()) {
      std::uint64_t next = top_.eventsPending() ? top_.nextTimeSlot() : kNever;
      for (const Clock& clock : clocks_) next = std::min(next, clock.next);
      if (next > end) break;
      before(next);
      top_.contextp()->time(next);
      for (Clock& clock : clocks_) {
        if (clock.next == next) clock.toggle();
      }
      top_.eval();
      look(next);
    }
    top_.contextp()->time(end);
  }
  std::uint64_t now() const { return top_.contextp()->time(); }

 private:
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};

  struct Clock {
    CData* pin;
    std::uint64_t period;
    std::uint64_t next;
    void toggle() {
      *pin = *pin == 0;
      next += *pin != 0 ? period / 2 : period - period / 2;
    }
  };

  Top& top_;
  std::vector<Clock> clocks_;
};

}  // namespace dynrt::host
