// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/secondary_rays.h"

#include <optional>

#include "configs/whitted.h"
#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = config::whitted;

constexpr unsigned kPacket = 3;
constexpr unsigned kFirstLight = 7000;

/// What the unit does about one token: exactly one of the three.
struct Answer {
  std::optional<TransformJob<C>> job;
  std::optional<MailboxEntry<C>> start;
  bool finished = false;
};

class SecondaryRaysTest : public testing::Test {
 protected:
  SecondaryRaysTest() {
    bench_.value(bench_.unit.frame).light_matrix = kFirstLight;
    for (unsigned ray = 0; ray < kRays<C>; ++ray) {
      auto& point = bench_.rows(bench_.unit.surface)[kPacket * kRays<C> + ray];
      point.object = MatrixIndex::from(100 + 10 * ray);
      point.triangle = MatrixIndex::from(200 + 10 * ray);
    }
  }
  void frame(unsigned lights, unsigned reflections) {
    bench_.value(bench_.unit.frame).lights = Word::from(lights);
    bench_.value(bench_.unit.frame).reflections = Word::from(reflections);
  }
  Answer shaded(RayKind kind, unsigned surfaces, unsigned mirrors) {
    DerivationEvent<C> d;
    d.packet = kPacket;
    d.shaded = true;
    d.kind = kind;
    d.surfaces = RayMask<C>::from(surfaces);
    d.mirrors = RayMask<C>::from(mirrors);
    return send(d);
  }
  Answer pass_done() {
    DerivationEvent<C> d;
    d.packet = kPacket;
    return send(d);
  }
  void expect_job(const Answer& answer, Derivation pass, unsigned ray, unsigned matrix,
                  unsigned rays) {
    ASSERT_TRUE(answer.job);
    EXPECT_EQ(answer.job->kind, TransformKind::kSecondary);
    EXPECT_EQ(answer.job->packet, PacketId<C>(kPacket));
    EXPECT_EQ(answer.job->extras.derived.get().pass, pass);
    EXPECT_EQ(answer.job->extras.derived.get().ray, RayIndex<C>::from(ray));
    EXPECT_EQ(answer.job->matrix, MatrixIndex::from(matrix));
    EXPECT_EQ(answer.job->active, RayMask<C>::from(rays));
  }
  void expect_start(const Answer& answer, RayKind kind, unsigned rays) {
    ASSERT_TRUE(answer.start);
    EXPECT_TRUE(answer.start->clear);
    EXPECT_EQ(answer.start->kind.get(), kind);
    EXPECT_EQ(answer.start->active, RayMask<C>::from(rays));
    EXPECT_EQ(bench_.rows(bench_.unit.traced)[kPacket], RayMask<C>::from(rays));
  }

 private:
  Answer send(const DerivationEvent<C>& d) {
    bench_.feed(bench_.unit.derive, d);
    bench_.run();
    Answer answer;
    const auto jobs = bench_.take(bench_.unit.job);
    const auto starts = bench_.take(bench_.unit.start);
    const auto finished = bench_.take(bench_.unit.finished);
    EXPECT_EQ(jobs.size() + starts.size() + finished.size(), 1u);
    if (!jobs.empty()) answer.job = jobs.front();
    if (!starts.empty()) answer.start = starts.front();
    for (const ShadeJob<C>& job : finished) {
      EXPECT_EQ(job.repeat, kLastWrite<C>);
      EXPECT_EQ(job.packet, PacketId<C>(kPacket));
      answer.finished = true;
    }
    return answer;
  }
  test::UnitBench<SecondaryRays<C>> bench_;
};

TEST_F(SecondaryRaysTest, WithoutLightsAndMirrorsThePixelsAreComplete) {
  frame(0, 0);
  EXPECT_TRUE(shaded(RayKind::kPrimary, 0b1111, 0b1111).finished);
}

TEST_F(SecondaryRaysTest, WhatHitNothingHasNoRaysToFollow) {
  frame(2, 3);
  EXPECT_TRUE(shaded(RayKind::kPrimary, 0, 0).finished);
}

TEST_F(SecondaryRaysTest, EveryLightLooksAtEverySurfaceInTurn) {
  frame(2, 0);
  Answer answer = shaded(RayKind::kPrimary, 0b1010, 0b1010);
  for (unsigned light = 0; light < 2; ++light) {
    SCOPED_TRACE(light);
    expect_job(answer, Derivation::kLight, 1, kFirstLight + light, 0b1010);
    expect_job(pass_done(), Derivation::kLight, 3, kFirstLight + light, 0b1010);
    expect_start(pass_done(), RayKind::kLight, 0b1010);
    answer = shaded(RayKind::kLight, 0, 0);
  }
  EXPECT_TRUE(answer.finished) << "no reflections in this frame";
}

TEST_F(SecondaryRaysTest, AReflectionTakesThreePassesAndIsLitToo) {
  frame(1, 2);
  shaded(RayKind::kPrimary, 0b0101, 0b0100);
  pass_done();
  expect_start(pass_done(), RayKind::kLight, 0b0101);
  for (unsigned bounce = 0; bounce < 2; ++bounce) {
    SCOPED_TRACE(bounce);
    expect_job(shaded(RayKind::kLight, 0, 0), Derivation::kIntoObject, 2, 120, 0b0100);
    expect_job(pass_done(), Derivation::kMirror, 2, 221, 0b0100);
    expect_job(pass_done(), Derivation::kOutOfObject, 2, 121, 0b0100);
    expect_start(pass_done(), RayKind::kReflection, 0b0100);
    expect_job(shaded(RayKind::kReflection, 0b0100, 0b0100), Derivation::kLight, 2, kFirstLight,
               0b0100);
    expect_start(pass_done(), RayKind::kLight, 0b0100);
  }
  EXPECT_TRUE(shaded(RayKind::kLight, 0, 0).finished) << "the last bounce has been";
}

TEST_F(SecondaryRaysTest, EveryPrimaryRayCountsItsBouncesAnew) {
  frame(0, 1);
  for (int pixel = 0; pixel < 3; ++pixel) {
    SCOPED_TRACE(pixel);
    expect_job(shaded(RayKind::kPrimary, 1, 1), Derivation::kIntoObject, 0, 100, 1);
    pass_done();
    pass_done();
    expect_start(pass_done(), RayKind::kReflection, 1);
    EXPECT_TRUE(shaded(RayKind::kReflection, 1, 1).finished);
  }
}

}  // namespace
}  // namespace dynrt
