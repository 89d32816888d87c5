// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Every pass alone, and the whole order of them, against the interpreter on random netlists; and
// what each pass is there for.
#include "passes/passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "backend.h"
#include "cosim/random_netlist.h"
#include "netlist/builder.h"
#include "netlist/interpret.h"
#include "netlist/narrow.h"
#include "netlist/op.h"

namespace hlsc {
namespace {

DelayModel device(unsigned multiplier_width, bool free_add_sub = false,
                  unsigned division_digits = 1) {
  DelayModel d = load_delay_model(std::string(DELAY_FOLDER) + "/ecp5.json");
  d.multiplier_width = multiplier_width;
  d.unsigned_multiplier_width = multiplier_width - 1;
  d.free_add_sub = free_add_sub;
  d.division_digits = division_digits;
  return d;
}

class Vectors {
 public:
  explicit Vectors(std::uint32_t seed) : random_(seed) {}
  Bits bits(unsigned width) {
    Bits b(width, 0);
    const unsigned kind = random_() % 6;
    for (unsigned i = 0; i < b.words(); ++i) {
      const std::uint64_t word = std::uint64_t{random_()} << 32 | random_();
      b.set_word(i, kind == 0   ? 0
                    : kind == 1 ? ~std::uint64_t{0}
                    : kind == 2 ? word & random_()
                                : word);
    }
    return b;
  }

 private:
  std::mt19937 random_;
};

/// Both netlists write the same tokens, rows and registers.
void expect_equal(const Netlist& before, const Netlist& after, std::uint32_t seed,
                  unsigned vectors) {
  check(after);
  Interpreter a(before);
  Interpreter b(after);
  Vectors random(seed);
  for (unsigned p = 0; p < before.ports.size(); ++p) {
    const Port& port = before.ports[p];
    if (port.kind == PortKind::kConfig) {
      const Bits value = random.bits(port.width);
      a.set_config(p, value);
      b.set_config(p, value);
    }
    if (!is_ram(port.kind)) continue;
    for (Bits& row : a.rows(p)) row = random.bits(port.width);
    b.rows(p) = a.rows(p);
  }
  for (unsigned i = 0; i < vectors; ++i) {
    std::vector<Bits> tokens;
    for (const Port& port : before.ports) tokens.push_back(random.bits(port.width));
    ASSERT_EQ(a.step(tokens), b.step(tokens)) << "seed " << seed << ", vector " << i;
    for (unsigned p = 0; p < before.ports.size(); ++p) {
      if (is_ram(before.ports[p].kind)) {
        ASSERT_EQ(a.rows(p), b.rows(p)) << "seed " << seed << ", vector " << i;
      }
    }
  }
}

using Pass = std::function<Netlist(const Netlist&)>;

void expect_equal_on_random_netlists(const Pass& pass) {
  for (std::uint32_t seed = 1000; seed < 1150; ++seed) {
    const Netlist before = random_netlist(seed);
    expect_equal(before, pass(before), seed, 25);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Passes, ExpandDivisionsComputesTheSame) {
  expect_equal_on_random_netlists([](const Netlist& n) { return expand_divisions(n, device(18)); });
}
TEST(Passes, ExpandDivisionsByTwoDigitsComputesTheSame) {
  expect_equal_on_random_netlists(
      [](const Netlist& n) { return expand_divisions(n, device(18, false, 2)); });
}
TEST(Passes, ExpandDivisionsWithoutRestoringComputesTheSame) {
  expect_equal_on_random_netlists(
      [](const Netlist& n) { return expand_divisions(n, device(18, true)); });
}
TEST(Passes, SplitProductsComputesTheSame) {
  for (const unsigned width : {18u, 9u, 2u}) {
    expect_equal_on_random_netlists(
        [width](const Netlist& n) { return split_products(n, device(width)); });
  }
}
TEST(Passes, BalanceChainsComputesTheSame) { expect_equal_on_random_netlists(balance_chains); }
TEST(Passes, ExpandShiftsComputesTheSame) { expect_equal_on_random_netlists(expand_shifts); }
TEST(Passes, MergeAddSubComputesTheSame) { expect_equal_on_random_netlists(merge_add_sub); }
TEST(Passes, AllOfThemComputeTheSame) {
  Options options;
  options.delay = device(18);
  expect_equal_on_random_netlists([&](const Netlist& n) { return optimise(n, options); });
}

/// A netlist that is built node by node: In `in`, Out `out`.
struct Unit {
  Netlist n;
  Builder b{n};

  explicit Unit(unsigned width) {
    n.module = "unit";
    n.ports.push_back({PortKind::kIn, "in", width, 1, 0, {}});
  }
  NodeId in(unsigned low, unsigned width) { return b.source(Op::kToken, 0, low, width); }
  Netlist out(NodeId data) {
    n.ports.push_back({PortKind::kOut, "out", b.width(data), 1, 0, {}});
    n.token_writes.push_back({1, b.constant(1, 1), data});
    return n;
  }
};

unsigned count(const Netlist& n, Op op) {
  unsigned found = 0;
  for (const Node& node : n.nodes) found += node.op == op ? 1 : 0;
  return found;
}

/// A kAdd of a selected negation, as InstCombine leaves it.
Netlist selected_negation() {
  Unit u(33);
  const NodeId a = u.in(0, 16);
  const NodeId b = u.in(16, 16);
  const NodeId negated = u.b.sub(u.b.constant(16, 0), b);
  return u.out(u.b.add(a, u.b.mux(u.in(32, 1), negated, b)));
}

/// The longest way through nodes of one operation.
unsigned depth(const Netlist& n, Op op) {
  std::vector<unsigned> depths;
  unsigned deepest = 0;
  for (const Node& node : n.nodes) {
    unsigned d = 0;
    for (const NodeId operand : node.operands) d = std::max(d, depths[operand]);
    depths.push_back(d + (node.op == op ? 1 : 0));
    deepest = std::max(deepest, depths.back());
  }
  return deepest;
}

TEST(BalanceChains, MakesATreeOfAChainOfLogic) {
  Unit u(64);
  NodeId all = u.in(0, 4);
  for (unsigned i = 1; i < 16; ++i) all = u.b.logic(Op::kXor, all, u.in(4 * i, 4));
  const Netlist before = u.out(all);
  const Netlist after = narrow(balance_chains(before));
  EXPECT_EQ(depth(before, Op::kXor), 15u);
  EXPECT_EQ(depth(after, Op::kXor), 4u);
  EXPECT_EQ(count(after, Op::kXor), 15u);
  expect_equal(before, after, 1, 500);
}

/// The place of the lowest of 16 bits that is set: what a loop with break makes.
Netlist priority(bool late_first) {
  Unit u(32);
  NodeId first = u.in(0, 1);
  if (late_first) first = u.b.equal(u.b.mul(u.in(16, 16), u.in(16, 16)), u.b.constant(16, 9));
  NodeId place = u.b.constant(5, 16);
  for (unsigned i = 16; i-- > 1;) place = u.b.mux(u.in(i, 1), u.b.constant(5, i), place);
  return u.out(u.b.mux(first, u.b.constant(5, 0), place));
}

TEST(BalanceChains, MakesATreeOfAChainOfMuxes) {
  const Netlist before = priority(false);
  const Netlist after = narrow(balance_chains(before));
  EXPECT_GE(depth(before, Op::kMux), 12u);
  EXPECT_LE(depth(after, Op::kMux), 5u);
  expect_equal(before, after, 1, 2000);
}

TEST(BalanceChains, LeavesALateConditionToTheLastMux) {
  const Netlist before = priority(true);
  const Netlist after = narrow(balance_chains(before));
  expect_equal(before, after, 1, 2000);
  // Nothing but the last muxes and their selection waits for the product.
  const Node* product = nullptr;
  unsigned behind = 0;
  std::vector<bool> waits;
  for (const Node& node : after.nodes) {
    bool w = node.op == Op::kMul;
    if (w) product = &node;
    for (const NodeId operand : node.operands) w = w || waits[operand];
    waits.push_back(w);
    behind += w && node.op == Op::kMux ? 1 : 0;
  }
  ASSERT_NE(product, nullptr);
  EXPECT_LE(behind, 2u);
}

TEST(ExpandDivisions, SkipsDigitsThatAreKnownToBeZero) {
  // Normalised significands: 1.m / 1.n, 16 bits each, to 19 digits.
  Unit u(32);
  const NodeId one = u.b.constant(1, 1);
  const NodeId a = u.b.concat({one, u.in(0, 16), u.b.constant(18, 0)});
  const NodeId b = u.b.concat({one, u.in(16, 16)});
  const Netlist before = u.out(u.b.trunc(u.b.udiv(a, b), 19));
  const Netlist after = expand_divisions(before, device(18));
  EXPECT_EQ(count(after, Op::kUDiv), 0u);
  EXPECT_EQ(count(after, Op::kSub), 19u);
  expect_equal(before, after, 1, 2000);
  expect_equal(before, expand_divisions(before, device(18, true)), 1, 2000);
  const Netlist by_two = expand_divisions(before, device(18, false, 2));
  EXPECT_EQ(count(by_two, Op::kSub), 1u + 9 * 3);
  expect_equal(before, by_two, 1, 2000);
}

TEST(ExpandDivisions, UsesOneAddSubADigitWhereThatIsFree) {
  Unit u(20);
  const NodeId divisor = u.b.concat({u.b.constant(1, 1), u.in(12, 8)});
  const Netlist before = u.out(u.b.udiv(u.in(0, 12), divisor));
  const Netlist after = merge_add_sub(expand_divisions(before, device(18, true)));
  EXPECT_EQ(count(after, Op::kAddSub), 3u);
  EXPECT_EQ(count(after, Op::kSub) - count(expand_divisions(before, device(18)), Op::kSub), 0u);
  expect_equal(before, after, 1, 2000);
}

TEST(SplitProducts, LeavesAProductThatFitsOneMultiplier) {
  Unit u(34);
  const NodeId product = u.b.mul(u.b.zext(u.in(0, 17), 34), u.b.zext(u.in(17, 17), 34));
  const Netlist after = split_products(u.out(product), device(18));
  EXPECT_EQ(count(after, Op::kMul), 1u);
  EXPECT_EQ(count(after, Op::kAdd), 0u);
}

/// Additions that a product of two factors of 18 bits takes.
unsigned sums_of_18(bool first_signed, bool second_signed, unsigned unsigned_width) {
  Unit u(36);
  const auto wide = [&](unsigned low, bool is_signed) {
    const NodeId in = u.in(low, 18);
    return is_signed ? u.b.sext(in, 36) : u.b.zext(in, 36);
  };
  DelayModel delay = device(18);
  delay.unsigned_multiplier_width = unsigned_width;
  const NodeId product = u.b.mul(wide(0, first_signed), wide(18, second_signed));
  const Netlist before = u.out(product);
  const Netlist after = split_products(before, delay);
  expect_equal(before, after, 1, 500);
  return count(after, Op::kAdd);
}

TEST(SplitProducts, KnowsTheWidthOfUnsignedFactors) {
  EXPECT_EQ(sums_of_18(true, true, 18), 0u);
  EXPECT_EQ(sums_of_18(false, false, 18), 0u);
  EXPECT_GT(sums_of_18(false, false, 17), 0u);
  EXPECT_GT(sums_of_18(true, false, 18), 0u) << "a sign bit makes the second 19 bits wide";
  EXPECT_EQ(sums_of_18(true, false, 18), sums_of_18(false, true, 18));
}

TEST(SplitProducts, SplitsAWiderOne) {
  Unit u(64);
  const NodeId product = u.b.mul(u.b.sext(u.in(0, 32), 64), u.b.sext(u.in(32, 32), 64));
  const Netlist before = u.out(product);
  const Netlist after = split_products(before, device(18));
  EXPECT_EQ(count(after, Op::kMul), 4u) << to_text(before) << to_text(after);
  expect_equal(before, after, 1, 2000);
}

TEST(SplitProducts, MakesAdditionsOfAConstantOfFewDigits) {
  Unit u(12);
  const NodeId product = u.b.mul(u.b.zext(u.in(0, 12), 20), u.b.constant(20, 62));
  const Netlist before = u.out(product);
  const Netlist after = split_products(before, device(18));
  EXPECT_EQ(count(after, Op::kMul), 0u);
  EXPECT_EQ(count(after, Op::kAdd) + count(after, Op::kSub), 1u);
  expect_equal(before, after, 1, 500);
}

TEST(ExpandShifts, SharesTheLayersOfACountAndItsShift) {
  Unit u(20);
  const NodeId a = u.in(0, 20);
  const NodeId zeros = u.b.clz(u.b.concat({a, u.b.constant(1, 1)}), 5);
  const NodeId normal = u.b.shift(Op::kShl, a, zeros);
  const Netlist before = u.out(u.b.concat({normal, zeros}));
  const Netlist after = narrow(expand_shifts(before));
  EXPECT_EQ(count(after, Op::kClz) + count(after, Op::kShl), 0u);
  unsigned wide = 0;
  for (const Node& n : after.nodes) wide += n.op == Op::kMux && n.width >= 4 ? 1 : 0;
  EXPECT_EQ(wide, 5u);
  expect_equal(before, after, 1, 2000);
}

TEST(MergeAddSub, UndoesASelectedNegation) {
  const Netlist before = selected_negation();
  const Netlist after = merge_add_sub(before);
  EXPECT_EQ(count(after, Op::kAddSub), 1u);
  expect_equal(before, after, 1, 500);
}

TEST(MergeAddSub, LeavesANegationThatOthersLookAt) {
  Unit u(33);
  const NodeId b = u.in(16, 16);
  const NodeId negated = u.b.sub(u.b.constant(16, 0), b);
  const NodeId selected = u.b.mux(u.in(32, 1), negated, b);
  const Netlist before = u.out(u.b.concat({u.b.add(u.in(0, 16), selected), selected}));
  EXPECT_EQ(count(merge_add_sub(before), Op::kAddSub), 0u);
}

}  // namespace
}  // namespace hlsc
