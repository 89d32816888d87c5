// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/matrix_store.h"

#include <utility>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using Bench = test::Bench<MatrixStore<C>>;

struct Job {
  TransformKind kind;
  RayMask active;
  unsigned matrix;
  std::array<MatrixColumn, 4> columns;
  std::array<unsigned, 4> order;
  unsigned sent = 0;

  explicit Job(test::Random& random)
      : kind(static_cast<TransformKind>(test::below(random, 3))),
        active(test::random_token<RayMask>(random)),
        matrix(test::below(random, kMaxMatrices)),
        columns(test::random_token<std::array<MatrixColumn, 4>>(random)),
        order{0, 1, 2, 3} {
    for (unsigned i = 3; i > 0; --i) std::swap(order[i], order[test::below(random, i + 1)]);
  }
};

void send(Bench& bench, unsigned packet, Job& job) {
  const unsigned column = job.order[job.sent++];
  const ColumnContext<C> context{PacketId<C>::from(packet), job.kind, job.active,
                                 uint<2>::from(column)};
  bench.feed(bench.unit.reply,
             CacheReply<ColumnContext<C>, MatrixColumn>{
                 context, Address::from(4u * job.matrix + column), job.columns[column]});
  bench.run();
}

TEST(MatrixStore, TakesTheColumnsOfManyPacketsInAnyOrder) {
  Bench bench;
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
    const SendJob<C> ready{uncompressed ? RepeatCount(7) : RepeatCount(4), PacketId<C>::from(p),
                           job.kind};
    ASSERT_TRUE(test::same(bench.take_one(bench.unit.ready), ready));
    for (unsigned c = 0; c < 4; ++c) {
      const auto& row = job.columns[c].row;
      const Vector<Real> values{row[0].value, row[1].value, row[2].value};
      ASSERT_TRUE(test::same(bench.rows(bench.unit.column[c])[p], values)) << "column " << c;
    }
    const auto& spare = job.columns[0].row;
    const std::uint64_t extra =
        spare[0].spare.to_u64() | spare[1].spare.to_u64() << 8 | spare[2].spare.to_u64() << 16;
    const JobRecord<C> record{job.kind, job.active, MatrixIndex::from(job.matrix),
                              uint<24>::from(extra)};
    ASSERT_TRUE(test::same(bench.rows(bench.unit.record)[p], record));
    if (job.kind == TransformKind::kObject) objects[p] = record.matrix;
    ASSERT_EQ(bench.rows(bench.unit.object)[p], objects[p]) << "a triangle is not an object";
    job = Job(random);
  }
  EXPECT_GT(extra_last, 1000u) << "the spare bytes may come with the last column";
}

}  // namespace
}  // namespace dynrt
