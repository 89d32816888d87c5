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
/// Whose transformation makes the camera's rays.
struct Thesis : C {
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

class CameraRaysTest : public testing::Test {
 protected:
  CameraRaysTest() {
    for (unsigned c = 0; c < 4; ++c) bench_.rows(bench_.unit.column[c])[kPacket] = kMatrix[c];
    bench_.rows(bench_.unit.position)[kPacket] = kPixel;
  }
  /// The vectors of a packet.
  std::vector<PacketVector<C>> sent() {
    CameraJob<C> job;
    job.packet = kPacket;
    for (unsigned i = 0; i < 3 * kRays<C>; ++i) {
      bench_.feed(bench_.unit.job,
                  Repeated<CameraJob<C>>{RepeatCount<C>::from(i), i + 1 == 3 * kRays<C>, job});
    }
    bench_.run();
    return bench_.take(bench_.unit.vector);
  }
  test::UnitBench<CameraRays<C>> bench_;
};

/// The vectors that the transformation makes of the same packet.
std::vector<PacketVector<Thesis>> transformed() {
  test::UnitBench<SendPacket<Thesis>> send;
  test::UnitBench<Transformation<Thesis>> transformation;
  send.rows(send.unit.position)[kPacket] = kPixel;
  for (unsigned c = 0; c < 4; ++c) {
    transformation.rows(transformation.unit.column[c])[kPacket] = kMatrix[c];
  }
  SendJob<Thesis> job;
  job.packet = kPacket;
  job.sent = RayMask<Thesis>::ones();
  job.repeat = RepeatCount<Thesis>(kRays<Thesis>);
  for (unsigned i = 0; i <= kRays<Thesis>; ++i) {
    send.feed(send.unit.job,
              Repeated<SendJob<Thesis>>{RepeatCount<Thesis>::from(i), i == kRays<Thesis>, job});
  }
  send.run();
  for (const auto& vector : send.take(send.unit.vector)) {
    transformation.feed(transformation.unit.vector, vector);
  }
  transformation.run();
  return transformation.take(transformation.unit.transformed);
}

TEST_F(CameraRaysTest, HaveTheBitsThatTheTransformationGivesThem) {
  const auto expected = transformed();
  ASSERT_EQ(expected.size(), kRays<C> + 1);
  // The second packet begins where the first ended.
  for (unsigned packet = 0; packet < 2; ++packet) {
    const auto got = sent();
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

TEST_F(CameraRaysTest, HaveAnOriginEachInAnUncompressedFrame) {
  bench_.value(bench_.unit.frame).uncompressed = Word(1);
  const auto got = sent();
  ASSERT_EQ(got.size(), 2 * kRays<C>);
  for (unsigned i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].point, i % 2 == 0) << i;
    EXPECT_EQ(got[i].ray, RayIndex<C>::from(i / 2)) << i;
    if (got[i].point) EXPECT_TRUE(test::same(got[i].vector, kMatrix[3])) << i;
  }
}

}  // namespace
}  // namespace dynrt
