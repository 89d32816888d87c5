// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Hands right schedules to the checker, and schedules that were made wrong in one place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "cosim/random_netlist.h"
#include "error.h"
#include "schedule/schedule.h"
#include "schedule/test_unit.h"

namespace hlsc {
namespace {

using testing::HasSubstr;

constexpr double kClockNs = 3.5;

/// What the checker says, or nothing.
std::string verdict(const Circuit& c, const DelayModel& delay, double clock_ns, const Schedule& s) {
  try {
    check_schedule({c, delay, clock_ns, clock_ns}, s);
  } catch (const Error& error) {
    return error.text();
  }
  return "";
}

/// One of each: configuration, register, register file, RAM, multiplier, chain of sums.
Netlist one_of_each() {
  Unit u(64);
  u.n.unit = "test::Unit";
  u.n.source = "unit.h";
  const unsigned scales = u.port(PortKind::kConfig, "scales", 16);
  const unsigned file = u.port(PortKind::kRegisterFile, "counts", 8, 16);
  const unsigned ram = u.port(PortKind::kRam, "slots", 16, 512, 1);
  u.n.registers.push_back({"total", 8, Bits(8, 0), kNoNode, {"unit.h", 12}});
  u.b.set_line({"unit.h", 20});
  const auto named = [&u](NodeId id, const char* name) {
    u.b.name(id, name);
    return id;
  };
  const NodeId scale =
      named(u.b.add(u.b.source(Op::kConfig, scales, 0, 8), u.b.source(Op::kConfig, scales, 8, 8)),
            "scale");
  const NodeId total = u.b.source(Op::kRegister, 0, 0, 8);
  u.n.registers[0].next = named(u.b.logic(Op::kXor, total, u.in(0, 8)), "next");
  const NodeId count = u.read(file, u.in(8, 4));
  u.write(file, u.in(8, 4), u.b.logic(Op::kXor, count, u.in(0, 8)));
  const NodeId row = u.read(ram, u.in(16, 9));
  const NodeId sum = named(u.b.add(u.in(32, 16), u.b.zext(scale, 16)), "sum");
  const NodeId more = named(u.b.add(sum, row), "more");
  u.write(ram, u.in(16, 9), more);
  const NodeId product = named(u.b.mul(u.b.zext(more, 32), u.b.zext(u.in(48, 16), 32)), "product");
  u.out(u.b.concat({named(u.b.invert(product), "inverse"), total, count}));
  return u.n;
}

class Checker : public testing::Test {
 protected:
  Checker() {
    mark_still(c_, delay_, kClockNs);
    right_ = schedule_asap(c_, delay_, kClockNs);
  }

  CellId cell(CellKind kind, unsigned index = 0) const {
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      if (c_.cells[id].kind == kind && c_.cells[id].index == index) return id;
    }
    throw std::logic_error("test: there is no such cell");
  }
  CellId named(const std::string& name) const {
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      if (c_.cells[id].kind == CellKind::kOperation && n_.nodes[c_.cells[id].node].name == name) {
        return id;
      }
    }
    throw std::logic_error("test: there is no " + name);
  }
  int stage(CellId id) const { return right_.stage[id]; }

  void expect_wrong(const std::vector<std::pair<CellId, int>>& moved, const std::string& says) {
    Schedule s = right_;
    for (const auto& [id, stage] : moved) s.stage[id] = stage;
    EXPECT_THAT(verdict(c_, delay_, kClockNs, s), HasSubstr(says));
  }

  const Netlist n_ = one_of_each();
  const DelayModel delay_ = round_numbers();
  Circuit c_{n_};
  Schedule right_;
};

TEST_F(Checker, AcceptsARightSchedule) {
  EXPECT_EQ(verdict(c_, delay_, kClockNs, right_), "");
  EXPECT_EQ(right_.stages, 5);
}

TEST_F(Checker, NamesUnitCellAndLine) {
  expect_wrong({{named("sum"), 4}},
               "unit.h:20: error: hlsc made a wrong schedule of test::Unit: 'more' (add of 16 "
               "bits) is in stage 2, but reads a value that comes later: 'sum' (add of 16 bits) is "
               "in stage 4; this is a mistake in hlsc and not in the unit, please report it");
}

TEST_F(Checker, SeesCellsWithoutAStage) {
  Schedule s = right_;
  s.stage.pop_back();
  EXPECT_THAT(verdict(c_, delay_, kClockNs, s), HasSubstr("unit.h: error: "));
  EXPECT_THAT(verdict(c_, delay_, kClockNs, s), HasSubstr("cells have a stage"));
  expect_wrong({{named("sum"), -1}}, "'sum' (add of 16 bits) is in stage -1, but the stages are 0");
  expect_wrong({{named("inverse"), 5}}, "is in stage 5, but the stages are 0 to 4");
}

TEST_F(Checker, SeesStillCellsThatMove) {
  expect_wrong({{named("scale"), 0}}, "'scale' (add of 8 bits) stands still, but it has stage 0");
  c_.still[named("sum")] = true;
  expect_wrong({{named("sum"), -1}}, "stands still, but reads a value that does not: 'in' is in");
  c_.still[named("sum")] = false;
  c_.still[cell(CellKind::kRegister)] = true;
  expect_wrong({{cell(CellKind::kRegister), -1}}, "stands still, but only configuration does");
}

TEST_F(Checker, SeesAMultiplierWithoutRegisters) {
  const CellId product = named("product");
  expect_wrong({{product, stage(named("more"))}}, "a multiplier has registers on both sides");
  expect_wrong({{named("inverse"), stage(product)}}, "a multiplier has registers on both sides");
}

TEST_F(Checker, SeesTokensInWrongStages) {
  expect_wrong({{cell(CellKind::kToken), 1}}, "'in' is in stage 1, but ");
  Schedule s = right_;
  ++s.stages;
  EXPECT_THAT(verdict(c_, delay_, kClockNs, s),
              HasSubstr("the write to 'out' is in stage 4, but tokens leave in the last stage, 5"));
}

TEST_F(Checker, SeesARowThatComesAtAnotherTime) {
  const CellId slots = cell(CellKind::kRow, 1);
  expect_wrong({{slots, 0}},
               "but the read of 'slots' is in stage 0, and a row comes 1 stages after");
  expect_wrong({{cell(CellKind::kRow, 0), 1}}, "and a row comes 0 stages after its read");
}

TEST_F(Checker, SeesARamWrittenBeforeItsReadIsOver) {
  // In a RAM of its own, as nothing that this write needs comes later than its read.
  Unit u(25);
  u.n.unit = "test::Unit";
  const unsigned ram = u.port(PortKind::kRam, "slots", 16, 512, 1);
  u.out(u.read(ram, u.in(0, 9)));
  u.write(ram, u.in(0, 9), u.in(9, 16));
  const Circuit c(u.n);
  Schedule s = schedule_asap(c, delay_, kClockNs);
  EXPECT_EQ(verdict(c, delay_, kClockNs, s), "");
  for (CellId id = 0; id < c.cells.size(); ++id) {
    if (c.cells[id].kind == CellKind::kRowWrite) s.stage[id] = 0;
  }
  EXPECT_THAT(verdict(c, delay_, kClockNs, s),
              HasSubstr("unit.h:7: error: hlsc made a wrong schedule of test::Unit: the write to "
                        "'slots' is in stage 0, but the read of 'slots' is in stage 0, and a RAM's "
                        "row is written in a later stage than it is read"));
}

TEST_F(Checker, SeesStateThatIsReadAndWrittenInSeveralStages) {
  const CellId next = named("next");
  const CellId write = cell(CellKind::kRegisterWrite);
  expect_wrong({{next, 4}, {write, 4}}, "the next value of register 'total' is in stage 4, but");
  expect_wrong({{cell(CellKind::kRowWrite, 0), 4}}, "the write to 'counts' is in stage 4, but");
  // A value that does not depend on the register may come too early for order to notice.
  Unit u(8);
  u.n.unit = "test::Unit";
  u.n.registers.push_back({"last", 8, Bits(8, 0), kNoNode, {"unit.h", 12}});
  u.out(u.b.source(Op::kRegister, 0, 0, 8));
  u.n.registers[0].next = u.in(0, 8);
  const Circuit c(u.n);
  Schedule s = schedule_asap(c, delay_, kClockNs);
  EXPECT_EQ(verdict(c, delay_, kClockNs, s), "");
  s.stages = 2;
  for (CellId id = 0; id < c.cells.size(); ++id) {
    const CellKind kind = c.cells[id].kind;
    s.stage[id] = kind == CellKind::kRegister || kind == CellKind::kTokenWrite ? 1 : 0;
  }
  EXPECT_THAT(verdict(c, delay_, kClockNs, s),
              HasSubstr("unit.h:12: error: hlsc made a wrong schedule of test::Unit: the "
                        "next value of "
                        "register 'last' is in stage 0, but register 'last' is in stage 1, so that "
                        "it reads what later transactions write"));
}

TEST_F(Checker, SeesAnInitiationIntervalOfSeveralClocks) {
  expect_wrong({{named("next"), 2}, {cell(CellKind::kRegisterWrite), 2}},
               "so that a transaction could start only every 3 clocks");
}

TEST_F(Checker, SeesAPathThatMissesThePeriod) {
  EXPECT_THAT(verdict(c_, delay_, 2, right_),
              HasSubstr("but the path to it needs 2.50 ns of a period of 2.00"));
  try {
    check_schedule({c_, delay_, kClockNs, 1}, right_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.text(), HasSubstr("'scale' (add of 8 bits) stands still, but the path to it "
                                        "needs 1.70 ns of a period of 1.00"));
  }
}

/// Whether a schedule keeps the constraints that the solvers work with.
bool keeps_constraints(const Circuit& c, const DelayModel& delay, double clock_ns,
                       const Schedule& s) {
  Timing timing(c, delay);
  for (const Precedence& p : precedences(c, timing)) {
    if (s.stage[p.user] < s.stage[p.of] + p.distance) return false;
  }
  for (CellId id = 0; id < c.cells.size(); ++id) {
    const CellKind kind = c.cells[id].kind;
    if (kind == CellKind::kToken && s.stage[id] != 0) return false;
    if (kind == CellKind::kTokenWrite && s.stage[id] != s.stages - 1) return false;
    if (timing.evaluate(id, s.stage) > clock_ns - delay.clock_overhead + 1e-9) return false;
  }
  return true;
}

/// Moves each cell of random netlists by a stage: checker and solvers have one opinion.
TEST(CheckerAndSolvers, AgreeOnWhatIsWrong) {
  unsigned right = 0;
  unsigned wrong = 0;
  for (std::uint32_t seed = 4000; seed < 4030; ++seed) {
    const Options options = random_options(seed, DELAY_FOLDER);
    const Netlist n = optimise(random_netlist(seed), options);
    const double clock_ns = options.clock_ns;
    Circuit c(n);
    mark_still(c, options.delay, clock_ns);
    const Schedule asap = schedule_asap(c, options.delay, clock_ns);
    for (const Schedule& made : {asap, minimise_registers(c, options.delay, clock_ns, asap)}) {
      ASSERT_EQ(verdict(c, options.delay, clock_ns, made), "") << seed;
      Schedule s = made;
      for (CellId id = 0; id < c.cells.size(); ++id) {
        for (const int by : {-1, 1}) {
          s.stage[id] = made.stage[id] + by;
          if (c.still[id] || s.stage[id] < 0 || s.stage[id] >= s.stages) continue;
          const bool keeps = keeps_constraints(c, options.delay, clock_ns, s);
          const std::string says = verdict(c, options.delay, clock_ns, s);
          ASSERT_EQ(says.empty(), keeps) << seed << ": " << c.describe(id) << ": " << says;
          ++(keeps ? right : wrong);
        }
        s.stage[id] = made.stage[id];
      }
    }
  }
  EXPECT_GT(right, 100u);
  EXPECT_GT(wrong, 1000u);
}

}  // namespace
}  // namespace hlsc
