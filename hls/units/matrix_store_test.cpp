// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/matrix_store.h"

#include <utility>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<MatrixStore<C>>;

struct Job {
  TransformKind kind;
  RayMask<C> active;
  unsigned matrix;
  std::array<MatrixColumn<Real>, 4> columns;
  std::array<unsigned, 4> order;
  unsigned sent = 0;

  explicit Job(test::Random& random)
      : kind(static_cast<TransformKind>(test::below(random, 3))),
        active(test::random_token<RayMask<C>>(random)),
        matrix(test::below(random, kMaxMatrices)),
        columns(test::random_token<std::array<MatrixColumn<Real>, 4>>(random)),
        order{0, 1, 2, 3} {
    for (unsigned i = 3; i > 0; --i) std::swap(order[i], order[test::below(random, i + 1)]);
  }
};

void send(UnitBench& bench, unsigned packet, Job& job) {
  const unsigned column = job.order[job.sent++];
  const ColumnContext<C> context{PacketId<C>::from(packet), job.kind, job.active,
                                 uint<2>::from(column)};
  bench.feed(bench.unit.reply,
             CacheReply<ColumnContext<C>, MatrixColumn<Real>>{
                 context, Address::from(4u * job.matrix + column), job.columns[column]});
  bench.run();
}

TEST(MatrixStore, TakesTheColumnsOfManyPacketsInAnyOrder) {
  UnitBench bench;
  test::Random random(45);
  std::vector<Job> jobs;
  MatrixIndex objects[C::kPackets];
  for (unsigned p = 0; p < C::kPackets; ++p) jobs.emplace_back(random);
  unsigned complete = 0, extra_last = 0;
  while (complete < 20'000) {
    const bool uncompressed = complete >= 10'000;
    bench.value(bench.unit.frame).uncompressed = Word::from(uncompressed);
    const unsigned p = test::below(random, C::kPackets);
    Job& job = jobs[p];
    send(bench, p, job);
    if (job.sent < 4) {
      ASSERT_TRUE(bench.take(bench.unit.ready).empty());
      continue;
    }
    ++complete;
    extra_last += job.order[3] == 0;
    const SendJob<C> ready{uncompressed ? RepeatCount<C>(7) : RepeatCount<C>(4),
                           PacketId<C>::from(p), job.kind};
    ASSERT_TRUE(test::same(bench.take_one(bench.unit.ready), ready));
    for (unsigned c = 0; c < 4; ++c) {
      const auto& row = job.columns[c].row;
      const Vector<Real> values{row[0].value, row[1].value, row[2].value};
      ASSERT_TRUE(test::same(bench.rows(bench.unit.column[c])[p], values)) << "column " << c;
    }
    const auto& spare = job.columns[0].row;
    const std::uint64_t extra =
        spare[0].spare.to_u64() | spare[1].spare.to_u64() << 8 | spare[2].spare.to_u64() << 16;
    const JobRecord<C> record{job.kind, job.active, uint<24>::from(extra),
                              MatrixIndex::from(job.matrix)};
    ASSERT_TRUE(test::same(bench.rows(bench.unit.record)[p], record));
    if (job.kind == TransformKind::kObject) objects[p] = record.matrix;
    ASSERT_EQ(bench.rows(bench.unit.object)[p], objects[p]) << "a triangle is not an object";
    job = Job(random);
  }
  EXPECT_GT(extra_last, 1000u) << "the spare bytes may come with the last column";
}

struct Compact : C {
  static constexpr TriangleMatrix kTriangleMatrix = TriangleMatrix::kMemoryEfficient;
  static constexpr Primitives kPrimitives{.triangle = true, .sphere = true};
  static constexpr unsigned kReflections = 1;
};

/// Triangles in three columns among spheres and objects in four, their columns in any order.
TEST(MatrixStore, ExpandsTrianglesToFourColumns) {
  test::UnitBench<MatrixStore<Compact>> bench;
  test::Random random(511);
  std::array<unsigned, 3> seen{};
  for (unsigned n = 0; n < 3000; ++n) {
    ColumnContext<Compact> context;
    context.packet = PacketId<Compact>::from(test::below(random, Compact::kPackets));
    context.kind = test::chance(random, 70) ? TransformKind::kTriangle : TransformKind::kObject;
    context.extras.primitive = test::chance(random, 70) ? Primitive::kTriangle : Primitive::kSphere;
    context.matrix = MatrixIndex::from(test::below(random, kMaxMatrices));
    const bool three = context.kind == TransformKind::kTriangle &&
                       context.extras.primitive.get() == Primitive::kTriangle;
    const unsigned ones = test::below(random, 3);
    auto columns = test::random_token<std::array<MatrixColumn<Real>, 4>>(random);
    if (three) columns[0].row[2].spare = columns[1].row[2].spare = uint<8>::from(ones);
    std::vector<unsigned> order = three ? std::vector{0u, 1u, 2u} : std::vector{0u, 1u, 2u, 3u};
    for (std::size_t i = order.size() - 1; i > 0; --i) {
      std::swap(order[i], order[test::below(random, static_cast<unsigned>(i) + 1)]);
    }
    for (const unsigned column : order) {
      EXPECT_TRUE(bench.take(bench.unit.ready).empty());
      context.column = uint<2>::from(column);
      bench.feed(bench.unit.reply,
                 CacheReply<ColumnContext<Compact>, MatrixColumn<Real>>{
                     context, test::random_token<Address>(random), columns[column]});
      bench.run();
    }
    bench.take_one(bench.unit.ready);
    std::array<Vector<Real>, 4> expected;
    const auto values = [&](unsigned c) {
      const auto& row = columns[c].row;
      return Vector<Real>{row[0].value, row[1].value, row[2].value};
    };
    if (three) {
      const Real one = Real::one();
      expected[ones] = {one, one, one};
      expected[ones == 0 ? 1 : 0] = values(0);
      expected[ones == 2 ? 1 : 2] = values(1);
      expected[3] = values(2);
      ++seen[ones];
    } else {
      for (unsigned c = 0; c < 4; ++c) expected[c] = values(c);
    }
    const std::uint64_t packet = context.packet.to_u64();
    for (unsigned c = 0; c < 4; ++c) {
      ASSERT_TRUE(test::same(bench.rows(bench.unit.column[c])[packet], expected[c])) << c;
    }
    const auto spare = [&](unsigned c, unsigned r) { return columns[c].row[r].spare; };
    JobRecord<Compact> record;
    record.kind = context.kind;
    record.matrix = context.matrix.get();
    record.extra =
        hls::concat(three ? spare(1, 1) : spare(0, 2), hls::concat(spare(0, 1), spare(0, 0)));
    record.mirror = spare(1, 0);
    record.primitive = context.extras.primitive;
    record.cosine_factor = Real::from_bits(columns[three ? 2 : 3].spare());
    ASSERT_TRUE(test::same(bench.rows(bench.unit.record)[packet], record));
  }
  for (const unsigned count : seen) EXPECT_GT(count, 100u);
}

using WorldBoxes = test::FastFromOnePoint<test::PacketsOf<test::Config<8>, 8>>;

/// The box comes alone, between the matrices of its packet.
TEST(MatrixStore, PassesAnObjectsBoxOnToItsTest) {
  using Reply = ColumnReply<WorldBoxes>;
  test::UnitBench<MatrixStore<WorldBoxes>> bench;
  test::Random random(8);
  constexpr unsigned kFirstBox = 5000, kPacket = 3;
  bench.value(bench.unit.frame).box_column = Word(kFirstBox);
  const auto send = [&](TransformKind kind, RayMask<WorldBoxes> active, unsigned column,
                        unsigned address) {
    Reply reply = test::random_token<Reply>(random);
    reply.context.packet = kPacket;
    reply.context.kind = kind;
    reply.context.active = active;
    reply.context.column = uint<2>::from(column);
    reply.address = ColumnAddress<WorldBoxes>::from(address);
    bench.feed(bench.unit.reply, reply);
    bench.run();
    return reply;
  };
  for (unsigned round = 0; round < 3; ++round) {
    const Reply box = send(TransformKind::kBox, 0b10110000, 0, kFirstBox + 1234);
    EXPECT_TRUE(bench.take(bench.unit.ready).empty());
    const BoxJob<WorldBoxes> job = bench.take_one(bench.unit.box);
    EXPECT_TRUE(test::same(job, BoxJob<WorldBoxes>{RepeatCount<WorldBoxes>(2), kPacket}));
    const BoxedObject<WorldBoxes>& boxed = bench.rows(bench.unit.boxed)[kPacket];
    EXPECT_EQ(boxed.matrix, MatrixNumber<WorldBoxes>(1234));
    EXPECT_EQ(boxed.rays, RayMask<WorldBoxes>(0b10110000));
    EXPECT_TRUE(test::same(boxed.slabs, slabs_of(box.line)));
    for (unsigned column = 0; column < 4; ++column) {
      EXPECT_TRUE(bench.take(bench.unit.ready).empty()) << "the box is no column of the matrix";
      send(TransformKind::kObject, 0b10000000, column, 4 * 1234 + column);
    }
    EXPECT_EQ(bench.take_one(bench.unit.ready).kind, TransformKind::kObject);
    EXPECT_EQ(bench.rows(bench.unit.object)[kPacket], MatrixNumber<WorldBoxes>(1234));
    EXPECT_TRUE(bench.take(bench.unit.box).empty());
  }
}

struct LitBoxes : WorldBoxes {
  static constexpr unsigned kLights = 3;
};

/// Of the rays to a light, those that have hit something are made beside the transformation.
TEST(MatrixStore, TellsALightsMatrixFromABoxForItsRays) {
  using Reply = ColumnReply<LitBoxes>;
  test::UnitBench<MatrixStore<LitBoxes>> bench;
  constexpr unsigned kFirstBox = 5000, kApart = 700, kPacket = 3, kLight = 2;
  bench.value(bench.unit.frame).box_column = Word(kFirstBox);
  bench.value(bench.unit.frame).boxes_apart = Word(kApart);
  const auto send = [&](Derivation pass, unsigned column, unsigned address) {
    Reply reply;
    reply.context.packet = kPacket;
    reply.context.kind = TransformKind::kSecondary;
    reply.context.active = 0b10110000;
    reply.context.column = uint<2>::from(column);
    reply.context.extras.derived = DerivedRay<LitBoxes>{pass, {}};
    reply.context.extras.viewpoint = Viewpoint<LitBoxes>(kLight);
    reply.address = ColumnAddress<LitBoxes>::from(address);
    bench.feed(bench.unit.reply, reply);
    bench.run();
  };
  for (unsigned round = 0; round < 2; ++round) {
    send(kBoxPass, 0, kFirstBox + kLight * kApart + 1234);
    EXPECT_EQ(bench.take_one(bench.unit.box).packet, PacketId<LitBoxes>(kPacket));
    EXPECT_EQ(bench.rows(bench.unit.boxed)[kPacket].matrix, MatrixNumber<LitBoxes>(1234));
    for (unsigned column = 0; column < 4; ++column) {
      EXPECT_TRUE(bench.take(bench.unit.camera).empty());
      send(Derivation::kLight, column, 4 * 77 + column);
    }
    const CameraJob<LitBoxes> rays = bench.take_one(bench.unit.camera);
    EXPECT_EQ(rays.repeat, RepeatCount<LitBoxes>(3 * 3 - 1));
    EXPECT_TRUE(rays.to_light.get());
    EXPECT_EQ(rays.lit.get(), RayMask<LitBoxes>(0b10110000));
    EXPECT_EQ(bench.rows(bench.unit.record)[kPacket].viewpoint.get(), Viewpoint<LitBoxes>(kLight));
    EXPECT_TRUE(bench.take(bench.unit.ready).empty());
    EXPECT_TRUE(bench.take(bench.unit.box).empty());
  }
}

/// Every packet of a frame has the camera's columns, so one row holds them; a light's origin is the
/// packet's own.
TEST(MatrixStore, KeepsTheCameraOnceAndAnEyeForEachPacket) {
  test::UnitBench<MatrixStore<LitBoxes>> bench;
  test::Random random(16);
  const auto send = [&](unsigned packet, TransformKind kind, unsigned column) {
    ColumnReply<LitBoxes> reply;
    reply.context.packet = PacketId<LitBoxes>::from(packet);
    reply.context.kind = kind;
    reply.context.column = uint<2>::from(column);
    reply.context.extras.derived = DerivedRay<LitBoxes>{Derivation::kLight, {}};
    reply.line = test::random_token<MatrixColumn<Real>>(random);
    bench.feed(bench.unit.reply, reply);
    bench.run();
    return Vector<Real>{reply.line.row[0].value, reply.line.row[1].value, reply.line.row[2].value};
  };
  std::array<Vector<Real>, 4> camera, light;
  for (unsigned c = 0; c < 4; ++c) camera[c] = send(2, TransformKind::kCamera, c);
  for (unsigned c = 0; c < 4; ++c) light[c] = send(5, TransformKind::kSecondary, c);
  for (unsigned c = 0; c < 4; ++c) send(7, TransformKind::kTriangle, c);
  for (unsigned c = 0; c < 3; ++c) {
    EXPECT_TRUE(test::same(bench.rows(bench.unit.camera_column[c])[0], camera[c])) << c;
  }
  EXPECT_TRUE(test::same(bench.rows(bench.unit.eye)[2], camera[3]));
  EXPECT_TRUE(test::same(bench.rows(bench.unit.eye)[5], light[3]));
  EXPECT_TRUE(test::same(bench.rows(bench.unit.eye)[7], {})) << "no ray starts at a triangle";
}

/// The bounds lie in the words where the host puts them: the lower one in the lowest bits.
TEST(MatrixStore, ReadsTwoBoundsOfEveryWord) {
  MatrixColumn<Real> column;
  const Bound<Real> low = Bound<Real>::from_double(-1.5), high = Bound<Real>::from_double(0.75);
  const auto bits = hls::concat(high.bits(), low.bits());
  column.row[1].value = Real::from_bits(bits.trunc<Real::kLeafWidth>());
  column.row[1].spare = bits.bits<31, 24>();
  const WorldBoxSlabs<Real> slabs = slabs_of(column);
  EXPECT_EQ(slabs[1].low, low);
  EXPECT_EQ(slabs[1].high, high);
}

}  // namespace
}  // namespace dynrt
