// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The primitives between two clocks, whose edges come in any order, at once too.
#include <deque>
#include <random>

#include "Vhls_clock_fifo.h"
#include "Vhls_reset.h"
#include "rtl/lib/lib_test.h"

namespace dynrt::rtl {
namespace {

/// Which of two clocks has an edge next: the ratio of their rates changes from phase to phase.
class Edges {
 public:
  explicit Edges(std::uint_fast32_t seed) : random_(seed) {}
  void draw(unsigned t) {
    constexpr unsigned kOften[][2] = {{8, 8}, {8, 1}, {1, 8}, {5, 7}};
    const auto& often = kOften[t / 3000 % 4];
    do {
      writer = random_() % 8 < often[0];
      reader = random_() % 8 < often[1];
    } while (!writer && !reader);
  }
  bool writer = false, reader = false;

 private:
  std::mt19937 random_;
};

TEST(HlsClockFifo, KeepsTokensInOrderWhateverTheClocks) {
  VerilatedContext context;
  context.randReset(2);
  Vhls_clock_fifo v(&context);  // 13 bits, 8 places
  std::mt19937 random(1);
  Edges edges(2);
  std::deque<unsigned> held;
  const auto edge = [&](bool writer, bool reader) {
    v.clk_i = v.read_clk_i = 0;
    v.eval();
    v.clk_i = writer;
    v.read_clk_i = reader;
    v.eval();
  };
  v.rst_ni = v.read_rst_ni = 0;
  v.valid_i = v.ready_i = 0;
  for (unsigned i = 0; i < 4; ++i) edge(true, true);
  v.rst_ni = 1;
  edge(true, false);
  v.read_rst_ni = 1;
  std::size_t most = 0;
  unsigned left = 0;
  unsigned waits = 0;  // edges of the reader since a token waits for it
  for (unsigned t = 0; t < 3 * kClocks; ++t) {
    edges.draw(t);
    v.valid_i = chance(random, t, 0);
    v.ready_i = chance(random, t, 1);
    v.data_i = random() % 8192;
    v.clk_i = v.read_clk_i = 0;
    v.eval();
    const bool push = edges.writer && v.valid_i && v.ready_o;
    const bool pop = edges.reader && v.valid_o && v.ready_i;
    ASSERT_FALSE(v.valid_o && held.empty()) << t;
    if (v.valid_o) ASSERT_EQ(v.data_o, held.front()) << t;
    waits = held.empty() || v.valid_o ? 0 : waits + edges.reader;
    ASSERT_LE(waits, 4u) << t;
    if (pop) held.pop_front(), ++left;
    if (push) held.push_back(v.data_i);
    ASSERT_LE(held.size(), 8u) << t;
    most = std::max(most, held.size());
    edge(edges.writer, edges.reader);
  }
  EXPECT_EQ(most, 8u);
  EXPECT_GT(left, kClocks / 8);
}

TEST(HlsReset, FallsAtOnceAndRisesWithTheClock) {
  VerilatedContext context;
  context.randReset(2);
  Vhls_reset v(&context);
  v.rst_ni = 1;
  v.eval();
  for (unsigned times = 0; times < 3; ++times) {
    v.rst_ni = 0;
    v.eval();
    EXPECT_EQ(v.rst_no, 0);  // without an edge
    for (int i = 0; i < 5; ++i) settle(v), clock(v);
    EXPECT_EQ(v.rst_no, 0);
    v.rst_ni = 1;
    v.eval();
    for (int i = 0; i < 3; ++i) {
      settle(v), clock(v);
      EXPECT_EQ(v.rst_no, 0);
    }
    settle(v), clock(v);
    EXPECT_EQ(v.rst_no, 0b111);  // all parts at the same edge
  }
}

}  // namespace
}  // namespace dynrt::rtl
