// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/packet_decision.h"

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<>;
using UnitBench = test::UnitBench<PacketDecision<C>>;
using Decisions = std::array<SliceDecision, kRays<C>>;

void feed(UnitBench& bench, const Step<C>& step, const Decisions& decisions) {
  bench.feed(bench.unit.step_in, step);
  for (unsigned i = 0; i < kRays<C>; ++i) bench.feed(bench.unit.slice[i], decisions[i]);
  bench.run();
}

Step<C> inner_node(unsigned active = 15) {
  Step<C> s;
  s.context.packet = 9;
  s.context.level = 1;
  s.context.active = RayMask<C>::from(active);
  s.node = {NodeKind::kSplitY, {}, 1001, 2002};
  return s;
}
/// Every ray alike.
Decisions all(SliceDecision d) { return {d, d, d, d}; }

TraversalEvent<C> decide(const Step<C>& step, const Decisions& decisions) {
  UnitBench bench;
  feed(bench, step, decisions);
  EXPECT_TRUE(bench.take(bench.unit.leaf).empty());
  const TraversalEvent<C> e = bench.take_one(bench.unit.event);
  EXPECT_EQ(e.packet, step.context.packet);
  EXPECT_EQ(e.level, step.context.level);
  return e;
}

TEST(PacketDecision, GoesIntoTheOnlyChildThatIsEntered) {
  for (const bool left_first : {false, true}) {
    for (const bool left : {false, true}) {
      const TraversalEvent<C> e = decide(inner_node(), all({left_first, left, !left, false}));
      EXPECT_EQ(e.kind, TraversalKind::kDescend);
      EXPECT_EQ(e.next, left ? Address(1001) : Address(2002));
      EXPECT_EQ(e.active, RayMask<C>(15));
      EXPECT_EQ(e.both, RayMask<C>(0));
    }
  }
}

TEST(PacketDecision, PushesTheFarChildWhereBothAreEntered) {
  for (const bool left_first : {false, true}) {
    const TraversalEvent<C> e = decide(inner_node(0b0111), all({left_first, true, true, false}));
    EXPECT_EQ(e.kind, TraversalKind::kPush);
    EXPECT_EQ(e.next, left_first ? Address(1001) : Address(2002));
    EXPECT_EQ(e.pushed, left_first ? Address(2002) : Address(1001));
    EXPECT_EQ(e.active, RayMask<C>(0b0111));
    EXPECT_EQ(e.pushed_active, RayMask<C>(0b0111));
    EXPECT_EQ(e.both, RayMask<C>(0b0111));
  }
}

TEST(PacketDecision, RaysMayPart) {
  // Figure 3.7: rays 0 and 1 enter both children from the left, ray 2 the right one only; ray 3 has
  // left the packet and its decision must not matter.
  const Decisions decisions{{{true, true, true, false},
                             {true, true, true, false},
                             {true, false, true, false},
                             {false, true, false, false}}};
  const TraversalEvent<C> e = decide(inner_node(0b0111), decisions);
  EXPECT_EQ(e.kind, TraversalKind::kPush);
  EXPECT_EQ(e.next, Address(1001));
  EXPECT_EQ(e.active, RayMask<C>(0b0011));
  EXPECT_EQ(e.pushed, Address(2002));
  EXPECT_EQ(e.pushed_active, RayMask<C>(0b0111));
  EXPECT_EQ(e.both, RayMask<C>(0b0011));
}

TEST(PacketDecision, AnEmptyChildIsNeverEntered) {
  for (const bool left_first : {false, true}) {
    Step<C> s = inner_node();
    s.node.left = 0;
    const TraversalEvent<C> right = decide(s, all({left_first, true, true, false}));
    EXPECT_EQ(right.kind, TraversalKind::kDescend);
    EXPECT_EQ(right.next, Address(2002));
    EXPECT_EQ(right.both, RayMask<C>(15)) << "the rays' intervals are clipped at the plane";
    EXPECT_EQ(right.clip_near, left_first) << "at the end that the empty child had";
    EXPECT_EQ(decide(s, all({left_first, true, false, false})).kind, TraversalKind::kPop);
    s.node.right = 0;
    EXPECT_EQ(decide(s, all({left_first, true, true, false})).kind, TraversalKind::kPop);
  }
}

TEST(PacketDecision, TerminatedRaysEnterNothing) {
  Decisions decisions = all({true, true, true, false});
  decisions[0].terminated = true;
  decisions[3].terminated = true;
  TraversalEvent<C> e = decide(inner_node(0b0111), decisions);
  EXPECT_EQ(e.active, RayMask<C>(0b0110));
  EXPECT_EQ(e.terminated, RayMask<C>(0b0001)) << "of the active rays";
  e = decide(inner_node(0b1001), decisions);
  EXPECT_EQ(e.kind, TraversalKind::kPop);
  EXPECT_EQ(e.terminated, RayMask<C>(0b1001));
}

TEST(PacketDecision, ALeafGoesToTheListUnlessAllItsRaysHaveTerminated) {
  Step<C> s = inner_node(0b0101);
  s.node.kind = NodeKind::kLeaf;
  Decisions decisions = all({});
  decisions[0].terminated = true;
  UnitBench bench;
  feed(bench, s, decisions);
  EXPECT_TRUE(bench.take(bench.unit.event).empty());
  const ListJob<C> expected{9, 1, true, 1001};
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.leaf), expected));
  decisions[2].terminated = true;
  const TraversalEvent<C> e = decide(s, decisions);
  EXPECT_EQ(e.kind, TraversalKind::kPop);
  EXPECT_EQ(e.terminated, RayMask<C>(0b0101));
}

using WithPointers = test::Fast<C>;
constexpr unsigned kMark = 1u << (C::kAddressBits - 1);  // of a pointer to a list

/// An inner node whose children are leaves if asked, every ray alike.
test::UnitBench<PacketDecision<WithPointers>> decide_between(unsigned left, unsigned right,
                                                             SliceDecision d) {
  test::UnitBench<PacketDecision<WithPointers>> bench;
  Step<WithPointers> s;
  s.context.packet = 9;
  s.context.level = 1;
  s.context.active = RayMask<C>(0b0111);
  s.node = {NodeKind::kSplitY, {}, Address::from(left), Address::from(right)};
  bench.feed(bench.unit.step_in, s);
  for (unsigned i = 0; i < kRays<C>; ++i) bench.feed(bench.unit.slice[i], d);
  bench.run();
  return bench;
}
constexpr unsigned kRow = 32 + 9;  // level 1, packet 9

TEST(PacketDecision, ALeafThatItsParentKnowsIsReadAtOnceAndTheOtherChildWaits) {
  for (const bool left_first : {false, true}) {
    const unsigned list = kMark | 350;
    auto bench = left_first ? decide_between(list, 2002, {left_first, true, true, false})
                            : decide_between(2002, list, {left_first, true, true, false});
    EXPECT_TRUE(bench.take(bench.unit.event).empty());
    const ListJob<WithPointers> job = bench.take_one(bench.unit.leaf);
    EXPECT_TRUE(job.first);
    EXPECT_EQ(job.address, Address(700)) << "lists begin at even addresses";
    const AfterLeaf<WithPointers> after = bench.rows(bench.unit.after)[kRow];
    EXPECT_TRUE(test::same(after, {true, 2002, 0b0111, 0b0111}));
  }
}

TEST(PacketDecision, AfterTheOnlyChildThatIsEnteredThePacketPops) {
  auto bench = decide_between(kMark | 350, 2002, {true, true, false, false});
  EXPECT_EQ(bench.take_one(bench.unit.leaf).address, Address(700));
  EXPECT_FALSE(bench.rows(bench.unit.after)[kRow].other_child);
}

TEST(PacketDecision, AFarLeafGoesToTheStack) {
  auto bench = decide_between(1001, kMark | 350, {true, true, true, false});
  EXPECT_TRUE(bench.take(bench.unit.leaf).empty());
  const TraversalEvent<WithPointers> e = bench.take_one(bench.unit.event);
  EXPECT_EQ(e.kind, TraversalKind::kPush);
  EXPECT_EQ(e.pushed, Address(kMark | 350));
}

/// Ray by ray, without masks.
struct Reference {
  bool leaf = false;
  TraversalKind kind = TraversalKind::kPop;
  Address next, pushed;
  bool clip_near = false;
  bool active[kRays<C>] = {}, pushed_active[kRays<C>] = {}, both[kRays<C>] = {},
       terminated[kRays<C>] = {};

  Reference(const Step<C>& s, const Decisions& d) {
    bool alive[kRays<C>], any = false, decided = false, left_first = false;
    for (unsigned i = 0; i < kRays<C>; ++i) {
      terminated[i] = s.context.active.bit(i) && d[i].terminated;
      alive[i] = s.context.active.bit(i) && !d[i].terminated;
      both[i] = alive[i] && d[i].go_left && d[i].go_right;
      any = any || alive[i];
      if (both[i] && !decided) left_first = d[i].left_first, decided = true;
    }
    for (unsigned i = 0; i < kRays<C>; ++i) {
      if (alive[i] && !decided) left_first = d[i].left_first, decided = true;
    }
    leaf = s.node.kind == NodeKind::kLeaf && any;
    bool enter_left = false, enter_right = false;
    for (unsigned i = 0; i < kRays<C>; ++i) {
      enter_left = enter_left || (alive[i] && d[i].go_left);
      enter_right = enter_right || (alive[i] && d[i].go_right);
    }
    enter_left = enter_left && s.node.left.to_u64() != 0;
    enter_right = enter_right && s.node.right.to_u64() != 0;
    if (s.node.kind == NodeKind::kLeaf || !(enter_left || enter_right)) return;
    kind = enter_left && enter_right ? TraversalKind::kPush : TraversalKind::kDescend;
    const bool go_left = enter_left && (left_first || !enter_right);
    clip_near = go_left != left_first;
    next = go_left ? s.node.left : s.node.right;
    pushed = go_left ? s.node.right : s.node.left;
    for (unsigned i = 0; i < kRays<C>; ++i) {
      active[i] = alive[i] && (go_left ? d[i].go_left : d[i].go_right);
      pushed_active[i] = alive[i] && (go_left ? d[i].go_right : d[i].go_left);
    }
  }
};

RayMask<C> mask(const bool (&bits)[kRays<C>]) {
  return RayMask<C>::from(bits[0] + 2u * bits[1] + 4u * bits[2] + 8u * bits[3]);
}

TEST(PacketDecision, AgreesWithAPlainReferenceOnRandomDecisions) {
  UnitBench bench;
  test::Random random(31);
  unsigned kinds[4] = {}, leaves = 0;
  for (unsigned n = 0; n < 300'000; ++n) {
    auto s = test::random_token<Step<C>>(random);
    if (test::chance(random, 20)) s.node.left = 0;
    if (test::chance(random, 20)) s.node.right = 0;
    Decisions d;
    for (SliceDecision& decision : d) {
      decision = test::random_token<SliceDecision>(random);
      if (test::chance(random, 70)) decision.terminated = false;
    }
    feed(bench, s, d);
    const Reference expected(s, d);
    const auto leaf = bench.take(bench.unit.leaf);
    const auto events = bench.take(bench.unit.event);
    ASSERT_EQ(leaf.size() + events.size(), 1u);
    ASSERT_EQ(leaf.size(), expected.leaf ? 1u : 0u);
    if (expected.leaf) {
      ++leaves;
      continue;
    }
    const TraversalEvent<C>& e = events.front();
    ++kinds[static_cast<unsigned>(e.kind)];
    ASSERT_EQ(e.kind, expected.kind);
    ASSERT_EQ(e.terminated, mask(expected.terminated));
    if (e.kind == TraversalKind::kPop) continue;
    ASSERT_EQ(e.next, expected.next);
    ASSERT_EQ(e.active, mask(expected.active));
    ASSERT_EQ(e.both, mask(expected.both));
    if (e.kind == TraversalKind::kDescend) ASSERT_EQ(e.clip_near, expected.clip_near);
    if (e.kind != TraversalKind::kPush) continue;
    ASSERT_EQ(e.pushed, expected.pushed);
    ASSERT_EQ(e.pushed_active, mask(expected.pushed_active));
  }
  EXPECT_EQ(kinds[static_cast<unsigned>(TraversalKind::kEnter)], 0u);
  EXPECT_GT(kinds[static_cast<unsigned>(TraversalKind::kDescend)], 10'000u);
  EXPECT_GT(kinds[static_cast<unsigned>(TraversalKind::kPush)], 10'000u);
  EXPECT_GT(kinds[static_cast<unsigned>(TraversalKind::kPop)], 10'000u);
  EXPECT_GT(leaves, 10'000u);
}

struct Remembers : test::Config<8> {
  static constexpr unsigned kReflections = 1;
  static constexpr Crossing kCrossing = Crossing::kRemember;
};

TEST(PacketDecision, TellsTheRaysThatCrossTheFirstOfThoseThatEnterBoth) {
  test::UnitBench<PacketDecision<Remembers>> bench;
  Step<Remembers> s;
  s.context.active = 15;
  s.node.kind = NodeKind::kSplitY;
  s.node.left = 10;
  s.node.right = 20;
  bench.feed(bench.unit.step_in, s);
  // Ray 0 enters one child only; of the others ray 2 comes from the other side.
  const bool left_first[kRays<C>] = {false, true, false, true};
  for (unsigned i = 0; i < kRays<C>; ++i) {
    SliceDecision d;
    d.left_first = left_first[i];
    d.go_left = true;
    d.go_right = i != 0;
    bench.feed(bench.unit.slice[i], d);
  }
  bench.run();
  const auto e = bench.take_one(bench.unit.event);
  EXPECT_EQ(e.kind, TraversalKind::kPush);
  EXPECT_EQ(e.next, Address(10)) << "the order of ray 1";
  EXPECT_EQ(e.active, RayMask<C>(0b1111));
  EXPECT_EQ(e.pushed_active, RayMask<C>(0b1110));
  EXPECT_EQ(e.both, RayMask<C>(0b1010));
  EXPECT_EQ(e.crossing.get(), RayMask<C>(0b0100));
}

}  // namespace
}  // namespace dynrt
