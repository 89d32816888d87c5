// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/shader.h"

#include "configs/whitted.h"
#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = config::whitted;

constexpr unsigned kPacket = 2;
constexpr std::uint32_t kWhite = 0xffffff;

class ShaderTest : public testing::Test {
 protected:
  ShaderTest() {
    bench_.value(bench_.unit.frame).ambient = 64;
    bench_.value(bench_.unit.frame).background = 0x00203040;
  }
  Found<C>& found(unsigned ray) { return bench_.rows(bench_.unit.found)[kPacket * kRays<C> + ray]; }
  static Found<C> surface(std::uint32_t colour, double cosine, unsigned mirror = 0) {
    Found<C> f;
    f.hit = true;
    f.cosine = Real::from_double(cosine);
    f.t = Real::from_double(3);
    f.object = 11;
    f.triangle = 22;
    f.colour = uint<24>::from(colour);
    f.mirror = uint<8>::from(mirror);
    return f;
  }
  /// All four rays the same.
  DerivationEvent<C> shade(RayKind kind, const Found<C>& f, unsigned traced = 15) {
    for (unsigned ray = 0; ray < kRays<C>; ++ray) found(ray) = f;
    bench_.rows(bench_.unit.traced)[kPacket] = RayMask<C>::from(traced);
    ShadeJob<C> job;
    job.packet = kPacket;
    job.kind = kind;
    for (unsigned i = 0; i < kRays<C>; ++i) {
      bench_.feed(bench_.unit.job, Repeated<ShadeJob<C>>{RepeatCount<C>::from(i), i == 3, job});
    }
    bench_.run();
    return bench_.take_one(bench_.unit.derive);
  }
  /// A light of this power at a distance along z.
  void light(double intensity, double distance, std::uint32_t colour = kWhite) {
    bench_.rows(bench_.unit.light)[kPacket] = {Real::from_double(intensity),
                                               uint<24>::from(colour)};
    for (unsigned ray = 0; ray < kRays<C>; ++ray) {
      const auto row = hls::concat(level_row<C>(Level{}, PacketId<C>(kPacket)),
                                   hls::concat(RayIndex<C>::from(ray), uint<1>(1)));
      bench_.rows(bench_.unit.vectors)[row.to_u64()] = {Real{}, Real{},
                                                        Real::from_double(distance)};
    }
  }
  /// Whether something is in the way, and the cosine at the surface.
  Found<C> lit(bool shadow, double cosine) {
    Found<C> f;
    f.hit = shadow;
    f.cosine = Real::from_double(cosine);
    return f;
  }
  unsigned channel_of(unsigned ray, unsigned number) {
    const uint<24> colour = bench_.rows(bench_.unit.pixel_colour)[kPacket * kRays<C> + ray];
    return static_cast<unsigned>(channel(colour, number).to_u64());
  }
  test::UnitBench<Shader<C>> bench_;
};

TEST_F(ShaderTest, APrimaryRayBringsAmbientLightTimesCosine) {
  const DerivationEvent<C> derive = shade(RayKind::kPrimary, surface(0x4080f0, -0.5));
  EXPECT_EQ(derive.kind, RayKind::kPrimary);
  EXPECT_TRUE(derive.shaded);
  EXPECT_EQ(derive.surfaces, RayMask<C>(0b1111));
  EXPECT_EQ(derive.mirrors, RayMask<C>(0));
  EXPECT_NEAR(channel_of(0, 0), 0xf0 * 0.5 * 0.25, 1);
  EXPECT_NEAR(channel_of(3, 1), 0x80 * 0.5 * 0.25, 1);
  EXPECT_NEAR(channel_of(2, 2), 0x40 * 0.5 * 0.25, 1);
  const SurfacePoint<C> point = bench_.rows(bench_.unit.surface)[kPacket * kRays<C> + 1];
  EXPECT_EQ(point.t.to_double(), 3);
  EXPECT_EQ(point.object, MatrixIndex(11));
  EXPECT_EQ(point.triangle, MatrixIndex(22));
}

TEST_F(ShaderTest, AMissIsTheBackground) {
  const DerivationEvent<C> derive = shade(RayKind::kPrimary, Found<C>{});
  EXPECT_EQ(derive.surfaces, RayMask<C>(0));
  EXPECT_EQ(channel_of(1, 0), 0x40u);
  EXPECT_EQ(channel_of(1, 1), 0x30u);
  EXPECT_EQ(channel_of(1, 2), 0x20u);
}

TEST_F(ShaderTest, ALightAddsItsPowerByCosineAndDistance) {
  shade(RayKind::kPrimary, surface(kWhite, -0.5));
  const unsigned ambient = channel_of(0, 0);
  light(1, 4, 0x0000ff);
  // The vector to the surface has length 4, so its product with the unit normal is 4 cosines.
  shade(RayKind::kLight, lit(false, -0.5 * 4));
  EXPECT_NEAR(channel_of(0, 0), ambient + 255 * 0.5 / 4, 1.5);
  EXPECT_EQ(channel_of(0, 1), ambient) << "the light is red";
}

TEST_F(ShaderTest, NothingIsAddedInShadowOrFromBehindOrToRaysThatWereNotTraced) {
  shade(RayKind::kPrimary, surface(kWhite, -0.5));
  const unsigned ambient = channel_of(0, 0);
  light(8, 1);
  shade(RayKind::kLight, lit(true, -0.5));
  EXPECT_EQ(channel_of(0, 0), ambient) << "in shadow";
  shade(RayKind::kLight, lit(false, 0.5));
  EXPECT_EQ(channel_of(0, 0), ambient) << "from the side that is not seen";
  shade(RayKind::kLight, lit(false, -0.5), 0b1110);
  EXPECT_EQ(channel_of(0, 0), ambient) << "not traced";
  EXPECT_EQ(channel_of(1, 0), 255u) << "saturated";
}

TEST_F(ShaderTest, AMirrorKeepsTheRestAndAddsItsPartOfTheReflection) {
  const DerivationEvent<C> first = shade(RayKind::kPrimary, surface(kWhite, -1, 192));
  EXPECT_EQ(first.mirrors, RayMask<C>(0b1111));
  const unsigned kept = channel_of(0, 0);
  EXPECT_NEAR(kept, 255 * 0.25 * 0.25, 1.5);
  const DerivationEvent<C> second = shade(RayKind::kReflection, surface(kWhite, -1), 0b0001);
  EXPECT_EQ(second.surfaces, RayMask<C>(0b0001)) << "only one ray was reflected";
  EXPECT_EQ(second.mirrors, RayMask<C>(0));
  EXPECT_NEAR(channel_of(0, 0), kept + 255 * 0.25 * 0.75, 2);
  EXPECT_EQ(channel_of(1, 0), kept);
}

TEST_F(ShaderTest, ANewPrimaryRayForgetsThePixelBefore) {
  shade(RayKind::kPrimary, surface(kWhite, -1));
  shade(RayKind::kPrimary, surface(0, -1));
  EXPECT_EQ(channel_of(0, 0), 0u);
}

}  // namespace
}  // namespace dynrt
