// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/collect_hits.h"

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<CollectHits<C>>;

void feed(UnitBench& bench, const HitCandidate<C>& in) {
  bench.feed(bench.unit.candidate, in);
  bench.run();
}
HitCandidate<C> reset(unsigned packet, unsigned ray) {
  HitCandidate<C> in;
  in.packet = PacketId<C>::from(packet);
  in.ray = RayIndex<C>::from(ray);
  in.reset = true;
  in.t = Real::one();
  return in;
}
HitCandidate<C> candidate(unsigned packet, unsigned ray, double t, bool hit = true) {
  HitCandidate<C> in;
  in.packet = PacketId<C>::from(packet);
  in.ray = RayIndex<C>::from(ray);
  in.hit = hit;
  in.t = Real::from_double(t);
  in.u = Real::from_double(t / 4);
  return in;
}
HitRecord<C> stored(UnitBench& bench, unsigned packet, unsigned ray) {
  return bench.rows(bench.unit.hit)[packet * 4 + ray];
}

TEST(CollectHits, ANewRayHasNoHitAndThenStarts) {
  UnitBench bench;
  bench.rows(bench.unit.record)[6].active = 0b0011;
  for (unsigned ray = 0; ray < kRays<C>; ++ray) {
    EXPECT_TRUE(bench.take(bench.unit.start).empty());
    feed(bench, reset(6, ray));
    HitRecord<C> none;
    none.t = Real::largest();
    EXPECT_TRUE(test::same(stored(bench, 6, ray), none));
    EXPECT_EQ(bench.rows(bench.unit.distance[ray])[6], Real::largest());
  }
  MailboxEntry<C> begin;
  begin.packet = 6;
  begin.active = 0b0011;
  begin.clear = true;
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.start), begin));
  EXPECT_TRUE(bench.take(bench.unit.go_on).empty());
}

TEST(CollectHits, AfterTheLastRayTheListGoesOn) {
  UnitBench bench;
  for (unsigned ray = 0; ray < kRays<C>; ++ray) {
    EXPECT_TRUE(bench.take(bench.unit.go_on).empty());
    feed(bench, candidate(2, ray, 1, ray % 2 == 0));
  }
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.go_on), ListJob<C>{2, 1, false, {}}));
  EXPECT_TRUE(bench.take(bench.unit.start).empty());
}

TEST(CollectHits, OfEqualDistancesTheFirstStays) {
  UnitBench bench;
  feed(bench, reset(1, 0));
  bench.rows(bench.unit.record)[1].matrix = 100;
  feed(bench, candidate(1, 0, 5));
  bench.rows(bench.unit.record)[1].matrix = 200;
  feed(bench, candidate(1, 0, 5));
  EXPECT_EQ(stored(bench, 1, 0).triangle, MatrixIndex(100));
  feed(bench, candidate(1, 0, 4.5));
  EXPECT_EQ(stored(bench, 1, 0).triangle, MatrixIndex(200));
}

TEST(CollectHits, KeepsTheClosestHitOfEveryRay) {
  UnitBench bench;
  test::Random random(61);
  HitRecord<C> best[C::kPackets][kRays<C>];
  for (unsigned i = 0; i < C::kPackets * kRays<C>; ++i) {
    feed(bench, reset(i / 4, i % 4));
    best[i / 4][i % 4].t = Real::largest();
  }
  unsigned closer = 0, farther = 0, equal = 0, resets = 0;
  for (unsigned n = 0; n < 100'000; ++n) {
    const unsigned packet = test::below(random, C::kPackets);
    const unsigned ray = test::below(random, kRays<C>);
    auto in = test::random_token<HitCandidate<C>>(random);
    in.packet = PacketId<C>::from(packet);
    in.ray = RayIndex<C>::from(ray);
    in.reset = test::chance(random, 5);
    in.hit = !in.reset && test::chance(random, 70);
    in.t = Real::from_double(test::below(random, 50));
    JobRecord<C>& job = bench.rows(bench.unit.record)[packet];
    job = test::random_token<JobRecord<C>>(random);
    MatrixIndex& object = bench.rows(bench.unit.object)[packet];
    object = test::random_token<MatrixIndex>(random);
    HitRecord<C>& record = best[packet][ray];
    if (in.reset) {
      record = HitRecord<C>{};
      record.t = Real::largest();
      ++resets;
    } else if (in.hit && in.t < record.t) {
      record = {true, in.t, in.u, in.v, in.cosine, object, job.matrix, job.extra};
      ++closer;
    } else if (in.hit) {
      (in.t == record.t ? equal : farther) += 1;
    }
    feed(bench, in);
    ASSERT_TRUE(test::same(stored(bench, packet, ray), record)) << n;
    ASSERT_EQ(bench.rows(bench.unit.distance[ray])[packet], record.t);
  }
  EXPECT_GT(std::min({closer, farther, equal, resets}), 1000u);
}

struct LitAtOnce : test::FastFromOnePoint<C> {
  static constexpr unsigned kLights = 2;
};

TEST(CollectHits, LightRaysThatAreMadeAtOnceStartAsTheCamerasDo) {
  test::UnitBench<CollectHits<LitAtOnce>> bench;
  JobRecord<LitAtOnce>& job = bench.rows(bench.unit.record)[6];
  for (const bool light : {false, true, false}) {
    job.kind = light ? TransformKind::kSecondary : TransformKind::kCamera;
    job.active = 0b1010;
    job.viewpoint = Viewpoint<LitAtOnce>::from(light ? 2 : 0);
    for (const unsigned ray : {1u, 3u}) {
      EXPECT_TRUE(bench.take(bench.unit.start).empty());
      HitCandidate<LitAtOnce> in;
      in.packet = 6;
      in.ray = RayIndex<LitAtOnce>::from(ray);
      in.reset = true;
      in.last = ray == 3;
      bench.feed(bench.unit.candidate, in);
      bench.run();
    }
    const MailboxEntry<LitAtOnce> begin = bench.take_one(bench.unit.start);
    EXPECT_TRUE(begin.clear);
    EXPECT_EQ(begin.active, RayMask<LitAtOnce>(0b1010));
    EXPECT_EQ(begin.kind.get(), light ? RayKind::kLight : RayKind::kPrimary);
    EXPECT_EQ(begin.viewpoint.get(), Viewpoint<LitAtOnce>::from(light ? 2 : 0));
  }
}

struct LitSpheres : C {
  static constexpr unsigned kLights = 1;
  static constexpr Primitives kPrimitives{.triangle = true, .sphere = true};
};

/// A light ray to a surface, t = 1, that meets the surface's own primitive at some t.
Found<LitSpheres> lit_at(Primitive primitive, double t) {
  test::UnitBench<CollectHits<LitSpheres>> bench;
  bench.rows(bench.unit.surface)[0] = {Real::one(), 7, 9};
  bench.rows(bench.unit.object)[0] = 7;
  JobRecord<LitSpheres> job;
  job.kind = TransformKind::kSecondary;
  job.derived = DerivedRay<LitSpheres>{Derivation::kLight, 0};
  job.matrix = 9;
  job.active = 1;
  bench.rows(bench.unit.record)[0] = job;
  HitCandidate<LitSpheres> in;
  in.reset = true;
  bench.feed(bench.unit.candidate, in);
  bench.run();
  job.kind = TransformKind::kTriangle;
  job.primitive = primitive;
  bench.rows(bench.unit.record)[0] = job;
  in = {};
  in.hit = true;
  in.t = Real::from_double(t);
  in.cosine = Real::from_double(0.5);
  bench.feed(bench.unit.candidate, in);
  bench.run();
  return bench.rows(bench.unit.found)[0];
}

TEST(CollectHits, TheFarSideOfASphereIsInItsOwnShadow) {
  EXPECT_FALSE(lit_at(Primitive::kSphere, 1).hit);
  EXPECT_EQ(lit_at(Primitive::kSphere, 1).cosine.to_double(), 0.5);
  EXPECT_TRUE(lit_at(Primitive::kSphere, 0.5).hit);
  EXPECT_FALSE(lit_at(Primitive::kTriangle, 0.5).hit) << "a triangle does not lie before itself";
}

using WorldBoxes = test::FastFromOnePoint<test::Config<8>>;

TEST(CollectHits, GivesEveryRaysDistanceToTheTestOfBoxes) {
  test::UnitBench<CollectHits<WorldBoxes>> bench;
  const auto reach = [&bench](unsigned packet, unsigned ray) {
    return bench.rows(bench.unit.reach)[packet * 4 + ray];
  };
  const auto send = [&bench](unsigned ray, double t, bool hit, bool is_new) {
    HitCandidate<WorldBoxes> in;
    in.packet = 6;
    in.ray = RayIndex<WorldBoxes>::from(ray);
    in.reset = is_new;
    in.hit = hit;
    in.t = Real::from_double(t);
    bench.feed(bench.unit.candidate, in);
    bench.run();
  };
  send(2, 1, false, true);
  EXPECT_EQ(reach(6, 2), Real::largest());
  send(2, 5, true, false);
  EXPECT_EQ(reach(6, 2), Real::from_double(5));
  send(2, 7, true, false);
  send(2, 3, false, false);
  EXPECT_EQ(reach(6, 2), Real::from_double(5)) << "neither is a closer hit";
  send(2, 2, true, false);
  EXPECT_EQ(reach(6, 2), bench.rows(bench.unit.distance[2])[6]);
  EXPECT_EQ(reach(6, 2), Real::from_double(2));
}

}  // namespace
}  // namespace dynrt
