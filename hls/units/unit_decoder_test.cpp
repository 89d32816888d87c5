// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/unit_decoder.h"

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Fast<test::Config<8>>;
struct Spheres : C {
  static constexpr Primitives kPrimitives{.triangle = true, .sphere = true};
};

Vector<Real> vec(double x, double y, double z) {
  return {Real::from_double(x), Real::from_double(y), Real::from_double(z)};
}

TEST(UnitDecoder, GivesEachDirectionTheOriginBeforeIt) {
  test::UnitBench<UnitDecoder<C>> bench;
  const auto feed = [&](unsigned packet, bool point, unsigned ray, const Vector<Real>& vector) {
    bench.feed(bench.unit.vector,
               PacketVector<C>{PacketId<C>::from(packet), point, RayIndex<C>::from(ray), vector});
  };
  feed(3, true, 0, vec(1, 2, 3));
  feed(3, false, 0, vec(4, 5, 6));
  feed(3, false, 2, vec(7, 8, 9));
  feed(6, true, 0, vec(-1, -2, -3));
  feed(6, false, 1, vec(1, 1, 1));
  bench.run();
  const auto rays = bench.take(bench.unit.unit_ray);
  ASSERT_EQ(rays.size(), 3u);
  const auto expect = [&](unsigned i, unsigned packet, unsigned ray, const Ray<Real>& unit) {
    EXPECT_EQ(rays[i].packet, PacketId<C>::from(packet)) << i;
    EXPECT_EQ(rays[i].ray, RayIndex<C>::from(ray)) << i;
    EXPECT_FALSE(rays[i].reset) << i;
    EXPECT_TRUE(test::same(rays[i].unit, unit)) << i;
  };
  expect(0, 3, 0, {vec(1, 2, 3), vec(4, 5, 6)});
  expect(1, 3, 2, {vec(1, 2, 3), vec(7, 8, 9)});
  expect(2, 6, 1, {vec(-1, -2, -3), vec(1, 1, 1)});
}

TEST(UnitDecoder, MarksTheRaysByTheirPacketsRecord) {
  test::UnitBench<UnitDecoder<Spheres>> bench;
  bench.rows(bench.unit.record)[3].primitive = Primitive::kSphere;
  bench.rows(bench.unit.record)[3].cosine_factor = Real::from_double(0.75);
  bench.feed(bench.unit.vector, PacketVector<Spheres>{3, false, 1, vec(4, 5, 6)});
  bench.run();
  const UnitRay<Spheres> ray = bench.take_one(bench.unit.unit_ray);
  EXPECT_TRUE(is_primitive<Spheres>(Primitive::kSphere, ray.primitive));
  EXPECT_EQ(ray.cosine_factor.get(), Real::from_double(0.75));
}

}  // namespace
}  // namespace dynrt
