// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/matrix_fetch.h"

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<>;

TEST(MatrixFetch, AsksForTheFourColumnsOfTheMatrix) {
  test::UnitBench<MatrixFetch<C>> bench;
  test::Random random(613);
  for (unsigned n = 0; n < 1000; ++n) {
    auto job = test::random_token<TransformJob<C>>(random);
    job.repeat = 3;
    for (unsigned i = 0; i < 4; ++i) {
      bench.feed(bench.unit.job, Repeated<TransformJob<C>>{RepeatCount<C>::from(i), i == 3, job});
    }
    bench.run();
    std::vector<CacheRequest<ColumnContext<C>>> expected;
    for (unsigned i = 0; i < 4; ++i) {
      expected.push_back({{job.packet, job.kind, job.active, uint<2>::from(i)},
                          Address::from(4 * job.matrix.to_u64() + i)});
    }
    ASSERT_TRUE(test::same(bench.take(bench.unit.request), expected));
  }
}

struct Compact : test::Config<> {
  static constexpr TriangleMatrix kTriangleMatrix = TriangleMatrix::kMemoryEfficient;
  static constexpr unsigned kReflections = 3;
};

TEST(MatrixFetch, TrianglesAndMirrorsBeginEveryThreeColumns) {
  test::UnitBench<MatrixFetch<Compact>> bench;
  test::Random random(614);
  for (unsigned n = 0; n < 3000; ++n) {
    auto job = test::random_token<TransformJob<Compact>>(random);
    job.kind = static_cast<TransformKind>(test::below(random, 4));
    const unsigned index = test::below(random, 4);
    const Repeated<TransformJob<Compact>> repeated{RepeatCount<C>::from(index), index == 3, job};
    bench.feed(bench.unit.job, repeated);
    bench.run();
    const bool three = job.kind == TransformKind::kTriangle ||
                       (job.kind == TransformKind::kSecondary &&
                        job.extras.derived.get().pass == Derivation::kMirror);
    const CacheRequest<ColumnContext<Compact>> expected{
        {job.packet, job.kind, job.active, uint<2>::from(index), job.extras, job.matrix},
        Address::from((three ? 3 : 4) * job.matrix.to_u64() + index)};
    ASSERT_TRUE(test::same(bench.take_one(bench.unit.request), expected));
  }
}

using WorldBoxes = test::FastFromOnePoint<test::Config<8>>;

TEST(MatrixFetch, ABoxIsOneColumnBehindTheMatrices) {
  test::UnitBench<MatrixFetch<WorldBoxes>> bench;
  bench.value(bench.unit.frame).box_column = Word(5000);
  const auto address_of = [&bench](TransformKind kind) {
    Repeated<TransformJob<WorldBoxes>> j;
    j.job.kind = kind;
    j.job.matrix = 123;
    bench.feed(bench.unit.job, j);
    bench.run();
    return bench.take_one(bench.unit.request).address;
  };
  EXPECT_EQ(address_of(TransformKind::kBox), ColumnAddress<WorldBoxes>(5123));
  EXPECT_EQ(address_of(TransformKind::kObject), ColumnAddress<WorldBoxes>(4 * 123));
  EXPECT_EQ(address_of(TransformKind::kTriangle), ColumnAddress<WorldBoxes>(4 * 123));
}

struct LitBoxes : WorldBoxes {
  static constexpr unsigned kLights = 5;
};

TEST(MatrixFetch, EachLightHasBoxesOfItsOwn) {
  test::UnitBench<MatrixFetch<LitBoxes>> bench;
  bench.value(bench.unit.frame).box_column = Word(5000);
  bench.value(bench.unit.frame).boxes_apart = Word(700);
  const auto address_of = [&bench](Derivation pass, unsigned viewpoint) {
    Repeated<TransformJob<LitBoxes>> j;
    j.job.kind = TransformKind::kBox;
    j.job.matrix = 123;
    j.job.extras.derived = DerivedRay<LitBoxes>{pass, {}};
    j.job.extras.viewpoint = Viewpoint<LitBoxes>::from(viewpoint);
    bench.feed(bench.unit.job, j);
    bench.run();
    return bench.take_one(bench.unit.request).address;
  };
  for (unsigned viewpoint = 0; viewpoint <= LitBoxes::kLights; ++viewpoint) {
    EXPECT_EQ(address_of(kBoxPass, viewpoint),
              ColumnAddress<LitBoxes>::from(5123 + 700 * viewpoint));
    EXPECT_EQ(address_of(Derivation::kLight, viewpoint), ColumnAddress<LitBoxes>(4 * 123))
        << "a light's matrix";
  }
}

}  // namespace
}  // namespace dynrt
