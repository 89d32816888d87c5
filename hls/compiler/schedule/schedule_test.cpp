// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "schedule/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "backend.h"
#include "cosim/random_netlist.h"
#include "error.h"
#include "netlist/builder.h"
#include "schedule/test_unit.h"

namespace hlsc {
namespace {

using testing::HasSubstr;

void expect_valid(const Circuit& c, const DelayModel& delay, double clock_ns, const Schedule& s) {
  EXPECT_NO_THROW(check_schedule({c, delay, clock_ns, clock_ns}, s));
}

TEST(Schedule, TightestPeriodNeedsNoMoreStagesAndAShorterOneDoes) {
  unsigned tighter = 0;
  for (std::uint32_t seed = 3000; seed < 3040; ++seed) {
    const Options options = random_options(seed, DELAY_FOLDER);
    const Netlist n = optimise(random_netlist(seed), options);
    const Circuit c(n);
    SCOPED_TRACE(seed);
    const int stages = schedule_asap(c, options.delay, options.clock_ns).stages;
    const double tight = tightest_period(c, options.delay, options.clock_ns);
    EXPECT_LE(tight, options.clock_ns);
    EXPECT_EQ(schedule_asap(c, options.delay, tight).stages, stages);
    tighter += tight < options.clock_ns - 0.1 ? 1 : 0;
    try {
      EXPECT_GT(schedule_asap(c, options.delay, tight - 0.01).stages, stages);
    } catch (const Error&) {  // or no number of stages is enough
    }
  }
  EXPECT_GT(tighter, 20u);
}

TEST(Schedule, IsValidAndNeedsFewerRegistersThanTheFirstOne) {
  unsigned long first = 0;
  unsigned long least = 0;
  for (std::uint32_t seed = 2000; seed < 2100; ++seed) {
    const Options options = random_options(seed, DELAY_FOLDER);
    const Netlist n = optimise(random_netlist(seed), options);
    const Circuit c(n);
    const Schedule asap = schedule_asap(c, options.delay, options.clock_ns);
    SCOPED_TRACE(seed);
    expect_valid(c, options.delay, options.clock_ns, asap);
    if (testing::Test::HasFailure()) return;
    const Schedule s = minimise_registers(c, options.delay, options.clock_ns, asap);
    expect_valid(c, options.delay, options.clock_ns, s);
    EXPECT_LE(register_bits(c, s), register_bits(c, asap));
    first += register_bits(c, asap);
    least += register_bits(c, s);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_LT(least, first * 9 / 10);
}

/// Tries all stages of all cells.
class Exhaustive {
 public:
  Exhaustive(const Circuit& c, const DelayModel& delay, double clock_ns, const Schedule& asap)
      : c_(c),
        timing_(c, delay),
        available_(clock_ns - delay.clock_overhead),
        pairs_(precedences(c, timing_)),
        schedule_(asap) {}

  unsigned long least() {
    place(0);
    return least_;
  }

 private:
  void place(CellId id) {
    if (id == c_.cells.size()) {
      least_ = std::min(least_, register_bits(c_, schedule_));
      return;
    }
    const CellKind kind = c_.cells[id].kind;
    const int last = schedule_.stages - 1;
    const int from = kind == CellKind::kTokenWrite ? last : 0;
    const int to = kind == CellKind::kToken ? 0 : last;
    for (int s = from; s <= to; ++s) {
      schedule_.stage[id] = s;
      bool fits = true;
      for (const Precedence& p : pairs_) {
        if (p.user == id && p.of < id) fits = fits && s >= schedule_.stage[p.of] + p.distance;
      }
      if (fits && timing_.evaluate(id, schedule_.stage) <= available_) place(id + 1);
    }
  }

  const Circuit& c_;
  Timing timing_;
  double available_;
  std::vector<Precedence> pairs_;
  Schedule schedule_;
  unsigned long least_ = ~0ul;
};

TEST(Schedule, FindsTheLeastRegistersOfSmallCircuits) {
  std::mt19937 random(7);
  unsigned several = 0;
  for (int round = 0; round < 150; ++round) {
    Unit u(60);
    std::vector<NodeId> pool;
    for (int i = 0; i < 4; ++i) pool.push_back(u.in(random() % 40, 1 + random() % 20));
    for (int i = 0; i < 7; ++i) {
      const unsigned w = 8 + random() % 13;
      const auto pick = [&] {
        const NodeId id = pool[pool.size() - 1 - random() % 4];
        return u.b.width(id) >= w ? u.b.trunc(id, w) : u.b.sext(id, w);
      };
      const NodeId a = pick();
      const NodeId b = pick();
      pool.push_back(random() % 4 != 0 ? u.b.add(a, b) : u.b.logic(Op::kXor, a, b));
    }
    u.out(u.b.concat({pool[pool.size() - 1], pool[pool.size() - 2], pool[pool.size() - 3]}));
    const Circuit c(u.n);
    const DelayModel delay = round_numbers();
    const double clock = 3.2;
    const Schedule asap = schedule_asap(c, delay, clock);
    const Schedule s = minimise_registers(c, delay, clock, asap);
    expect_valid(c, delay, clock, s);
    ASSERT_EQ(register_bits(c, s), Exhaustive(c, delay, clock, asap).least()) << to_text(u.n);
    several += asap.stages > 2 ? 1 : 0;
  }
  EXPECT_GT(several, 50u);
}

TEST(Schedule, WritesARamsRowAfterItsRead) {
  Unit u(12);
  const unsigned ram = u.port(PortKind::kRam, "slots", 8, 16, 1);
  const NodeId row = u.read(ram, u.in(0, 4));
  u.write(ram, u.in(0, 4), u.in(4, 8));
  u.out(row);
  const Circuit c(u.n);
  const Schedule s =
      minimise_registers(c, round_numbers(), 10, schedule_asap(c, round_numbers(), 10));
  int read = 0;
  int write = 0;
  for (CellId id = 0; id < c.cells.size(); ++id) {
    if (c.cells[id].kind == CellKind::kRowRead) read = s.stage[id];
    if (c.cells[id].kind == CellKind::kRowWrite) write = s.stage[id];
  }
  EXPECT_EQ(write - read, 1);
}

TEST(Schedule, PutsRegistersAroundAMultiplier) {
  Unit u(48);
  const NodeId sum = u.b.add(u.in(0, 16), u.in(16, 16));
  const NodeId product = u.b.mul(u.b.zext(sum, 32), u.b.zext(u.in(32, 16), 32));
  u.out(u.b.invert(product));
  const Circuit c(u.n);
  const Schedule s = schedule_asap(c, round_numbers(), 100);
  EXPECT_EQ(s.stages, 3);
}

/// The stage of a sum of configuration, to which a token is added; -1: it is still.
int stage_of_scale(double clock_ns) {
  Unit u(16);
  const unsigned scales = u.port(PortKind::kConfig, "scales", 32);
  const NodeId scale =
      u.b.add(u.b.source(Op::kConfig, scales, 0, 16), u.b.source(Op::kConfig, scales, 16, 16));
  u.out(u.b.add(u.in(0, 16), scale));
  Circuit c(u.n);
  mark_still(c, round_numbers(), clock_ns);
  const Schedule s =
      minimise_registers(c, round_numbers(), clock_ns, schedule_asap(c, round_numbers(), clock_ns));
  EXPECT_EQ(s.stages, 1);
  for (CellId id = 0; id < c.cells.size(); ++id) {
    if (c.cells[id].kind == CellKind::kOperation) return s.stage[id];
  }
  return 100;
}

TEST(Schedule, ComputesBeforehandWhatDependsOnConfigurationAlone) {
  EXPECT_EQ(stage_of_scale(2.6), -1);
}

TEST(Schedule, RefusesLoopsThatShareLogicAndDoNotFitTogether) {
  Unit u(32);
  for (const char* name : {"first", "second"}) {
    u.n.registers.push_back({name, 16, Bits(16, 0), kNoNode, {"unit.h", 12}});
  }
  const NodeId first = u.b.source(Op::kRegister, 0, 0, 16);
  const NodeId second = u.b.source(Op::kRegister, 1, 0, 16);
  const NodeId sum = u.b.add(first, u.in(0, 16));
  u.n.registers[0].next = u.b.logic(Op::kXor, second, u.in(16, 16));
  u.n.registers[1].next = u.b.add(sum, sum);
  u.out(sum);
  Circuit c(u.n);
  EXPECT_NO_THROW(schedule_asap(c, round_numbers(), 3.7));
  EXPECT_THROW(schedule_asap(c, round_numbers(), 2.6), Error) << "and comes to an end";
}

std::string refusal(const Netlist& n, double clock_ns) {
  try {
    const Circuit c(n);
    schedule_asap(c, round_numbers(), clock_ns);
  } catch (const Error& error) {
    return error.text();
  }
  return "";
}

Netlist accumulator(unsigned width) {
  Unit u(width);
  u.n.registers.push_back({"total", width, Bits(width, 0), kNoNode, {"unit.h", 12}});
  const NodeId total = u.b.source(Op::kRegister, 0, 0, width);
  u.n.registers[0].next = u.b.add(total, u.in(0, width));
  u.out(total);
  return u.n;
}

TEST(Schedule, RefusesARegisterWhoseFeedbackMissesTheClock) {
  EXPECT_EQ(refusal(accumulator(16), 3), "");
  EXPECT_EQ(refusal(accumulator(64), 3),
            "unit.h:12: error: register total needs 7.30 ns from its value to its next value, "
            "which must be in one stage, but --clock-ns 3 leaves 3.00; give --clock-ns 7.30, the "
            "least that this unit reaches, or compute less between the two");
  EXPECT_EQ(refusal(accumulator(64), 7.3), "");
}

TEST(Schedule, RefusesARegisterFileWhoseUpdateMissesTheClock) {
  Unit u(68);
  const unsigned file = u.port(PortKind::kRegisterFile, "totals", 64, 16);
  const NodeId row = u.read(file, u.in(0, 4));
  u.write(file, u.in(0, 4), u.b.add(row, u.in(4, 64)));
  u.out(row);
  EXPECT_EQ(refusal(u.n, 10), "");
  EXPECT_EQ(refusal(u.n, 8),
            "unit.h:7: error: register file totals needs 9.30 ns from the row that it reads to the "
            "row that it writes, which must be in one stage, but --clock-ns 8 leaves 8.00; give "
            "--clock-ns 9.30, the least that this unit reaches, compute less between the two or "
            "use a Ram1R1W");
}

TEST(Schedule, RefusesAnOperationThatFitsNoStage) {
  Unit u(128);
  u.b.set_line({"unit.h", 20});
  u.out(u.b.add(u.in(0, 64), u.in(64, 64)));
  EXPECT_EQ(refusal(u.n, 5),
            "unit.h:20: error: add of 64 bits needs 7.30 ns in one stage, but --clock-ns 5 leaves "
            "5.00; give --clock-ns 7.30, the least that this unit reaches, or use a narrower "
            "operation");
}

TEST(Schedule, NamesTheLeastPeriodOfTheUnitNotOfTheFirstOperationThatMisses) {
  Unit u(160);
  u.b.set_line({"unit.h", 20});
  u.out(u.b.add(u.in(0, 16), u.in(16, 16)));
  u.out(u.b.add(u.in(32, 64), u.in(96, 64)));
  EXPECT_THAT(refusal(u.n, 0.001),
              HasSubstr("but --clock-ns 0.001 leaves 0.00; give --clock-ns 7.30, the least"));
}

double least_period(const Netlist& n) { return least_period(Circuit(n), round_numbers(), 0); }

TEST(Schedule, FindsTheLeastPeriodThatAUnitReaches) {
  const double least = least_period(accumulator(64));
  EXPECT_DOUBLE_EQ(least, 7.3);
  EXPECT_EQ(refusal(accumulator(64), least), "");
  EXPECT_NE(refusal(accumulator(64), least - 0.01), "");
}

TEST(Schedule, MoreBitsNeedALongerPeriod) {
  EXPECT_LT(least_period(accumulator(16)), least_period(accumulator(64)));
}

TEST(Schedule, RefusesARegisterWhoseFeedbackFitsNoClock) {
  Unit u(16);
  u.n.registers.push_back({"product", 16, Bits(16, 0), kNoNode, {"unit.h", 12}});
  const NodeId product = u.b.source(Op::kRegister, 0, 0, 16);
  u.n.registers[0].next = u.b.mul(product, u.in(0, 16));
  u.out(product);
  const std::string said =
      "unit.h:12: error: no clock is long enough for product: its next value must be in the stage "
      "of its value, and what lies between the two, such as a multiplication, takes a stage of its "
      "own; compute that before or after";
  EXPECT_EQ(refusal(u.n, 10), said);
  EXPECT_EQ(refusal(u.n, 1000), said);
}

TEST(Schedule, RefusesAUnitWithoutEffect) {
  Unit u(8);
  u.n.source = "unit.h";
  EXPECT_THAT(refusal(u.n, 5),
              HasSubstr("unit.h: error: the unit writes no token, row or register"));
}

TEST(DelayModel, RefusesWhatIsMissing) {
  try {
    load_delay_model("no_such_file.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.text(),
              "hlsc: error: no_such_file.json: cannot read this file; name a delay model such as "
              "hls/compiler/delay/ecp5.json");
  }
}

}  // namespace
}  // namespace hlsc
