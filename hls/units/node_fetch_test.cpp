// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/node_fetch.h"

#include <set>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<NodeFetch<C>>;
using Request = CacheRequest<StepContext<C>>;

TraversalEvent<C> event(TraversalKind kind, unsigned packet, unsigned level) {
  TraversalEvent<C> e;
  e.packet = PacketId<C>::from(packet);
  e.level = Level::from(level);
  e.kind = kind;
  return e;
}
TraversalEvent<C> enter(unsigned packet, unsigned level, unsigned node, unsigned active = 15) {
  TraversalEvent<C> e = event(TraversalKind::kEnter, packet, level);
  e.next = Address::from(node);
  e.active = RayMask<C>::from(active);
  return e;
}
TraversalEvent<C> push(unsigned packet, unsigned level, unsigned next, unsigned pushed,
                       unsigned pushed_active = 15, unsigned both = 15) {
  TraversalEvent<C> e = event(TraversalKind::kPush, packet, level);
  e.next = Address::from(next);
  e.active = 15;
  e.pushed = Address::from(pushed);
  e.pushed_active = RayMask<C>::from(pushed_active);
  e.both = RayMask<C>::from(both);
  return e;
}
TraversalEvent<C> pop(unsigned packet, unsigned level, unsigned terminated = 0) {
  TraversalEvent<C> e = event(TraversalKind::kPop, packet, level);
  e.terminated = RayMask<C>::from(terminated);
  return e;
}

Request step(UnitBench& bench, const TraversalEvent<C>& e) {
  bench.feed(bench.unit.event, e);
  bench.run();
  return bench.take_one(bench.unit.request);
}
void expect_quiet(UnitBench& bench) {
  EXPECT_TRUE(bench.take(bench.unit.request).empty());
  EXPECT_TRUE(bench.take(bench.unit.again).empty());
  EXPECT_TRUE(bench.take(bench.unit.top_done).empty());
  EXPECT_TRUE(bench.take(bench.unit.object_done).empty());
  EXPECT_TRUE(bench.take(bench.unit.dropped).empty());
}

TEST(NodeFetch, EntersAtTheNodeGivenWithFreshIntervals) {
  UnitBench bench;
  const Request r = step(bench, enter(3, 1, 4711, 0b0110));
  EXPECT_EQ(r.address, Address(4711));
  EXPECT_EQ(r.context.packet, PacketId<C>(3));
  EXPECT_EQ(r.context.level, Level(1));
  EXPECT_EQ(r.context.active, RayMask<C>(0b0110));
  EXPECT_EQ(r.context.update, IntervalUpdate::kInit);
  expect_quiet(bench);
}

TEST(NodeFetch, GoesOnInOneChildAndClipsTheEndThatWasPassed) {
  UnitBench bench;
  step(bench, enter(0, 0, 1));
  TraversalEvent<C> go = event(TraversalKind::kDescend, 0, 0);
  go.next = 5;
  go.active = 3;
  go.both = 2;
  Request r = step(bench, go);
  EXPECT_EQ(r.address, Address(5));
  EXPECT_EQ(r.context.active, RayMask<C>(3));
  EXPECT_EQ(r.context.both, RayMask<C>(2));
  EXPECT_EQ(r.context.update, IntervalUpdate::kClipFar);
  go.clip_near = true;
  r = step(bench, go);
  EXPECT_EQ(r.context.update, IntervalUpdate::kClipNear);
  expect_quiet(bench);
}

TEST(NodeFetch, PopsWhatWasPushedLastFirst) {
  UnitBench bench;
  step(bench, enter(2, 0, 1));
  for (unsigned i = 0; i < C::kStackDepth; ++i) {
    const Request r = step(bench, push(2, 0, 100 + i, 200 + i, 1 + i % 15, i % 16));
    EXPECT_EQ(r.address, Address::from(100 + i));
    EXPECT_EQ(r.context.update, IntervalUpdate::kClipFarPush);
    EXPECT_EQ(r.context.stack, StackPointer<C>::from(i)) << "the far stack's row to push to";
    EXPECT_EQ(r.context.both, RayMask<C>::from(i % 16));
  }
  for (unsigned i = C::kStackDepth; i-- > 0;) {
    const Request r = step(bench, pop(2, 0));
    EXPECT_EQ(r.address, Address::from(200 + i));
    EXPECT_EQ(r.context.update, IntervalUpdate::kPop);
    EXPECT_EQ(r.context.stack, StackPointer<C>::from(i)) << "the far stack's row to pop from";
    EXPECT_EQ(r.context.active, RayMask<C>::from(1 + i % 15));
    EXPECT_EQ(r.context.both, RayMask<C>::from(i % 16));
  }
  expect_quiet(bench);
  bench.feed(bench.unit.event, pop(2, 0));
  bench.run();
  EXPECT_EQ(bench.take_one(bench.unit.top_done).packet, PacketId<C>(2));
  expect_quiet(bench);
}

TEST(NodeFetch, AFullStackDropsThePushAndCountsIt) {
  UnitBench bench;
  step(bench, enter(1, 1, 1));
  for (unsigned i = 0; i < C::kStackDepth; ++i) step(bench, push(1, 1, 100, 200 + i));
  const Request r = step(bench, push(1, 1, 300, 400));
  EXPECT_EQ(r.address, Address(300)) << "the traversal goes on in the near child";
  EXPECT_EQ(r.context.update, IntervalUpdate::kClipFar) << "without pushing the far end";
  EXPECT_EQ(bench.take_one(bench.unit.dropped).packet, PacketId<C>(1));
  EXPECT_EQ(step(bench, pop(1, 1)).address, Address(200 + C::kStackDepth - 1));
  expect_quiet(bench);
}

TEST(NodeFetch, ALevelEndsWhenNoRayIsAlive) {
  UnitBench bench;
  step(bench, enter(4, 1, 1, 0b1011));
  step(bench, push(4, 1, 2, 3));
  step(bench, push(4, 1, 2, 4));
  EXPECT_EQ(step(bench, pop(4, 1, 0b0011)).context.active, RayMask<C>(0b1000))
      << "only living rays enter a popped node, and only those that entered the level";
  bench.feed(bench.unit.event, pop(4, 1, 0b1000));
  bench.run();
  const ListJob<C> job = bench.take_one(bench.unit.object_done);
  EXPECT_EQ(job.packet, PacketId<C>(4));
  EXPECT_EQ(job.level, Level{}) << "the list of the top level goes on";
  EXPECT_FALSE(job.first);
  expect_quiet(bench);
}

struct MainFirst : test::Fast<C> {
  static constexpr bool kMainFirst = true;
};

TEST(NodeFetch, WhereNoObjectsFollowTheMainOneTheLevelEnds) {
  test::UnitBench<NodeFetch<MainFirst>> bench;
  TraversalEvent<MainFirst> e;
  e.packet = 4;
  e.kind = TraversalKind::kEnter;
  e.active = 0b1011;
  bench.feed(bench.unit.event, e);
  bench.run();
  EXPECT_EQ(bench.take_one(bench.unit.top_done).packet, PacketId<C>(4));
  EXPECT_TRUE(bench.take(bench.unit.request).empty());
  e.next = 7;
  bench.feed(bench.unit.event, e);
  bench.run();
  EXPECT_EQ(bench.take_one(bench.unit.request).address, Address(7));
  EXPECT_TRUE(bench.take(bench.unit.top_done).empty());
}

TEST(NodeFetch, APoppedNodeThatNoLivingRayEntersIsPassedOver) {
  UnitBench bench;
  step(bench, enter(5, 0, 1));
  step(bench, push(5, 0, 2, 3, 0b0100));
  step(bench, push(5, 0, 2, 4, 0b0011));
  bench.feed(bench.unit.event, pop(5, 0, 0b0011));
  bench.run();
  const TraversalEvent<C> again = bench.take_one(bench.unit.again);
  EXPECT_TRUE(test::same(again, pop(5, 0)));
  expect_quiet(bench);
  EXPECT_EQ(step(bench, again).address, Address(3));
}

/// What the unit is to do, said once more in the plainest way.
template <class C>
class Reference {
 public:
  using Request = CacheRequest<StepContext<C>>;
  struct Answer {
    std::vector<Request> request;
    std::vector<TraversalEvent<C>> again;
    std::vector<ShadeJob<C>> top_done;
    std::vector<ListJob<C>> object_done;
    std::vector<DroppedPush<C>> dropped;
  };
  bool busy(unsigned packet, unsigned level) const { return states_[packet][level].busy; }

  Answer answer(const TraversalEvent<C>& e) {
    State& s = states_[e.packet.to_u64()][e.level.to_u64()];
    Answer a;
    if (e.kind == TraversalKind::kEnter) s = {true, e.active, {}};
    s.alive = s.alive & ~e.terminated;
    Request r{{e.packet, e.level, IntervalUpdate::kInit, e.both, e.active, {}}, e.next};
    r.context.stack = StackPointer<C>::from(s.stack.size());
    if (e.kind == TraversalKind::kPop) {
      s.busy = !s.stack.empty() && s.alive != RayMask<C>{};
      if (!s.busy && e.level == Level{}) a.top_done.push_back({3 * 4 - 1, e.packet});
      if (!s.busy && e.level != Level{}) a.object_done.push_back({e.packet, 0, false, {}});
      if (!s.busy) return a;
      const TraversalEvent<C> entry = s.stack.back();
      s.stack.pop_back();
      const RayMask<C> active = entry.pushed_active & s.alive;
      if (active == RayMask<C>{}) {
        a.again.push_back({});
        a.again[0].packet = e.packet;
        a.again[0].level = e.level;
        return a;
      }
      r.context.update = IntervalUpdate::kPop;
      r.context.stack = StackPointer<C>::from(s.stack.size());
      r.context.active = active;
      r.context.both = entry.both;
      r.address = entry.pushed;
    } else if (e.kind == TraversalKind::kPush && s.stack.size() < C::kStackDepth) {
      r.context.update = IntervalUpdate::kClipFarPush;
      s.stack.push_back(e);
    } else if (e.kind == TraversalKind::kPush) {
      r.context.update = IntervalUpdate::kClipFar;
      a.dropped.push_back({e.packet});
    } else if (e.kind == TraversalKind::kDescend) {
      r.context.update = e.clip_near ? IntervalUpdate::kClipNear : IntervalUpdate::kClipFar;
    }
    a.request.push_back(r);
    return a;
  }

 private:
  struct State {
    bool busy = false;
    RayMask<C> alive;
    std::vector<TraversalEvent<C>> stack;
  };
  State states_[C::kPackets][2];
};

template <class C>
void traverse_at_random() {
  test::UnitBench<NodeFetch<C>> bench;
  Reference<C> reference;
  test::Random random(20041);
  unsigned counts[5] = {};
  for (unsigned i = 0; i < 200'000; ++i) {
    const unsigned packet = test::below(random, C::kPackets);
    const unsigned level = test::below(random, 2);
    auto e = test::random_token<TraversalEvent<C>>(random);
    e.packet = PacketId<C>::from(packet);
    e.level = Level::from(level);
    const bool deep = packet < 2;  // packets that fill their stacks
    e.kind = test::chance(random, deep ? 80 : 50)   ? TraversalKind::kPush
             : test::chance(random, deep ? 20 : 70) ? TraversalKind::kPop
                                                    : TraversalKind::kDescend;
    if (deep || test::chance(random, 80)) e.terminated = 0;
    if (!reference.busy(packet, level)) {
      e.kind = TraversalKind::kEnter;
      e.terminated = 0;
    }
    const typename Reference<C>::Answer answer = reference.answer(e);
    bench.feed(bench.unit.event, e);
    bench.run();
    counts[0] += answer.request.size();
    counts[1] += answer.again.size();
    counts[2] += answer.top_done.size();
    counts[3] += answer.object_done.size();
    counts[4] += answer.dropped.size();
    ASSERT_TRUE(test::same(bench.take(bench.unit.request), answer.request)) << i;
    ASSERT_TRUE(test::same(bench.take(bench.unit.again), answer.again)) << i;
    ASSERT_TRUE(test::same(bench.take(bench.unit.top_done), answer.top_done)) << i;
    ASSERT_TRUE(test::same(bench.take(bench.unit.object_done), answer.object_done)) << i;
    ASSERT_TRUE(test::same(bench.take(bench.unit.dropped), answer.dropped)) << i;
  }
  for (const unsigned count : counts) EXPECT_GT(count, 100u) << "every answer is met often";
}

template <unsigned Depth>
struct Stacks : C {
  static constexpr unsigned kStackDepth = Depth;
};

TEST(NodeFetch, AgreesWithAPlainReferenceOnRandomTraversals) {
  traverse_at_random<C>();
  traverse_at_random<Stacks<13>>();
  traverse_at_random<Stacks<1>>();
}

/// Whether no two entries have the same row; of how many rows a packet.
template <class C>
unsigned rows_of_apart_entries() {
  std::set<std::uint64_t> rows;
  std::size_t entries = 0;
  for (unsigned packet = 0; packet < C::kPackets; ++packet) {
    for (unsigned level = 0; level < 2; ++level) {
      for (unsigned i = 0; i < C::kStackDepth; ++i, ++entries) {
        const auto row =
            stack_row<C>(Level::from(level), PacketId<C>::from(packet), StackPointer<C>::from(i));
        rows.insert(row.to_u64());
      }
    }
  }
  EXPECT_EQ(rows.size(), entries);
  EXPECT_LT(*rows.rbegin(), kStackRows<C>);
  return kStackRows<C> / C::kPackets;
}

TEST(NodeFetch, StacksTakeTheRowsThatTheirDepthsAskFor) {
  EXPECT_EQ(rows_of_apart_entries<Stacks<31>>(), 64u);
  EXPECT_EQ(rows_of_apart_entries<Stacks<63>>(), 128u);
  EXPECT_EQ(rows_of_apart_entries<Stacks<9>>(), 32u);
  EXPECT_EQ(rows_of_apart_entries<Stacks<8>>(), 16u);
  EXPECT_EQ(rows_of_apart_entries<Stacks<1>>(), 2u);
}

struct Mirrors : test::Config<8> {
  static constexpr unsigned kReflections = 1;
};
template <Crossing K>
struct Crosses : Mirrors {
  static constexpr Crossing kCrossing = K;
};

using Split = Crosses<Crossing::kSplit>;

TEST(NodeFetch, ASplitPacketEntersOnceForEachGroupOfSigns) {
  test::UnitBench<NodeFetch<Split>> bench;
  const LevelRow<Split> row = level_row<Split>(Level(1), PacketId<Split>(6));
  const unsigned signs[kRays<C>] = {0b101, 0b001, 0b101, 0b001};
  for (unsigned i = 0; i < kRays<C>; ++i) {
    bench.rows(bench.unit.signs[i])[row.to_u64()] = DirectionSigns::from(signs[i]);
  }
  TraversalEvent<Split> e;
  e.packet = 6;
  e.level = 1;
  e.kind = TraversalKind::kEnter;
  e.next = 77;
  e.active = 0b1110;
  e.distinct_origins = true;
  const auto next = [&](const TraversalEvent<Split>& event) {
    bench.feed(bench.unit.event, event);
    bench.run();
  };
  next(e);
  EXPECT_EQ(bench.take_one(bench.unit.request).context.active, RayMask<C>(0b1010))
      << "ray 1 is the lowest, and ray 3 has its signs";

  TraversalEvent<Split> done;
  done.packet = 6;
  done.level = 1;
  next(done);
  const TraversalEvent<Split> second = bench.take_one(bench.unit.again);
  EXPECT_TRUE(bench.take(bench.unit.object_done).empty()) << "ray 2 is still to come";
  next(second);
  const auto request = bench.take_one(bench.unit.request);
  EXPECT_EQ(request.address, Address(77)) << "from the root";
  EXPECT_EQ(request.context.active, RayMask<C>(0b0100));
  EXPECT_EQ(request.context.update, IntervalUpdate::kInit);
  next(done);
  EXPECT_EQ(bench.take_one(bench.unit.object_done).packet, PacketId<Split>(6));
  EXPECT_TRUE(bench.take(bench.unit.again).empty());
}

TEST(NodeFetch, APacketOfOneOriginIsNotSplit) {
  test::UnitBench<NodeFetch<Split>> bench;
  bench.rows(bench.unit.signs[2])[0] = 0b111;
  TraversalEvent<Split> e;
  e.kind = TraversalKind::kEnter;
  e.next = 5;
  e.active = 0b1111;
  bench.feed(bench.unit.event, e);
  bench.run();
  EXPECT_EQ(bench.take_one(bench.unit.request).context.active, RayMask<C>(0b1111));
}

TEST(NodeFetch, ARayThatCrossedOthersEndsNoMoreInItsLevel) {
  using Remember = Crosses<Crossing::kRemember>;
  test::UnitBench<NodeFetch<Remember>> bench;
  const auto send = [&](TraversalKind kind, unsigned crossing, unsigned terminated) {
    TraversalEvent<Remember> e;
    e.kind = kind;
    e.next = 2;
    e.active = 15;
    e.pushed = 3;
    e.pushed_active = 15;
    e.both = RayMask<C>::from(15 & ~crossing);
    e.crossing = RayMask<C>::from(crossing);
    e.terminated = RayMask<C>::from(terminated);
    bench.feed(bench.unit.event, e);
    bench.run();
    return bench.take_one(bench.unit.request).context;
  };
  send(TraversalKind::kEnter, 0, 0);
  send(TraversalKind::kPush, 0b0010, 0);
  const auto popped = send(TraversalKind::kPop, 0, 0b0011);
  EXPECT_EQ(popped.active, RayMask<C>(0b1110))
      << "ray 0 has ended, ray 1 has to see the other child";
  EXPECT_EQ(popped.crossing.get(), RayMask<C>(0b0010));
  EXPECT_EQ(popped.both, RayMask<C>(0b1101));
  send(TraversalKind::kEnter, 0, 0);
  send(TraversalKind::kPush, 0, 0);
  EXPECT_EQ(send(TraversalKind::kPop, 0, 0b0010).active, RayMask<C>(0b1101))
      << "new rays, new mask";
}

}  // namespace
}  // namespace dynrt
