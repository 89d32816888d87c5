// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The primitives that tokens pass, under random traffic, against what they stand for in C++.
#include <algorithm>
#include <deque>
#include <random>
#include <vector>

#include "Vhls_arbiter.h"
#include "Vhls_buffer.h"
#include "Vhls_fifo.h"
#include "Vhls_fifo_bounded.h"
#include "Vhls_fifo_margin.h"
#include "Vhls_fork.h"
#include "Vhls_repeat.h"
#include "rtl/lib/lib_test.h"

namespace dynrt::rtl {
namespace {

/// Random tokens through a queue of 13 bits: they keep their order, and it is ready while it has
/// one of `places` free.
template <class V>
void expect_order(V& v, std::uint_fast32_t seed, std::size_t places) {
  std::mt19937 random(seed);
  std::deque<unsigned> held;
  v.valid_i = v.ready_i = 0;
  reset(v);
  unsigned full = 0;
  unsigned left = 0;
  for (unsigned t = 0; t < kClocks; ++t) {
    v.valid_i = chance(random, t, 0);
    v.ready_i = chance(random, t, 1);
    v.data_i = random() % 8192;
    settle(v);
    ASSERT_EQ(v.valid_o != 0, !held.empty()) << t;
    ASSERT_EQ(v.ready_o != 0, held.size() < places) << t;
    full += held.size() == places ? 1 : 0;
    const bool push = v.valid_i && v.ready_o;
    if (v.valid_o && v.ready_i) {
      ASSERT_EQ(v.data_o, held.front()) << t;
      held.pop_front();
      ++left;
    }
    if (push) held.push_back(v.data_i);
    clock(v);
  }
  EXPECT_GT(full, 100u);
  EXPECT_GT(left, kClocks / 8);
}

TEST(HlsFifo, KeepsOrderAndCountsItsPlaces) {
  VerilatedContext context;
  Vhls_fifo v(&context);  // 6 places
  expect_order(v, 1, 6);
}

TEST(HlsFifo, WithAMarginTakesWhatWasOnTheWay) {
  VerilatedContext context;
  Vhls_fifo_margin v(&context);  // 13 bits, 16 places, margin 5
  std::mt19937 random(2);
  std::deque<unsigned> held;
  std::deque<bool> way(5, false);  // what was started 5 clocks ago arrives now
  v.valid_i = v.ready_i = 0;
  reset(v);
  std::size_t most = 0;
  for (unsigned t = 0; t < kClocks; ++t) {
    v.valid_i = way.front();
    way.pop_front();
    v.ready_i = chance(random, t, 1);
    v.data_i = random() % 8192;
    settle(v);
    ASSERT_EQ(v.ready_o != 0, held.size() + 5 < 16) << t;
    if (v.valid_o && v.ready_i) {
      ASSERT_EQ(v.data_o, held.front()) << t;
      held.pop_front();
    }
    if (v.valid_i) held.push_back(v.data_i);
    ASSERT_LE(held.size(), 16u);
    most = std::max(most, held.size());
    way.push_back(v.ready_o && chance(random, t, 0));
    clock(v);
  }
  EXPECT_EQ(most, 16u);
}

TEST(HlsFifo, BoundedIsAlwaysReadyAndHoldsItsDepth) {
  VerilatedContext context;
  Vhls_fifo_bounded v(&context);  // 13 bits, 6 places
  std::mt19937 random(7);
  std::deque<unsigned> held;
  v.valid_i = v.ready_i = 0;
  reset(v);
  unsigned full = 0;
  unsigned passed_full = 0;
  for (unsigned t = 0; t < kClocks; ++t) {
    v.ready_i = chance(random, t, 1);
    // The promise: a token comes to a full FIFO only in the clock in which another one leaves.
    v.valid_i = chance(random, t, 0) && (held.size() < 6 || v.ready_i);
    v.data_i = random() % 8192;
    settle(v);
    ASSERT_TRUE(v.ready_o) << t;
    ASSERT_EQ(v.valid_o != 0, !held.empty()) << t;
    full += held.size() == 6 ? 1 : 0;
    passed_full += held.size() == 6 && v.valid_i ? 1 : 0;
    if (v.valid_o && v.ready_i) {
      ASSERT_EQ(v.data_o, held.front()) << t;
      held.pop_front();
    }
    if (v.valid_i) held.push_back(v.data_i);
    clock(v);
  }
  EXPECT_GT(full, 100u);
  EXPECT_GT(passed_full, 100u);
}

TEST(HlsFifo, ATokenTooManyStopsTheSimulation) {
  VerilatedContext context;
  context.fatalOnError(false);
  Vhls_fifo_bounded v(&context);  // 6 places
  v.valid_i = v.ready_i = 0;
  reset(v);
  v.valid_i = 1;
  for (unsigned token = 1; token <= 7; ++token) {
    settle(v), clock(v);
    EXPECT_EQ(context.gotError(), token == 7) << "token " << token;
  }
}

TEST(HlsBuffer, KeepsOrderAndHoldsTwo) {
  VerilatedContext context;
  context.randReset(2);
  Vhls_buffer v(&context);
  expect_order(v, 5, 2);
}

TEST(HlsArbiter, GivesEveryInputItsTurn) {
  VerilatedContext context;
  Vhls_arbiter v(&context);  // 3 inputs of 8 bits
  std::mt19937 random(3);
  v.valid_i = 0;
  v.ready_i = 0;
  reset(v);
  std::vector<unsigned> waited(3, 0);
  std::vector<unsigned> sent(3, 0);
  unsigned granted = 0;
  for (unsigned t = 0; t < kClocks; ++t) {
    v.valid_i = t < 1000 ? 7 : (v.valid_i | random()) % 8;
    v.ready_i = random() % 3 != 0;
    v.data_i = 0x332211 + (random() % 2) * 0x444444;
    settle(v);
    ASSERT_EQ(v.ready_o, v.ready_i ? 1u << granted : 0u) << t;
    ASSERT_EQ(v.valid_o, v.valid_i >> granted & 1) << t;
    if (v.valid_o) ASSERT_EQ(v.data_o, v.data_i >> (8 * granted) & 0xff);
    const unsigned left = v.valid_i & ~(v.valid_o ? v.ready_o : 0u);
    for (unsigned i = 0; i < 3; ++i) {
      if (v.valid_o && v.ready_o >> i & 1) {
        waited[i] = 0;
        ++sent[i];
      } else if ((v.valid_i >> i & 1) != 0 && v.valid_o && v.ready_i) {
        ASSERT_LE(++waited[i], 2u) << "input " << i << " waited for more than the others";
      }
    }
    if (v.ready_i) {
      const unsigned waiting = v.valid_i & ~(1u << granted);
      const unsigned next = (granted + 1) % 3, last = (granted + 2) % 3;
      granted = waiting >> next & 1 ? next : waiting >> last & 1 ? last : granted;
    }
    clock(v);
    v.valid_i = static_cast<unsigned char>(left);
  }
  for (unsigned i = 0; i < 3; ++i) EXPECT_GT(sent[i], kClocks / 10);
}

TEST(HlsArbiter, LetsALoneStreamSendInEveryClock) {
  VerilatedContext context;
  Vhls_arbiter v(&context);
  v.valid_i = 0;
  v.ready_i = 1;
  reset(v);
  v.valid_i = 4;
  for (unsigned t = 0; t < 10; ++t) {
    settle(v);
    EXPECT_EQ(v.valid_o != 0, t > 0) << "the first token waits for the grant";
    clock(v);
  }
}

TEST(HlsFork, DeliversToAllAtOnce) {
  VerilatedContext context;
  Vhls_fork v(&context);  // 3 outputs of 8 bits
  for (unsigned ready = 0; ready < 8; ++ready) {
    for (const unsigned valid : {0u, 1u}) {
      v.valid_i = static_cast<unsigned char>(valid);
      v.ready_i = static_cast<unsigned char>(ready);
      v.data_i = 0x5a;
      v.eval();
      EXPECT_EQ(v.ready_o != 0, ready == 7);
      EXPECT_EQ(v.data_o, 0x5a);
      // A transfer happens at every output or at none.
      const unsigned transfers = v.valid_o & ready;
      EXPECT_EQ(transfers, valid && ready == 7 ? 7u : 0u) << "ready " << ready;
    }
  }
}

TEST(HlsRepeat, SendsAJobAsOftenAsItSays) {
  VerilatedContext context;
  context.randReset(2);
  Vhls_repeat v(&context);  // 8 bits, the lowest 2 of which are the repetitions
  std::mt19937 random(8);
  v.valid_i = v.ready_i = 0;
  v.data_i = 0;
  reset(v);
  unsigned number = 0;
  unsigned jobs = 0;
  bool waits = false;
  for (unsigned t = 0; t < kClocks; ++t) {
    if (!waits) {
      v.valid_i = chance(random, t, 0);
      v.data_i = random() & 0xff;
    }
    v.ready_i = chance(random, t, 1);
    settle(v);
    const bool last = number == v.data_i % 4u;
    ASSERT_EQ(v.valid_o, v.valid_i) << t;
    if (v.valid_o) {
      ASSERT_EQ(v.data_o, unsigned{v.data_i} << 3 | (last ? 4u : 0u) | number) << t;
      ASSERT_EQ(v.ready_o != 0, v.ready_i && last) << t;
      if (v.ready_i) number = last ? 0 : number + 1;
    }
    jobs += v.valid_i && v.ready_o ? 1 : 0;
    waits = v.valid_i && !v.ready_o;
    clock(v);
  }
  EXPECT_GT(jobs, kClocks / 10);
}

}  // namespace
}  // namespace dynrt::rtl
