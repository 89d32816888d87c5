// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/camera_rays.h"

#include <bit>
#include <cmath>

#include "units/test_bench.h"
#include "units/transformation.h"

namespace dynrt {
namespace {

using C = test::Fast<test::PacketsOf<test::Config<8>, 8>>;
using Vec = Vector<Real>;

Vec vec(double x, double y, double z) {
  return {Real::from_double(x), Real::from_double(y), Real::from_double(z)};
}
const std::array<Vec, 4> kMatrix{vec(0.003, 0.0007, -0.001), vec(-0.0002, -0.004, 0.0005),
                                 vec(-1.3, 0.8, 2.1), vec(40, -17, 3.5)};
constexpr unsigned kPacket = 5;
const PixelPosition kPixel{200, 118};

/// The unit with one packet.
template <class Config>
class CameraBench : public test::UnitBench<CameraRays<Config>> {
 public:
  CameraBench() {
    for (unsigned c = 0; c < 3; ++c) this->rows(this->unit.column[c])[0] = kMatrix[c];
    this->rows(this->unit.eye)[eye_row<Config>(kPacket).to_u64()] = kMatrix[3];
    this->rows(this->unit.position)[kPacket] = kPixel;
  }
  /// The vectors of the packet.
  std::vector<PacketVector<Config>> sent() {
    CameraJob<Config> job;
    job.packet = kPacket;
    for (unsigned i = 0; i < 3 * kRays<Config>; ++i) {
      this->feed(this->unit.job, Repeated<CameraJob<Config>>{RepeatCount<Config>::from(i),
                                                             i + 1 == 3 * kRays<Config>, job});
    }
    this->run();
    return this->take(this->unit.vector);
  }
};

/// The vectors that the transformation makes of the same packet's pre-primary rays (thesis 6.2.1).
std::vector<PacketVector<C>> transformed() {
  test::UnitBench<Transformation<C>> bench;
  for (unsigned c = 0; c < 4; ++c) bench.rows(bench.unit.column[c])[kPacket] = kMatrix[c];
  PacketVector<C> vector;
  vector.packet = kPacket;
  vector.point = true;
  bench.feed(bench.unit.vector, vector);
  vector.point = false;
  for (unsigned i = 0; i < kRays<C>; ++i) {
    vector.ray = RayIndex<C>::from(i);
    vector.last = i + 1 == kRays<C>;
    const PixelPosition p = pixel_of<C>(kPixel, vector.ray);
    vector.vector = {Real::from_uint(p.x), Real::from_uint(p.y), Real::one()};
    bench.feed(bench.unit.vector, vector);
  }
  bench.run();
  return bench.take(bench.unit.transformed);
}

TEST(CameraRays, HaveTheBitsThatTheTransformationGivesThem) {
  const auto expected = transformed();
  ASSERT_EQ(expected.size(), kRays<C> + 1);
  CameraBench<C> bench;
  // The second packet begins where the first ended.
  for (unsigned packet = 0; packet < 2; ++packet) {
    const auto got = bench.sent();
    ASSERT_EQ(got.size(), expected.size());
    for (unsigned i = 0; i < got.size(); ++i) {
      EXPECT_EQ(got[i].packet, expected[i].packet) << i;
      EXPECT_EQ(got[i].point, expected[i].point) << i;
      EXPECT_EQ(got[i].ray, expected[i].ray) << i;
      EXPECT_EQ(got[i].last.get(), expected[i].last.get()) << i;
      EXPECT_TRUE(test::same(got[i].vector, expected[i].vector)) << i;
    }
  }
}

TEST(CameraRays, HaveAnOriginEachInAnUncompressedFrame) {
  CameraBench<C> bench;
  bench.value(bench.unit.frame).uncompressed = Word(1);
  const auto got = bench.sent();
  ASSERT_EQ(got.size(), 2 * kRays<C>);
  for (unsigned i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].point, i % 2 == 0) << i;
    EXPECT_EQ(got[i].ray, RayIndex<C>::from(i / 2)) << i;
    if (got[i].point) EXPECT_TRUE(test::same(got[i].vector, kMatrix[3])) << i;
  }
}

struct Lit : C {
  static constexpr unsigned kLights = 2;
};

/// A light ray as the transformation makes it, from the light's matrix and (1, t, -1) (6.2.2).
Vec transformed(const Ray<Real>& arriving, Real t, const Vec& light) {
  test::UnitBench<Transformation<Lit>> bench;
  const Vec columns[] = {arriving.origin, arriving.direction, light, light};
  for (unsigned c = 0; c < 4; ++c) bench.rows(bench.unit.column[c])[kPacket] = columns[c];
  PacketVector<Lit> vector;
  vector.packet = kPacket;
  vector.vector = {Real::one(), t, -Real::one()};
  bench.feed(bench.unit.vector, vector);
  bench.run();
  return bench.take_one(bench.unit.transformed).vector;
}

/// Those that have hit something go from the light to where they hit; camera rays go on as before.
TEST(CameraRays, GoToALightAsTheTransformationSendsThem) {
  CameraBench<Lit> bench;
  test::Random random(5);
  const auto coordinate = [&random] { return (test::below(random, 20'001) - 1e4) / 64; };
  const auto some = [&] { return vec(coordinate(), coordinate(), coordinate()); };
  for (unsigned round = 0; round < 100; ++round) {
    const auto lit = RayMask<C>::from(1 + test::below(random, 255));
    for (unsigned ray = 0; ray < kRays<C>; ++ray) {
      const auto row = kPacket * kRays<C> + ray;
      bench.rows(bench.unit.arriving)[row] = {some(), some()};
      bench.rows(bench.unit.surface)[row].t = Real::from_double(std::abs(coordinate()));
    }
    CameraJob<Lit> job;
    job.packet = kPacket;
    job.to_light = true;
    job.lit = lit;
    const unsigned steps =
        3 * static_cast<unsigned>(std::popcount(static_cast<unsigned>(lit.to_u64())));
    for (unsigned i = 0; i < steps; ++i) {
      bench.feed(bench.unit.job,
                 Repeated<CameraJob<Lit>>{RepeatCount<C>::from(i), i + 1 == steps, job});
    }
    bench.run();
    const auto got = bench.take(bench.unit.vector);
    ASSERT_EQ(got.size(), steps / 3 + 1);
    EXPECT_TRUE(got[0].point);
    EXPECT_TRUE(test::same(got[0].vector, kMatrix[3])) << "they begin at the light";
    std::size_t next = 1;
    for (unsigned ray = 0; ray < kRays<C>; ++ray) {
      if (!lit.bit(ray)) continue;
      const auto row = kPacket * kRays<C> + ray;
      EXPECT_EQ(got[next].ray, RayIndex<C>::from(ray));
      EXPECT_FALSE(got[next].point);
      EXPECT_EQ(got[next].last.get(), next == steps / 3);
      const Vec expected = transformed(bench.rows(bench.unit.arriving)[row],
                                       bench.rows(bench.unit.surface)[row].t, kMatrix[3]);
      ASSERT_TRUE(test::same(got[next].vector, expected)) << round << ", ray " << ray;
      ++next;
    }
    ASSERT_EQ(bench.sent().size(), kRays<C> + 1) << "then the camera's";
  }
}

}  // namespace
}  // namespace dynrt
