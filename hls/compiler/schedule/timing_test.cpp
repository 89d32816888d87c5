// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "schedule/timing.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "schedule/test_unit.h"

namespace hlsc {
namespace {

/// Arrival of what the only token write writes, all in one stage.
double arrival(const Netlist& n, const DelayModel& delay = round_numbers()) {
  const Circuit c(n);
  Timing timing(c, delay);
  const std::vector<int> stage(c.cells.size(), 0);
  double last = 0;
  for (CellId id = 0; id < c.cells.size(); ++id) last = timing.evaluate(id, stage);
  return last;
}

TEST(Timing, ChainedLogicCostsALevelForFourInputs) {
  for (const auto& [inputs, levels] : {std::pair{4u, 1.0}, {5u, 2.0}, {7u, 2.0}, {8u, 3.0}}) {
    Unit u(inputs);
    NodeId chain = u.in(0, 1);
    for (unsigned i = 1; i < inputs; ++i) chain = u.b.logic(Op::kXor, chain, u.in(i, 1));
    u.out(chain);
    EXPECT_DOUBLE_EQ(arrival(u.n), levels) << inputs << " inputs";
  }
}

TEST(Timing, AMuxOfMuxedInputsIsOneLevelWhereOneLutHoldsIt) {
  Unit u(20);
  const NodeId inner = u.b.mux(u.in(0, 1), u.in(2, 8), u.in(10, 8));
  u.out(u.b.logic(Op::kAnd, inner, u.b.sext(u.in(1, 1), 8)));
  EXPECT_DOUBLE_EQ(arrival(u.n), 1.0);
}

TEST(Timing, CarryChainsPassBitsOnAsTheyCome) {
  Unit u(48);
  const NodeId sum = u.b.add(u.in(0, 16), u.in(16, 16));
  u.out(sum);
  const double one = arrival(u.n);
  EXPECT_NEAR(one, 1 + 15 * 0.1, 1e-9);
  Unit v(48);
  v.out(v.b.add(v.b.add(v.in(0, 16), v.in(16, 16)), v.in(32, 16)));
  EXPECT_NEAR(arrival(v.n), one + 1, 1e-9);
}

TEST(Timing, EqualityIsATree) {
  Unit u(64);
  u.out(u.b.equal(u.in(0, 32), u.in(32, 32)));
  EXPECT_DOUBLE_EQ(arrival(u.n), 3.0);  // 2 pairs a LUT, then 4 to 1, 4 to 1
}

TEST(Timing, ASignalWithManyReadersComesLaterToAllOfThem) {
  DelayModel delay = round_numbers();
  delay.fanout_two = 0.25;
  delay.fanout = 0.5;
  const auto after_readers = [&delay](unsigned readers) {
    Unit u(1 + readers);
    std::vector<NodeId> read;
    for (unsigned i = 0; i < readers; ++i) {
      read.push_back(u.b.logic(Op::kXor, u.in(0, 1), u.in(1 + i, 1)));
    }
    u.out(u.b.concat(read));
    return arrival(u.n, delay);
  };
  EXPECT_DOUBLE_EQ(after_readers(1), 1.0);
  EXPECT_DOUBLE_EQ(after_readers(2), 1.25);
  EXPECT_DOUBLE_EQ(after_readers(8), 1.25);
  EXPECT_DOUBLE_EQ(after_readers(32), 1 + 0.25 + 2 * 0.5) << "two doublings of eight";
}

TEST(Timing, TheConditionOfATokenComesEarlierThanItsData) {
  DelayModel delay = round_numbers();
  delay.token_out = 0.5;
  delay.token_enable = 3;
  Unit u(4);
  const NodeId data = u.b.logic(Op::kXor, u.in(0, 1), u.in(1, 1));
  u.n.token_writes.push_back({u.port(PortKind::kOut, "out", 1), u.b.constant(1, 1), data});
  EXPECT_DOUBLE_EQ(arrival(u.n, delay), 1 + 0.5);
  u.n.token_writes[0].enable = u.b.logic(Op::kAnd, u.in(2, 1), u.in(3, 1));
  EXPECT_DOUBLE_EQ(arrival(u.n, delay), 1 + 3);
}

/// When the row of a RAM arrives.
double row_arrival(unsigned rows, unsigned width, const DelayModel& delay) {
  Unit u(6);
  u.out(u.read(u.port(PortKind::kRam, "slots", width, rows, 1), u.in(0, 6)));
  const Circuit c(u.n);
  Timing timing(c, delay);
  const std::vector<int> stage(c.cells.size(), 0);
  double row = -1;
  for (CellId id = 0; id < c.cells.size(); ++id) {
    timing.evaluate(id, stage);
    if (c.cells[id].kind == CellKind::kRow) row = timing.arrival({id, 0});
  }
  return row;
}

TEST(Timing, AWideRamOfFewRowsIsBlockRam) {
  DelayModel delay = round_numbers();
  delay.lut_ram_rows = 32;
  EXPECT_DOUBLE_EQ(row_arrival(32, 63, delay), 0) << "LUT RAM, with a register behind it";
  EXPECT_DOUBLE_EQ(row_arrival(32, 64, delay), delay.ram_out);
  EXPECT_DOUBLE_EQ(row_arrival(31, 64, delay), 0);
}

TEST(Timing, ARamOfFewBitsIsOfLutsByItsWidthRoundedUp) {
  DelayModel delay = round_numbers();
  delay.lut_ram_bits = 64 * 20;
  EXPECT_DOUBLE_EQ(row_arrival(64, 20, delay), 0) << "LUT RAM, with a register behind it";
  EXPECT_DOUBLE_EQ(row_arrival(64, 21, delay), delay.ram_out) << "block RAM: 24 bits wide";
  delay.lut_ram_bits = 64 * 21;
  EXPECT_DOUBLE_EQ(row_arrival(64, 21, delay), delay.ram_out) << "block RAM: 24 bits wide";
}

/// When the inverse of a source arrives, a number of stages behind it.
double behind(unsigned stages, NodeId (*source)(Unit&), CellKind kind, const DelayModel& delay) {
  Unit u(16);
  u.out(u.b.invert(source(u)));
  const Circuit c(u.n);
  Timing timing(c, delay);
  std::vector<int> stage(c.cells.size(), static_cast<int>(stages));
  double last = 0;
  for (CellId id = 0; id < c.cells.size(); ++id) {
    const bool is_source =
        kind == CellKind::kOperation ? c.is_multiply(id) : c.cells[id].kind == kind;
    if (is_source) stage[id] = 0;
    last = timing.evaluate(id, stage);
  }
  return last;
}

TEST(Timing, ARegisterInABlockComesLaterThanOneAmongLuts) {
  DelayModel delay = round_numbers();
  const auto product = [](Unit& u) {
    return u.b.mul(u.b.zext(u.in(0, 8), 16), u.b.zext(u.in(8, 8), 16));
  };
  const auto row = [](Unit& u) {
    return u.read(u.port(PortKind::kRam, "slots", 64, 64, 1), u.in(0, 6));
  };
  const auto token = [](Unit& u) { return u.in(0, 8); };
  const double late = delay.lut + delay.block_register;
  EXPECT_DOUBLE_EQ(behind(1, product, CellKind::kOperation, delay), late);
  EXPECT_DOUBLE_EQ(behind(2, product, CellKind::kOperation, delay), delay.lut);
  EXPECT_DOUBLE_EQ(behind(1, row, CellKind::kRow, delay), late);
  EXPECT_DOUBLE_EQ(behind(2, row, CellKind::kRow, delay), delay.lut);
  EXPECT_DOUBLE_EQ(behind(1, token, CellKind::kToken, delay), delay.lut);
}

}  // namespace
}  // namespace hlsc
