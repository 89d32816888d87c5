// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_lookup.h"

#include "units/test_bench.h"

namespace dynrt {
namespace {

struct Plain : test::Config<8> {
  static constexpr unsigned kPortBytes = 8;
};
struct Second : Plain {
  static constexpr unsigned kSecondLevel = 4;
  static constexpr unsigned kLineNodes = 4;
};
constexpr unsigned kNode = 5;                       ///< in the second line of the memory
constexpr unsigned kSet = kNode * kNodeBytes / 32;  ///< of its line
const auto kLine = SecondLineNumber<Second>::from(kSet);

template <class C>
MemoryRequest<C> request(MemoryKind kind, unsigned address) {
  MemoryRequest<C> r;
  r.repeat = {};
  r.kind = kind;
  r.key = 3;
  r.address = decltype(r.address)::from(address);
  return r;
}

/// A bench that looks requests up in the second level.
struct SecondBench : test::UnitBench<MemoryLookup<Second>> {
  void look_up(const MemoryRequest<Second>& r) {
    Repeated<MemoryRequest<Second>> numbered;
    numbered.job = r;
    feed(unit.request, numbered);
    run();
  }
  SecondRow<Second>& row(unsigned way) { return rows(unit.rows[way])[kSet]; }
  LastMiss<Second>& last() { return rows(unit.last_miss)[kSet]; }
};

TEST(MemoryLookup, ReadsTheBeatsThatAnItemLiesIn) {
  test::UnitBench<MemoryLookup<Plain>> bench;
  const auto expect_read = [&](MemoryKind kind, unsigned address, unsigned byte, unsigned beats) {
    const auto r = request<Plain>(kind, address);
    bench.feed(bench.unit.request, r);
    bench.run();
    const PortRead<Plain> read = bench.take_one(bench.unit.read);
    EXPECT_EQ(read.address.to_u64(), byte);
    EXPECT_EQ(read.last.to_u64() + 1, beats);
    EXPECT_TRUE(test::same(read.id, port_id(r)));
    EXPECT_EQ(bench.rows(bench.unit.in_flight)[hls::to_bits(read.id).to_u64()].address, r.address);
  };
  expect_read(MemoryKind::kNode, kNode, 8 * kNode, 1);
  expect_read(MemoryKind::kList, 7, kEntriesAt + 24, 1);  // with the entry before it
  expect_read(MemoryKind::kColumn, 3, kColumnsAt + 48, 2);
}

TEST(MemoryLookup, AMissReadsItsLineAndTakesTheNextWay) {
  SecondBench bench;
  bench.last() = {false, true, SecondLineNumber<Second>::from(kSet + 64), uint<2>(0)};
  bench.look_up(request<Second>(MemoryKind::kNode, kNode));
  const PortRead<Second> read = bench.take_one(bench.unit.read);
  EXPECT_EQ(read.address.to_u64(), 32u * kSet);
  EXPECT_EQ(read.last.to_u64() + 1, 4u);
  EXPECT_EQ(bench.rows(bench.unit.in_flight)[hls::to_bits(read.id).to_u64()].way, uint<2>(1));
  const LastMiss<Second> miss = bench.rows(bench.unit.missed)[kSet];
  EXPECT_TRUE(miss.valid);
  EXPECT_EQ(miss.line, kLine);
  EXPECT_EQ(miss.way, uint<2>(1));
}

TEST(MemoryLookup, ALineOfAnyWayIsAHit) {
  for (const unsigned way : {0u, 1u}) {
    SecondBench bench;
    bench.row(way) = {false, true, kLine, {}};
    bench.row(way).data[0] = Word::from(77 + way);
    bench.look_up(request<Second>(MemoryKind::kNode, kNode));
    EXPECT_EQ(bench.take_one(bench.unit.hit).data[0], Word::from(77 + way));
    EXPECT_TRUE(bench.take(bench.unit.read).empty());
    bench.row(way).torn = true;
    bench.look_up(request<Second>(MemoryKind::kNode, kNode));
    EXPECT_TRUE(bench.take(bench.unit.hit).empty());
    EXPECT_EQ(bench.take(bench.unit.read).size(), 1u);
  }
}

TEST(MemoryLookup, WhoseLineIsOnItsWayComesAgain) {
  SecondBench bench;
  bench.last() = {false, true, kLine, uint<2>(1)};
  auto r = request<Second>(MemoryKind::kNode, kNode);
  r.tries = 6;
  bench.look_up(r);
  EXPECT_EQ(bench.take_one(bench.unit.again).tries, uint<8>(7));
  EXPECT_TRUE(bench.take(bench.unit.read).empty());
  // A line that was replaced before it was seen is read after all.
  r.tries = uint<8>::ones();
  bench.look_up(r);
  EXPECT_TRUE(bench.take(bench.unit.again).empty());
  EXPECT_EQ(bench.take(bench.unit.read).size(), 1u);
}

TEST(MemoryLookup, AnOrderEmptiesASet) {
  SecondBench bench;
  bench.rows(bench.unit.missed)[9] = {false, true, kLine, uint<2>(1)};
  auto r = request<Second>(MemoryKind::kNode, 0);
  r.invalidate = true;
  bench.feed(bench.unit.request, {.index = 64 + 9, .job = r});  // the numbers go round
  bench.run();
  const PortLine<Second> order = bench.take_one(bench.unit.invalidate);
  EXPECT_TRUE(order.invalidate);
  EXPECT_EQ(order.set.to_u64(), 9u);
  EXPECT_FALSE(bench.rows(bench.unit.missed)[9].valid);
  EXPECT_TRUE(bench.take(bench.unit.read).empty());
}

}  // namespace
}  // namespace dynrt
