// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/startup.h"

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<64, 512>;

void check(unsigned packets, unsigned lines) {
  SCOPED_TRACE(testing::Message() << packets << " packets, " << lines << " lines");
  test::UnitBench<Startup<C>> bench;
  for (unsigned n = 0; n < lines; ++n) bench.feed(bench.unit.number, uint<10>::from(n));
  for (unsigned n = 0; n < packets; ++n) {
    bench.feed(bench.unit.number, uint<10>::from(kFirstPacket + n));
  }
  bench.run();
  EXPECT_EQ(bench.transactions(), lines + packets);

  std::vector<FreePacket<C>> free;
  for (unsigned n = 0; n < packets; ++n) free.push_back({PacketId<C>::from(n)});
  std::vector<CacheLine<C, Node<Real>>> nodes;
  std::vector<CacheLine<C, ListEntry>> entries;
  std::vector<CacheLine<C, MatrixColumn<Real>>> columns;
  for (unsigned n = 0; n < lines; ++n) {
    nodes.push_back({true, {}, Address::from(n), {}});
    entries.push_back({true, {}, Address::from(n), {}});
    columns.push_back({true, {}, Address::from(n), {}});
  }
  EXPECT_TRUE(test::same(bench.take(bench.unit.free), free));
  EXPECT_TRUE(test::same(bench.take(bench.unit.node), nodes));
  EXPECT_TRUE(test::same(bench.take(bench.unit.list), entries));
  EXPECT_TRUE(test::same(bench.take(bench.unit.column), columns));
}

TEST(Startup, InvalidatesLinesAndFreesPackets) {
  for (const unsigned packets : {1, 3, 32, 64}) {
    for (unsigned lines = 1; lines <= 512; lines *= 2) check(packets, lines);
  }
}

}  // namespace
}  // namespace dynrt
