// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/packet_decoder.h"

#include <algorithm>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<PacketDecoder<C>>;
using Vec = Vector<Real>;

struct Packet {
  std::array<Vec, kRays<C>> origin, direction;
};
Packet random_packet(test::Random& random, bool common_origin) {
  Packet p{test::random_token<std::array<Vec, kRays<C>>>(random),
           test::random_token<std::array<Vec, kRays<C>>>(random)};
  if (common_origin) p.origin.fill(p.origin[0]);
  return p;
}

/// Sends a packet's vectors in the order of SendPacket.
void feed(UnitBench& bench, PacketId<C> id, const Packet& packet, bool compressed) {
  for (unsigned ray = 0; ray < kRays<C>; ++ray) {
    const RayIndex<C> index = RayIndex<C>::from(ray);
    if (!compressed || ray == 0) {
      bench.feed(bench.unit.vector, PacketVector<C>{id, true, index, packet.origin[ray]});
    }
    bench.feed(bench.unit.vector, PacketVector<C>{id, false, index, packet.direction[ray]});
  }
  bench.run();
}
std::vector<UnitRay<C>> unit_rays(PacketId<C> id, const Packet& packet, bool reset) {
  std::vector<UnitRay<C>> rays;
  for (unsigned ray = 0; ray < kRays<C>; ++ray) {
    rays.push_back(
        {id, RayIndex<C>::from(ray), reset, {packet.origin[ray], packet.direction[ray]}});
  }
  return rays;
}
void expect_saved(UnitBench& bench, unsigned level, PacketId<C> id, const Packet& packet,
                  bool compressed) {
  const std::uint64_t row = level * 8 + id.to_u64();
  for (unsigned ray = 0; ray < kRays<C>; ++ray) {
    const Ray<Real> expected{packet.origin[ray], packet.direction[ray]};
    EXPECT_TRUE(test::same(bench.rows(bench.unit.ray[ray])[row], by_axis(expected))) << ray;
    const auto& vectors = bench.rows(bench.unit.vectors);
    EXPECT_TRUE(test::same(vectors[row * 8 + 2 * ray + 1], packet.direction[ray])) << ray;
    if (!compressed || ray == 0) {
      EXPECT_TRUE(test::same(vectors[row * 8 + 2 * ray], packet.origin[ray])) << ray;
    }
  }
}

class Decoder : public testing::TestWithParam<bool> {
 protected:
  void record(PacketId<C> id, TransformKind kind) {
    JobRecord<C>& r = bench_.rows(bench_.unit.record)[id.to_u64()];
    r = {kind, 0b0111, uint<24>::from(0xfa0000u | 54321u), 1234};
  }
  bool compressed() const { return GetParam(); }
  UnitBench bench_;
  test::Random random_{614};
};

TEST_P(Decoder, ACamerasRaysAreSavedForTheTopLevelAndResetTheirHits) {
  const Packet packet = random_packet(random_, compressed());
  record(6, TransformKind::kCamera);
  feed(bench_, 6, packet, compressed());
  EXPECT_TRUE(test::same(bench_.take(bench_.unit.unit_ray), unit_rays(6, packet, true)));
  EXPECT_TRUE(bench_.take(bench_.unit.enter_object).empty());
  expect_saved(bench_, 0, 6, packet, compressed());
}

TEST_P(Decoder, AnObjectsRaysAreSavedForTheBottomLevelWhichIsEntered) {
  const Packet packet = random_packet(random_, compressed());
  record(1, TransformKind::kObject);
  feed(bench_, 1, packet, compressed());
  EXPECT_TRUE(bench_.take(bench_.unit.unit_ray).empty());
  TraversalEvent<C> enter;
  enter.packet = 1;
  enter.level = 1;
  enter.kind = TraversalKind::kEnter;
  enter.next = Address::from(0xfa0000u | 54321u);
  enter.active = 0b0111;
  EXPECT_TRUE(test::same(bench_.take_one(bench_.unit.enter_object), enter));
  expect_saved(bench_, 1, 1, packet, compressed());
}

TEST_P(Decoder, ATrianglesRaysAreTestedAndNotSaved) {
  const Packet packet = random_packet(random_, compressed());
  record(7, TransformKind::kTriangle);
  feed(bench_, 7, packet, compressed());
  EXPECT_TRUE(test::same(bench_.take(bench_.unit.unit_ray), unit_rays(7, packet, false)));
  EXPECT_TRUE(bench_.take(bench_.unit.enter_object).empty());
  for (auto& port : bench_.unit.ray) {
    for (const auto& ray : bench_.rows(port)) EXPECT_TRUE(test::same(ray, {}));
  }
  for (const Vec& vector : bench_.rows(bench_.unit.vectors)) EXPECT_TRUE(test::same(vector, {}));
}

INSTANTIATE_TEST_SUITE_P(Packet, Decoder, testing::Bool(), [](const auto& info) {
  return info.param ? "OfFiveVectors" : "OfEightVectors";
});

TEST(PacketDecoder, APacketAfterAnotherHasItsOwnOrigin) {
  UnitBench bench;
  test::Random random(3);
  for (unsigned n = 0; n < 200; ++n) {
    const PacketId<C> id = PacketId<C>::from(test::below(random, C::kPackets));
    bench.rows(bench.unit.record)[id.to_u64()].kind = TransformKind::kTriangle;
    const bool compressed = test::chance(random, 50);
    const Packet packet = random_packet(random, compressed);
    feed(bench, id, packet, compressed);
    ASSERT_TRUE(test::same(bench.take(bench.unit.unit_ray), unit_rays(id, packet, false)));
  }
}

using AtOnce = test::FastFromOnePoint<test::PacketsOf<test::Config<8>, 8>>;

/// Packets of few rays, and those that differ in their rays, come one after the other.
TEST(PacketDecoder, RaysOfALaneFollowEachOtherAfterThreeClocks) {
  test::UnitBench<PacketDecoder<AtOnce>> bench;
  test::Random random(57);
  for (unsigned p = 0; p < AtOnce::kPackets; ++p) {
    bench.rows(bench.unit.record)[p].kind = TransformKind::kObject;
  }
  std::array<unsigned, kRays<AtOnce>> free{};  // the clock from which a lane is
  std::array<unsigned, 3> waits{};
  unsigned clock = 3;
  for (unsigned n = 0; n < 5000; ++n) {
    PacketVector<AtOnce> vector;
    vector.ray = RayIndex<AtOnce>::from(test::below(random, n % 2 == 0 ? 8 : 3));
    bench.feed(bench.unit.vector, vector);
    bench.run();
    const TracedRay<AtOnce> traced = bench.take_one(bench.unit.traced);
    const std::uint64_t lane = vector.ray.to_u64();
    const unsigned wait = std::max(free[lane], clock) - clock;
    ASSERT_EQ(traced.repeat.to_u64(), wait) << n;
    ++waits[wait];
    free[lane] = clock + wait + 3;
    clock += wait + 1;
  }
  for (const unsigned times : waits) EXPECT_GT(times, 100u);
}

}  // namespace
}  // namespace dynrt
