// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/send_packet.h"

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<SendPacket<C>>;
using Vec = Vector<Real>;

struct Sent {
  bool point;
  unsigned ray;
};
/// The vectors of a packet in their order.
std::vector<Sent> order(bool compressed) {
  if (compressed) return {{true, 0}, {false, 0}, {false, 1}, {false, 2}, {false, 3}};
  return {{true, 0}, {false, 0}, {true, 1}, {false, 1},
          {true, 2}, {false, 2}, {true, 3}, {false, 3}};
}

std::vector<PacketVector<C>> send(UnitBench& bench, unsigned packet, TransformKind kind,
                                  bool compressed) {
  const unsigned repeat = compressed ? 4 : 7;
  const SendJob<C> job{RepeatCount<C>::from(repeat), PacketId<C>::from(packet), kind};
  for (unsigned i = 0; i <= repeat; ++i) {
    bench.feed(bench.unit.job, Repeated<SendJob<C>>{RepeatCount<C>::from(i), i == repeat, job});
  }
  bench.run();
  return bench.take(bench.unit.vector);
}

void fill(UnitBench& bench) {
  test::Random random(8);
  for (Vec& row : bench.rows(bench.unit.vectors)) row = test::random_token<Vec>(random);
}

TEST(SendPacket, SendsTheStoredVectorsOfTheLevelThatIsLeft) {
  UnitBench bench;
  fill(bench);
  const auto stored = [&bench](unsigned level, unsigned packet, unsigned number) {
    return bench.rows(bench.unit.vectors)[(level * 8 + packet) * 8 + number];
  };
  for (const bool compressed : {true, false}) {
    for (unsigned packet = 0; packet < C::kPackets; ++packet) {
      for (const TransformKind kind : {TransformKind::kObject, TransformKind::kTriangle}) {
        const unsigned level = kind == TransformKind::kTriangle;
        std::vector<PacketVector<C>> expected;
        for (const Sent& s : order(compressed)) {
          expected.push_back({PacketId<C>::from(packet), s.point, RayIndex<C>::from(s.ray),
                              stored(level, packet, 2 * s.ray + !s.point)});
        }
        EXPECT_TRUE(test::same(send(bench, packet, kind, compressed), expected));
      }
    }
  }
}

TEST(SendPacket, TheCameraTransformsPrePrimaryRays) {
  UnitBench bench;
  fill(bench);
  for (const auto& [x, y] : {std::pair{0u, 0u}, {1022u, 1020u}, {510u, 2u}}) {
    bench.rows(bench.unit.position)[5] = {uint<10>::from(x), uint<10>::from(y)};
    std::vector<PacketVector<C>> expected;
    for (const Sent& s : order(true)) {
      const Vec direction{Real::from_double(x + (s.ray & 1)), Real::from_double(y + (s.ray >> 1)),
                          Real::one()};
      expected.push_back({5, s.point, RayIndex<C>::from(s.ray), s.point ? Vec{} : direction});
    }
    EXPECT_TRUE(test::same(send(bench, 5, TransformKind::kCamera, true), expected));
  }
}

}  // namespace
}  // namespace dynrt
