// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_interface.h"

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<MemoryInterface<C>>;

void fill_banks(UnitBench& bench) {
  test::Random random(6);
  for (unsigned i = 0; i < kSceneBanks; ++i) {
    for (Word& word : bench.rows(bench.unit.bank[i])) word = Word::from(random.next());
  }
}
/// The words of a token, as the host packs them.
template <class T>
std::vector<std::uint64_t> words(const T& token) {
  const auto packed = hls::pack(token);
  return {packed.begin(), packed.end()};
}

TEST(MemoryInterface, ReadsEveryKindFromItsBanks) {
  UnitBench bench;
  fill_banks(bench);
  test::Random random(7);
  unsigned counts[3] = {};
  for (unsigned n = 0; n < 20'000; ++n) {
    auto r = test::random_token<MemoryRequest<C>>(random);
    r.kind = static_cast<MemoryKind>(test::below(random, 3));
    if (n < 6) r.address = n % 2 == 0 ? Address(0) : Address::ones();
    if (n < 6) r.kind = static_cast<MemoryKind>(n / 2);
    bench.feed(bench.unit.request, r);
    bench.run();
    const std::uint64_t a = r.address.to_u64();
    const auto bank = [&](unsigned i, std::uint64_t word) {
      return bench.rows(bench.unit.bank[i])[word].to_u64();
    };
    const auto check = [&](auto& port, const std::vector<std::uint64_t>& expected) {
      const auto fill = bench.take_one(port);
      ASSERT_FALSE(fill.invalidate);
      ASSERT_EQ(fill.key, r.key);
      ASSERT_EQ(fill.address, r.address);
      ASSERT_EQ(words(fill.line), expected);
    };
    ++counts[static_cast<unsigned>(r.kind)];
    switch (r.kind) {
      case MemoryKind::kNode:
        check(bench.unit.node, {bank(0, a), bank(1, a)});
        break;
      case MemoryKind::kList:
        check(bench.unit.list, {bank(2, a)});
        break;
      case MemoryKind::kColumn:
        check(bench.unit.column,
              {bank(0, kColumnBase + a), bank(1, kColumnBase + a), bank(2, kColumnBase + a)});
        break;
    }
    ASSERT_TRUE(bench.take(bench.unit.node).empty());
    ASSERT_TRUE(bench.take(bench.unit.list).empty());
    ASSERT_TRUE(bench.take(bench.unit.column).empty());
  }
  for (const unsigned count : counts) EXPECT_GT(count, 1000u);
}

template <class R>
class MemoryOf : public testing::Test {};
using Floats = testing::Types<hls::Float<5, 8>, Real, hls::Float<7, 18>, hls::Float<8, 23>>;
TYPED_TEST_SUITE(MemoryOf, Floats);

/// Whatever the float, nodes, entries and columns lie in the lowest bits of their words.
TYPED_TEST(MemoryOf, TheFloatIsItsFields) {
  using In = test::Config<8, 512, 31, 8, TypeParam>;
  using Scene = SceneWord<TypeParam>;
  test::UnitBench<MemoryInterface<In>> bench;
  const auto row = [&](unsigned bank, unsigned word) -> Scene& {
    return bench.rows(bench.unit.bank[bank])[word];
  };
  const auto ask = [&](MemoryKind kind) {
    bench.feed(bench.unit.request, MemoryRequest<In>{.kind = kind, .key = 3, .address = 11});
    bench.run();
  };
  const Node<TypeParam> node{NodeKind::kSplitZ, TypeParam::from_double(-2.5), 345678, 98765};
  const auto bits = hls::to_bits(node).template zext<2 * Scene::kWidth>();
  row(0, 11) = bits.template trunc<Scene::kWidth>();
  row(1, 11) = bits.template bits<2 * Scene::kWidth - 1, Scene::kWidth>();
  ask(MemoryKind::kNode);
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.node),
                         CacheLine<In, Node<TypeParam>>{false, 3, 11, node}));

  const ListEntry entry{4711, 5, true};
  row(2, 11) = hls::to_bits(entry);
  ask(MemoryKind::kList);
  EXPECT_TRUE(
      test::same(bench.take_one(bench.unit.list), CacheLine<In, ListEntry>{false, 3, 11, entry}));

  test::Random random(8);
  const auto column = test::random_token<MatrixColumn<TypeParam>>(random);
  for (unsigned r = 0; r < 3; ++r) row(r, kColumnBase + 11) = hls::to_bits(column.row[r]);
  ask(MemoryKind::kColumn);
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.column),
                         CacheLine<In, MatrixColumn<TypeParam>>{false, 3, 11, column}));
}

struct Narrow : C {
  static constexpr unsigned kAddressBits = 8;
  static constexpr unsigned kMatrixBits = 5;
  static constexpr Primitives kPrimitives{.triangle = true, .sphere = true};
};

TEST(MemoryInterface, NarrowsNumbersToThoseOfTheCore) {
  test::UnitBench<MemoryInterface<Narrow>> bench;
  const auto row = [&](unsigned bank, unsigned word) -> SceneWord<Real>& {
    return bench.rows(bench.unit.bank[bank])[word];
  };
  const auto ask = [&](MemoryKind kind, unsigned address) {
    MemoryRequest<Narrow> request{.kind = kind, .key = 3, .address = {}};
    request.address = decltype(request.address)::from(address);
    bench.feed(bench.unit.request, request);
    bench.run();
  };
  const auto bits = hls::to_bits(Node<Real>{NodeKind::kSplitY, Real::one(), 255, 17});
  row(0, 200) = bits.trunc<32>();
  row(1, 200) = bits.bits<63, 32>();
  ask(MemoryKind::kNode, 200);
  EXPECT_TRUE(
      test::same(bench.take_one(bench.unit.node),
                 NodeLine<Narrow>{false, 3, 200, {NodeKind::kSplitY, Real::one(), 255, 17}}));

  ListEntry entry{31, 0, true};
  entry.set_primitive(Primitive::kSphere);
  row(2, 255) = hls::to_bits(entry);
  ask(MemoryKind::kList, 255);
  EXPECT_TRUE(test::same(bench.take_one(bench.unit.list),
                         ListLine<Narrow>{false, 3, 255, {31, Primitive::kSphere, true}}));

  for (unsigned r = 0; r < 3; ++r) row(r, kColumnBase + 127) = Word::from(r);
  ask(MemoryKind::kColumn, 127);
  const ColumnLine<Narrow> column = bench.take_one(bench.unit.column);
  EXPECT_EQ(column.address, ColumnAddress<Narrow>(127)) << "column 3 of the last matrix";
  EXPECT_EQ(hls::to_bits(column.line.row[2]), Word(2));
}

}  // namespace
}  // namespace dynrt
