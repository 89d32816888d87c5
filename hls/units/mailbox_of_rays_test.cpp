// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/mailbox_of_rays.h"

#include <map>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Fast<test::Config<8>>;
using Rays = RayMask<C>;

template <class Config>
MailboxEntry<Config> entry(unsigned level, unsigned matrix, unsigned active, unsigned packet = 0) {
  MailboxEntry<Config> e;
  e.packet = PacketId<Config>::from(packet);
  e.level = Level::from(level);
  e.entry.matrix = MatrixIndex::from(matrix);
  e.active = RayMask<Config>::from(active);
  return e;
}

/// A mailbox, with new rays in every packet.
template <class Config>
class Bench : public test::UnitBench<MailboxOfRays<Config>> {
 public:
  Bench() {
    for (unsigned packet = 0; packet < Config::kPackets; ++packet) clear(packet);
  }
  void clear(unsigned packet = 0) {
    MailboxEntry<Config> e = entry<Config>(0, 0, 0b1111, packet);
    e.clear = true;
    this->feed(this->unit.entry, e);
    this->run();
    EXPECT_EQ(this->take_one(this->unit.start).active, RayMask<Config>(0b1111));
  }
  /// Of the active rays, those that are let through to the item.
  unsigned meet(unsigned level, unsigned matrix, unsigned active, unsigned packet = 0) {
    const MailboxEntry<Config> e = entry<Config>(level, matrix, active, packet);
    this->feed(this->unit.entry, e);
    this->run();
    const auto jobs = this->take(this->unit.fresh);
    std::size_t tokens = jobs.size();
    if constexpr (MailboxOfRays<Config>::kAnswersLists) {
      tokens += this->take(this->unit.seen).size();
    }
    EXPECT_EQ(tokens, 1u);
    if (!jobs.empty()) EXPECT_EQ(jobs[0].matrix, MatrixIndex::from(matrix));
    return jobs.empty() ? 0 : static_cast<unsigned>(jobs[0].active.to_u64());
  }
};

TEST(MailboxOfRays, LetsEachRayThroughOnce) {
  Bench<C> bench;
  for (const unsigned level : {0u, 1u}) {
    EXPECT_EQ(bench.meet(level, 7, 0b0011), 0b0011u);
    EXPECT_EQ(bench.meet(level, 9, 0b1000), 0b1000u);
    EXPECT_EQ(bench.meet(level, 7, 0b0110), 0b0100u);
    EXPECT_EQ(bench.meet(level, 7, 0b0111), 0u) << "all have met it";
    EXPECT_EQ(bench.meet(level, 7, 0b1111), 0b1000u);
    EXPECT_EQ(bench.meet(level, 9, 0b1001), 0b0001u);
  }
}

TEST(MailboxOfRays, ForgetsWithNewRaysAndTrianglesWithAnObject) {
  Bench<C> bench;
  EXPECT_EQ(bench.meet(0, 7, 0b0011), 0b0011u);
  EXPECT_EQ(bench.meet(1, 5, 0b0011), 0b0011u);
  EXPECT_EQ(bench.meet(0, 7, 0b1100), 0b1100u) << "others enter the object";
  EXPECT_EQ(bench.meet(1, 5, 0b0011), 0b0011u);
  bench.clear();
  EXPECT_EQ(bench.meet(0, 7, 0b0011), 0b0011u);
}

/// Slots for fewer objects than triangles.
struct Uneven : C {
  static constexpr unsigned kObjectSlots = 2;
  static constexpr unsigned kTriangleSlots = 5;
};

TEST(MailboxOfRays, AFullMailboxLetsEveryRayThrough) {
  for (const unsigned level : {0u, 1u}) {
    Bench<Uneven> bench;
    const unsigned slots = level == 0 ? Uneven::kObjectSlots : Uneven::kTriangleSlots;
    for (unsigned i = 0; i < slots; ++i) {
      EXPECT_EQ(bench.meet(level, 100 + i, 0b0001), 0b0001u);
    }
    for (unsigned round = 0; round < 2; ++round) EXPECT_EQ(bench.meet(level, 50, 0b1111), 0b1111u);
    EXPECT_EQ(bench.meet(level, 100, 0b0011), 0b0010u) << "what is in a slot stays there";
  }
}

/// What each packet has met, without slots.
struct Met {
  std::map<unsigned, unsigned> objects, triangles;  ///< rays by matrix
};

TEST(MailboxOfRays, AgreesWithMapsOnRandomEntries) {
  Met met[Uneven::kPackets];
  Bench<Uneven> bench;
  test::Random random(613);
  unsigned known = 0, full = 0;
  for (unsigned n = 0; n < 100'000; ++n) {
    const unsigned packet = test::below(random, Uneven::kPackets);
    Met& m = met[packet];
    if (test::chance(random, 2)) {
      bench.clear(packet);
      m = {};
      continue;
    }
    const unsigned level = m.objects.empty() ? 0 : test::chance(random, 90);
    const unsigned matrix = test::below(random, 8);
    const unsigned active = 1 + test::below(random, 15);
    std::map<unsigned, unsigned>& of_level = level == 0 ? m.objects : m.triangles;
    const std::size_t slots = level == 0 ? Uneven::kObjectSlots : Uneven::kTriangleSlots;
    const bool has_slot = of_level.contains(matrix) || of_level.size() < slots;
    const unsigned before = of_level.contains(matrix) ? of_level[matrix] : 0;
    ASSERT_EQ(bench.meet(level, matrix, active, packet), active & ~before) << n;
    known += before != 0;
    full += !has_slot;
    if (has_slot) of_level[matrix] |= active;
    if (level == 0) m.triangles.clear();
  }
  EXPECT_GT(known, 10'000u);
  EXPECT_GT(full, 1'000u);
}

struct OneLevel : C {
  static constexpr unsigned kLevels = 1;
};

TEST(MailboxOfRays, OfOneLevelKnowsItsTriangles) {
  test::UnitBench<MailboxOfRays<OneLevel>> bench;
  MailboxEntry<OneLevel> e;
  e.active = RayMask<OneLevel>(0b0011);
  e.clear = true;
  const auto let_through = [&] {
    bench.feed(bench.unit.entry, e);
    bench.run();
    bench.take(bench.unit.start);
    bench.take(bench.unit.seen);
    const auto jobs = bench.take(bench.unit.fresh);
    if (!jobs.empty()) EXPECT_EQ(jobs[0].kind, TransformKind::kTriangle);
    return jobs.size();
  };
  EXPECT_EQ(let_through(), 0u);
  e.clear = false;
  EXPECT_EQ(let_through(), 1u);
  EXPECT_EQ(let_through(), 0u);
  e.clear = true;
  EXPECT_EQ(let_through(), 0u);
  e.clear = false;
  EXPECT_EQ(let_through(), 1u) << "new rays have met nothing";
}

struct Mirrors : C {
  static constexpr unsigned kReflections = 2;
  static constexpr Crossing kCrossing = Crossing::kSplit;
};

TEST(MailboxOfRays, RemembersWhetherRaysAreReflected) {
  test::UnitBench<MailboxOfRays<Mirrors>> bench;
  for (const bool reflected : {true, false}) {
    MailboxEntry<Mirrors> e = entry<Mirrors>(0, 5, 0b1111);
    e.clear = true;
    e.kind = reflected ? RayKind::kReflection : RayKind::kPrimary;
    bench.feed(bench.unit.entry, e);
    bench.feed(bench.unit.entry, entry<Mirrors>(0, 5, 0b0001));
    bench.run();
    EXPECT_EQ(bench.take_one(bench.unit.start).distinct_origins.get(), reflected);
    EXPECT_EQ(bench.take_one(bench.unit.fresh).extras.distinct_origins.get(), reflected);
  }
}

struct NoObjects : C {
  static constexpr unsigned kObjectSlots = 0;
};
struct NoSlots : NoObjects {
  static constexpr unsigned kTriangleSlots = 0;
};

TEST(MailboxOfRays, ALevelWithoutSlotsLetsEverythingThrough) {
  Bench<NoObjects> one;
  Bench<NoSlots> none;
  for (unsigned round = 0; round < 2; ++round) {
    EXPECT_EQ(one.meet(0, 7, 0b0011), 0b0011u);
    EXPECT_EQ(none.meet(0, 7, 0b0011), 0b0011u);
    EXPECT_EQ(none.meet(1, 7, 0b0011), 0b0011u);
  }
  EXPECT_EQ(one.meet(1, 7, 0b0011), 0b0011u);
  EXPECT_EQ(one.meet(1, 7, 0b0011), 0u);
  static_assert(std::is_same_v<decltype(MailboxOfRays<NoSlots>::items), hls::Absent>);
  static_assert(!std::is_same_v<decltype(MailboxOfRays<NoObjects>::items), hls::Absent>);
}

template <class Config>
TransformJob<Config> job_of(const MailboxEntry<Config>& e) {
  Bench<Config> bench;
  bench.feed(bench.unit.entry, e);
  bench.run();
  return bench.take_one(bench.unit.fresh);
}

using WorldBoxes = test::FastFromOnePoint<C>;

TEST(MailboxOfRays, AsksForTheBoxOfAnObjectBeforeItIsEntered) {
  const TransformJob<WorldBoxes> object = job_of(entry<WorldBoxes>(0, 17, 0b1111));
  EXPECT_EQ(object.kind, TransformKind::kBox);
  EXPECT_EQ(object.repeat, RepeatCount<WorldBoxes>(0)) << "one column";
  EXPECT_EQ(object.matrix, MatrixIndex(17));
  const TransformJob<WorldBoxes> triangle = job_of(entry<WorldBoxes>(1, 17, 0b1111));
  EXPECT_EQ(triangle.kind, TransformKind::kTriangle);
  EXPECT_EQ(triangle.repeat, RepeatCount<WorldBoxes>(3));
}

struct LitBoxes : WorldBoxes {
  static constexpr unsigned kLights = 3;
};

TEST(MailboxOfRays, AsksForTheBoxAsItLiesFromWhereThePacketStarts) {
  test::UnitBench<MailboxOfRays<LitBoxes>> bench;
  for (const unsigned viewpoint : {2u, 0u, 3u}) {
    for (const unsigned packet : {1u, 5u}) {
      MailboxEntry<LitBoxes> begin = entry<LitBoxes>(0, 0, 0b1111, packet);
      begin.clear = true;
      begin.viewpoint = Viewpoint<LitBoxes>::from(packet == 1 ? viewpoint : 1);
      bench.feed(bench.unit.entry, begin);
    }
    bench.feed(bench.unit.entry, entry<LitBoxes>(0, 17, 0b1111, 1));
    bench.run();
    const TransformJob<LitBoxes> object = bench.take_one(bench.unit.fresh);
    EXPECT_TRUE(fetches_box<LitBoxes>(object.kind, object.extras));
    EXPECT_EQ(object.extras.viewpoint.get(), Viewpoint<LitBoxes>::from(viewpoint));
  }
}

struct MainFirst : C {
  static constexpr bool kMainFirst = true;
};

TEST(MailboxOfRays, NewRaysMeetTheMainObjectFirst) {
  test::UnitBench<MailboxOfRays<MainFirst>> bench;
  hls::uint<32>& start_node = bench.value(bench.unit.frame).start_node;
  start_node = 350;
  const auto begin = [&bench] {
    MailboxEntry<MainFirst> e = entry<MainFirst>(0, 0, 0b0110, 5);
    e.clear = true;
    bench.feed(bench.unit.entry, e);
    bench.run();
    EXPECT_TRUE(bench.take(bench.unit.fresh).empty());
  };
  begin();
  EXPECT_EQ(bench.take_one(bench.unit.start).active, Rays(0b0110))
      << "where the start node is no list they enter the tree";
  EXPECT_TRUE(bench.take(bench.unit.seen).empty());
  start_node = Word::from((1u << (C::kAddressBits - 1)) | 350);
  begin();
  EXPECT_TRUE(bench.take(bench.unit.start).empty());
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.seen),
                         ListJob<MainFirst>{5, 0, true, 700, Rays(0b0110), true}));
}

}  // namespace
}  // namespace dynrt
