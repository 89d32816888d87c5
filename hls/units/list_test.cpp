// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/list.h"

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<List<C>>;

void first(UnitBench& bench, unsigned packet, unsigned level, unsigned address) {
  bench.feed(bench.unit.job, ListJob<C>{PacketId<C>::from(packet), Level::from(level), true,
                                        Address::from(address)});
  bench.run();
}
void go_on(UnitBench& bench, unsigned packet, unsigned level) {
  bench.feed(bench.unit.job, ListJob<C>{PacketId<C>::from(packet), Level::from(level), false, {}});
  bench.run();
}
/// The entry read last was, or was not, the list's last: what the mailbox notes.
void note_last(UnitBench& bench, unsigned packet, unsigned level, bool last) {
  bench.rows(bench.unit.last)[level * 8 + packet] = last;
}
CacheRequest<ListContext<C>> request(unsigned packet, unsigned level, unsigned address) {
  return {{PacketId<C>::from(packet), Level::from(level)}, Address::from(address)};
}

TEST(List, ReadsAListUpToItsLastEntry) {
  UnitBench bench;
  note_last(bench, 2, 1, true);  // of the list before
  first(bench, 2, 1, 700);
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.request), request(2, 1, 700)));
  for (unsigned i = 1; i < 5; ++i) {
    note_last(bench, 2, 1, false);
    go_on(bench, 2, 1);
    EXPECT_TRUE(test::same(bench.take_one(bench.unit.request), request(2, 1, 700 + i)));
    EXPECT_TRUE(bench.take(bench.unit.finished).empty());
  }
  note_last(bench, 2, 1, true);
  go_on(bench, 2, 1);
  EXPECT_TRUE(bench.take(bench.unit.request).empty());
  TraversalEvent<C> pop;
  pop.packet = 2;
  pop.level = 1;
  pop.kind = TraversalKind::kPop;
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.finished), pop));
}

using WithPointers = test::Fast<C>;

TEST(List, WhereLeavesHaveNoNodesTheOtherChildFollows) {
  test::UnitBench<List<WithPointers>> bench;
  bench.rows(bench.unit.last)[8 + 2] = true;
  const auto after = [&](const AfterLeaf<WithPointers>& leaf) {
    bench.rows(bench.unit.after)[8 + 2] = leaf;
    bench.feed(bench.unit.job, {2, 1, false, {}});
    bench.run();
    return bench.take_one(bench.unit.finished);
  };
  const TraversalEvent<WithPointers> far = after({true, 2002, 0b0111, 0b0011});
  EXPECT_EQ(far.kind, TraversalKind::kDescend);
  EXPECT_TRUE(far.clip_near) << "from the plane on, as if the near child had been empty";
  EXPECT_EQ(far.next, Address(2002));
  EXPECT_EQ(far.active, RayMask<C>(0b0111));
  EXPECT_EQ(far.both, RayMask<C>(0b0011));
  EXPECT_EQ(after({}).kind, TraversalKind::kPop);
}

struct MainFirst : WithPointers {
  static constexpr bool kMainFirst = true;
};

TEST(List, FromTheMainObjectRaysGoOnToTheTreeOverTheOthers) {
  test::UnitBench<List<MainFirst>> bench;
  bench.value(bench.unit.frame).others_node = Word::from(4711);
  bench.rows(bench.unit.after)[2] = {true, 2002, 0b0111, 0b0011};
  const auto begin_list = [&](bool is_start) {
    bench.rows(bench.unit.last)[2] = false;
    bench.feed(bench.unit.job, {2, 0, true, 700, RayMask<C>(0b1011), is_start});
    bench.run();
    EXPECT_EQ(bench.take_one(bench.unit.request).context.active.get(), RayMask<C>(0b1011));
  };
  const auto end = [&] {
    bench.rows(bench.unit.last)[2] = true;
    bench.feed(bench.unit.job, {2, 0, false, {}});
    bench.run();
    return bench.take_one(bench.unit.finished);
  };
  begin_list(true);
  TraversalEvent<MainFirst> enter;
  enter.packet = 2;
  enter.kind = TraversalKind::kEnter;
  enter.next = 4711;
  enter.active = 0b1011;
  EXPECT_TRUE(test::same(end(), enter));
  begin_list(false);
  EXPECT_EQ(end().next, Address(2002)) << "from another list to the child beside it";
}

TEST(List, PacketsAndLevelsDoNotMeet) {
  struct Walk {
    unsigned address = 0, left = 0;
  };
  Walk walks[2][C::kPackets];
  UnitBench bench;
  test::Random random(12);
  unsigned finished = 0;
  for (unsigned n = 0; n < 100'000; ++n) {
    const unsigned packet = test::below(random, C::kPackets);
    const unsigned level = test::below(random, 2);
    Walk& walk = walks[level][packet];
    if (walk.left == 0) {
      walk = {test::below(random, 1u << kAddressBits), 1 + test::below(random, 6)};
      first(bench, packet, level, walk.address);
    } else {
      note_last(bench, packet, level, --walk.left == 0);
      go_on(bench, packet, level);
      walk.address = (walk.address + 1) % (1u << kAddressBits);
    }
    if (walk.left == 0) {
      ASSERT_TRUE(bench.take(bench.unit.request).empty());
      const TraversalEvent<C> pop = bench.take_one(bench.unit.finished);
      ASSERT_EQ(pop.packet, PacketId<C>::from(packet));
      ASSERT_EQ(pop.level, Level::from(level));
      ASSERT_EQ(pop.kind, TraversalKind::kPop);
      ++finished;
    } else {
      ASSERT_TRUE(bench.take(bench.unit.finished).empty());
      ASSERT_TRUE(
          test::same(bench.take_one(bench.unit.request), request(packet, level, walk.address)));
    }
  }
  EXPECT_GT(finished, 10'000u);
}

}  // namespace
}  // namespace dynrt
