// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/mailbox.h"

#include <set>
#include <type_traits>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<Mailbox<C>>;
constexpr unsigned kSlots = C::kObjectSlots;  ///< of triangles too

MailboxEntry<C> entry(unsigned packet, unsigned level, unsigned matrix, bool last = false) {
  MailboxEntry<C> e;
  e.packet = PacketId<C>::from(packet);
  e.level = Level::from(level);
  e.entry.matrix = MatrixIndex::from(matrix);
  e.entry.last = last;
  return e;
}
/// Rays that are traced; another set for every packet.
RayMask<C> traced(PacketId<C> packet) { return RayMask<C>::from(7 + packet.to_u64()); }
MailboxEntry<C> new_rays(unsigned packet) {
  MailboxEntry<C> e;
  e.packet = PacketId<C>::from(packet);
  e.active = traced(e.packet);
  e.clear = true;
  return e;
}
/// Whether the mailbox lets the entry through; if not, it sends the packet back to the list.
bool fresh(UnitBench& bench, const MailboxEntry<C>& e) {
  bench.feed(bench.unit.entry, e);
  bench.run();
  const auto jobs = bench.take(bench.unit.fresh);
  const auto seen = bench.take(bench.unit.seen);
  EXPECT_EQ(jobs.size() + seen.size(), 1u);
  EXPECT_TRUE(bench.take(bench.unit.start).empty());
  for (const TransformJob<C>& job : jobs) {
    const TransformKind kind = e.level == Level{} ? TransformKind::kObject  //
                                                  : TransformKind::kTriangle;
    EXPECT_TRUE(
        test::same(job, TransformJob<C>{3, e.packet, kind, traced(e.packet), e.entry.matrix}));
  }
  for (const ListJob<C>& job : seen) {
    EXPECT_TRUE(test::same(job, ListJob<C>{e.packet, e.level, false, {}}));
  }
  EXPECT_EQ(bench.rows(bench.unit.last)[level_row<C>(e.level, e.packet).to_u64()], e.entry.last);
  return !jobs.empty();
}
void clear(UnitBench& bench, unsigned packet) {
  bench.feed(bench.unit.entry, new_rays(packet));
  bench.run();
  EXPECT_TRUE(bench.take(bench.unit.fresh).empty());
  EXPECT_TRUE(bench.take(bench.unit.seen).empty());
  bench.take_one(bench.unit.start);
}

TEST(Mailbox, LetsEachMatrixThroughOnce) {
  for (const unsigned level : {0, 1}) {
    UnitBench bench;
    clear(bench, 4);
    for (unsigned round = 0; round < 3; ++round) {
      for (unsigned i = 0; i < kSlots; ++i) {
        EXPECT_EQ(fresh(bench, entry(4, level, 100 + i, i % 2 == 1)), round == 0) << i;
      }
    }
  }
}

TEST(Mailbox, MatrixZeroIsNotInAnEmptyMailbox) {
  UnitBench bench;
  clear(bench, 0);
  EXPECT_TRUE(fresh(bench, entry(0, 1, 0)));
  EXPECT_FALSE(fresh(bench, entry(0, 1, 0)));
}

TEST(Mailbox, AFullOneLetsEverythingNewThrough) {
  for (const unsigned level : {0, 1}) {
    UnitBench bench;
    clear(bench, 1);
    for (unsigned i = 0; i < kSlots; ++i) fresh(bench, entry(1, level, 100 + i));
    EXPECT_TRUE(fresh(bench, entry(1, level, 300)));
    EXPECT_TRUE(fresh(bench, entry(1, level, 300))) << "again and again";
    for (unsigned i = 0; i < kSlots; ++i) {
      EXPECT_FALSE(fresh(bench, entry(1, level, 100 + i))) << "slots are never replaced";
    }
  }
}

TEST(Mailbox, ANewRayForgetsTheObjectsAndStartsTheTraversal) {
  UnitBench bench;
  bench.value(bench.unit.frame).start_node = 4242;
  clear(bench, 5);
  clear(bench, 6);
  EXPECT_TRUE(fresh(bench, entry(5, 0, 1)));
  EXPECT_TRUE(fresh(bench, entry(6, 0, 1)));
  bench.feed(bench.unit.entry, new_rays(5));
  bench.run();
  TraversalEvent<C> start;
  start.packet = 5;
  start.level = 0;
  start.kind = TraversalKind::kEnter;
  start.next = 4242;
  start.active = traced(start.packet);
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.start), start));
  EXPECT_TRUE(bench.take(bench.unit.fresh).empty());
  EXPECT_TRUE(bench.take(bench.unit.seen).empty());
  EXPECT_TRUE(fresh(bench, entry(5, 0, 1)));
  EXPECT_FALSE(fresh(bench, entry(6, 0, 1))) << "of this packet alone";
}

TEST(Mailbox, ANewObjectForgetsTheTriangles) {
  UnitBench bench;
  clear(bench, 2);
  EXPECT_TRUE(fresh(bench, entry(2, 0, 1)));
  EXPECT_TRUE(fresh(bench, entry(2, 1, 50)));
  EXPECT_FALSE(fresh(bench, entry(2, 0, 1))) << "an object seen before is not entered";
  EXPECT_FALSE(fresh(bench, entry(2, 1, 50)));
  EXPECT_TRUE(fresh(bench, entry(2, 0, 2)));
  EXPECT_TRUE(fresh(bench, entry(2, 1, 50)));
}

TEST(Mailbox, AgreesWithSetsOnRandomEntries) {
  struct Seen {
    std::set<unsigned> objects, triangles;
  };
  Seen seen[C::kPackets];
  UnitBench bench;
  test::Random random(612);
  unsigned known = 0, full = 0;
  for (unsigned n = 0; n < 100'000; ++n) {
    const unsigned packet = test::below(random, C::kPackets);
    if (n < C::kPackets || test::chance(random, 2)) {
      clear(bench, n < C::kPackets ? n : packet);
      seen[n < C::kPackets ? n : packet].objects.clear();
      continue;
    }
    const unsigned level = test::chance(random, 90);
    const unsigned matrix = test::below(random, 16);
    Seen& s = seen[packet];
    if (level == 1 && s.objects.empty()) continue;  // triangles come after their object
    std::set<unsigned>& of_level = level == 0 ? s.objects : s.triangles;
    const bool expected = !of_level.contains(matrix);
    ASSERT_EQ(fresh(bench, entry(packet, level, matrix, test::chance(random, 30))), expected) << n;
    known += !expected;
    full += expected && of_level.size() == kSlots;
    if (expected && of_level.size() < kSlots) of_level.insert(matrix);
    if (expected && level == 0) s.triangles.clear();
  }
  EXPECT_GT(known, 10'000u);
  EXPECT_GT(full, 1'000u);
}

/// How many of `count` entries that are the same the mailbox lets through.
template <class Config>
unsigned let_through(unsigned level, unsigned count) {
  test::UnitBench<Mailbox<Config>> bench;
  MailboxEntry<Config> begin;
  begin.clear = true;
  bench.feed(bench.unit.entry, begin);
  MailboxEntry<Config> object;
  bench.feed(bench.unit.entry, object);
  bench.run();
  bench.take(bench.unit.fresh);
  MailboxEntry<Config> same;
  same.level = Level::from(level);
  same.entry.matrix = 7;
  for (unsigned i = 0; i < count; ++i) bench.feed(bench.unit.entry, same);
  bench.run();
  return static_cast<unsigned>(bench.take(bench.unit.fresh).size());
}
template <class Config>
constexpr bool kHasObjectRam = !std::is_same_v<decltype(Mailbox<Config>::objects), hls::Absent>;
template <class Config>
constexpr bool kHasTriangleRam = !std::is_same_v<decltype(Mailbox<Config>::triangles), hls::Absent>;

struct NoObjects : C {
  static constexpr unsigned kObjectSlots = 0;
};
struct NoTriangles : C {
  static constexpr unsigned kTriangleSlots = 0;
};

TEST(Mailbox, ALevelWithoutSlotsHasNoMemoryAndLetsEverythingThrough) {
  EXPECT_EQ(let_through<C>(0, 5), 1u);
  EXPECT_EQ(let_through<C>(1, 5), 1u);
  EXPECT_EQ(let_through<NoObjects>(0, 5), 5u);
  EXPECT_EQ(let_through<NoObjects>(1, 5), 1u);
  EXPECT_EQ(let_through<NoTriangles>(0, 5), 1u);
  EXPECT_EQ(let_through<NoTriangles>(1, 5), 5u);
  static_assert(kHasObjectRam<C> && kHasTriangleRam<C>);
  static_assert(!kHasObjectRam<NoObjects> && kHasTriangleRam<NoObjects>);
  static_assert(kHasObjectRam<NoTriangles> && !kHasTriangleRam<NoTriangles>);
}

template <class Config>
TransformJob<Config> job_of(const MailboxEntry<Config>& e) {
  test::UnitBench<Mailbox<Config>> bench;
  bench.feed(bench.unit.entry, e);
  bench.run();
  return bench.take_one(bench.unit.fresh);
}

struct Everything : C {
  static constexpr TriangleMatrix kTriangleMatrix = TriangleMatrix::kMemoryEfficient;
  static constexpr Primitives kPrimitives{.triangle = true, .sphere = true, .rectangle = true};
};

TEST(Mailbox, TellsWhichPrimitiveAndOfHowManyColumns) {
  for (const auto& [primitive, columns] : {std::pair{Primitive::kTriangle, 3u},
                                           {Primitive::kSphere, 4u},
                                           {Primitive::kRectangle, 3u}}) {
    MailboxEntry<Everything> e;
    e.level = 1;
    e.entry.set_primitive(primitive);
    const TransformJob<Everything> job = job_of(e);
    EXPECT_EQ(job.extras.primitive.get(), primitive);
    EXPECT_EQ(job.repeat, RepeatCount<C>::from(columns - 1));
  }
  EXPECT_EQ(job_of(MailboxEntry<Everything>{}).repeat, RepeatCount<C>(3)) << "an object has four";
}

}  // namespace
}  // namespace dynrt
