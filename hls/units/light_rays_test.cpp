// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/light_rays.h"

#include <optional>

#include "configs/fast_lit.h"
#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = config::fast_lit;

constexpr unsigned kPacket = 3;
constexpr unsigned kFirstLight = 7000;

class LightRaysTest : public testing::Test {
 protected:
  LightRaysTest() { bench_.value(bench_.unit.frame).light_matrix = kFirstLight; }
  void lights(unsigned number) { bench_.value(bench_.unit.frame).lights = Word::from(number); }
  /// The job for the next light; none: the pixels are complete.
  std::optional<TransformJob<C>> shaded(RayKind kind, unsigned surfaces) {
    DerivationEvent<C> d;
    d.packet = kPacket;
    d.shaded = true;
    d.kind = kind;
    d.surfaces = RayMask<C>::from(surfaces);
    bench_.feed(bench_.unit.derive, d);
    bench_.run();
    const auto jobs = bench_.take(bench_.unit.job);
    const auto finished = bench_.take(bench_.unit.finished);
    EXPECT_EQ(jobs.size() + finished.size(), 1u);
    for (const ShadeJob<C>& job : finished) {
      EXPECT_EQ(job.repeat, kLastWrite<C>);
      EXPECT_EQ(job.packet, PacketId<C>(kPacket));
    }
    return jobs.empty() ? std::nullopt : std::optional(jobs.front());
  }
  void expect_light(const std::optional<TransformJob<C>>& job, unsigned light, unsigned rays) {
    ASSERT_TRUE(job);
    EXPECT_EQ(job->kind, TransformKind::kSecondary);
    EXPECT_EQ(job->packet, PacketId<C>(kPacket));
    EXPECT_EQ(job->extras.derived.get().pass, Derivation::kLight);
    EXPECT_EQ(job->extras.viewpoint.get(), Viewpoint<C>::from(light + 1));
    EXPECT_EQ(job->matrix, MatrixIndex::from(kFirstLight + light));
    EXPECT_EQ(job->active, RayMask<C>::from(rays));
    EXPECT_EQ(bench_.rows(bench_.unit.traced)[kPacket], RayMask<C>::from(rays));
  }

 private:
  test::UnitBench<LightRays<C>> bench_;
};

TEST_F(LightRaysTest, WithoutLightsThePixelsAreComplete) {
  lights(0);
  EXPECT_FALSE(shaded(RayKind::kPrimary, 0xff));
}

TEST_F(LightRaysTest, WhatHitNothingIsNotLit) {
  lights(2);
  EXPECT_FALSE(shaded(RayKind::kPrimary, 0));
}

/// The surfaces are those of the primary rays: light rays find none.
TEST_F(LightRaysTest, EveryLightLooksAtEverySurfaceInTurn) {
  lights(3);
  for (unsigned packet = 0; packet < 2; ++packet) {
    const unsigned surfaces = packet == 0 ? 0b10100101u : 0b00010000u;
    expect_light(shaded(RayKind::kPrimary, surfaces), 0, surfaces);
    expect_light(shaded(RayKind::kLight, 0), 1, surfaces);
    expect_light(shaded(RayKind::kLight, 0), 2, surfaces);
    EXPECT_FALSE(shaded(RayKind::kLight, 0));
  }
}

}  // namespace
}  // namespace dynrt
