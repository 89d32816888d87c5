// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/camera_rays.h"

#include "units/send_packet.h"
#include "units/test_bench.h"
#include "units/transformation.h"

namespace dynrt {
namespace {

struct C : test::Config<8> {
  static constexpr unsigned kPacketRays = 8;
  static constexpr RaysSent kRaysSent = RaysSent::kActive;
  static constexpr CameraSource kCamera = CameraSource::kOwnUnit;
};
struct Fused : C {
  static constexpr Sums kSums = Sums::kFused;
};
/// Whose transformation makes the camera's rays.
template <class Config>
struct ByTransformation : Config {
  static constexpr CameraSource kCamera = CameraSource::kTransformation;
};
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
    for (unsigned c = 0; c < 4; ++c) this->rows(this->unit.column[c])[kPacket] = kMatrix[c];
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

/// The vectors that the transformation makes of the same packet.
template <class Config>
std::vector<PacketVector<Config>> transformed() {
  test::UnitBench<SendPacket<Config>> send;
  test::UnitBench<Transformation<Config>> transformation;
  send.rows(send.unit.position)[kPacket] = kPixel;
  for (unsigned c = 0; c < 4; ++c) {
    transformation.rows(transformation.unit.column[c])[kPacket] = kMatrix[c];
  }
  SendJob<Config> job;
  job.packet = kPacket;
  job.sent = RayMask<Config>::ones();
  job.repeat = RepeatCount<Config>(kRays<Config>);
  for (unsigned i = 0; i <= kRays<Config>; ++i) {
    send.feed(send.unit.job,
              Repeated<SendJob<Config>>{RepeatCount<Config>::from(i), i == kRays<Config>, job});
  }
  send.run();
  for (const auto& vector : send.take(send.unit.vector)) {
    transformation.feed(transformation.unit.vector, vector);
  }
  transformation.run();
  return transformation.take(transformation.unit.transformed);
}

template <class Config>
void expect_the_bits_of_the_transformation() {
  const auto expected = transformed<ByTransformation<Config>>();
  ASSERT_EQ(expected.size(), kRays<Config> + 1);
  CameraBench<Config> bench;
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

TEST(CameraRays, HaveTheBitsThatTheTransformationGivesThem) {
  expect_the_bits_of_the_transformation<C>();
}
TEST(CameraRays, HaveThemWhereSumsAreFusedToo) { expect_the_bits_of_the_transformation<Fused>(); }

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

}  // namespace
}  // namespace dynrt
