// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Which way of a set a miss replaces: the rows that the lookup reads are set by hand.
#include "units/cache_ways.h"

#include "units/cache_fill.h"
#include "units/cache_lookup.h"
#include "units/test_bench.h"

namespace dynrt {
namespace {

template <unsigned Ways>
struct Of : test::Config<8, 64> {
  static constexpr unsigned kWays = Ways;
};

/// Set 5 of a list cache; its addresses are 5 and those a multiple of kSets apart.
template <class C>
class Set {
 public:
  using Cache = ListCache<C>;
  static constexpr unsigned kSet = 5;

  Set() { bench_.value(bench_.unit.frame).line_mask = Word::from(C::kLines - 1); }
  static Address address(unsigned number) { return Address::from(number * kSets<C> + kSet); }

  void hold(unsigned way, unsigned number) {
    bench_.rows(bench_.unit.lines[way])[kSet] = {false, true, address(number), {}};
  }
  void tear(unsigned way) { bench_.rows(bench_.unit.lines[way])[kSet].torn = true; }
  UseRow<C>& use() { return bench_.rows(bench_.unit.use)[kSet]; }
  /// What the lookup has written of the use.
  UseRow<C> used() { return bench_.rows(bench_.unit.used)[kSet]; }

  /// Whether it hits.
  bool ask(unsigned number) {
    bench_.feed(bench_.unit.request, {{}, address(number)});
    bench_.run();
    const bool hit = bench_.take(bench_.unit.reply).size() == 1;
    EXPECT_EQ(bench_.take(bench_.unit.miss).size(), hit ? 0u : 1u);
    use() = used();
    return hit;
  }
  /// The way that a miss takes.
  unsigned taken_by(unsigned number) {
    EXPECT_FALSE(ask(number));
    const auto key = Cache::key({}).to_u64();
    return static_cast<unsigned>(bench_.rows(bench_.unit.waiting)[key].way.to_u64());
  }

 private:
  test::UnitBench<CacheLookup<C, Cache>> bench_;
};

template <class C>
class CacheWays : public testing::Test {
 protected:
  static constexpr unsigned kWays = C::kWays;
  /// Each way gets the line that has its number.
  static void fill(Set<C>& set) {
    for (unsigned way = 0; way < kWays; ++way) {
      EXPECT_EQ(set.taken_by(way), way);
      set.hold(way, way);
    }
  }
};
using SomeWays = testing::Types<Of<2>, Of<4>>;
TYPED_TEST_SUITE(CacheWays, SomeWays);

TYPED_TEST(CacheWays, EachHoldsALine) {
  Set<TypeParam> set;
  this->fill(set);
  for (unsigned way = 0; way < this->kWays; ++way) EXPECT_TRUE(set.ask(way));
}

TYPED_TEST(CacheWays, TheOldestIsReplaced) {
  Set<TypeParam> set;
  this->fill(set);
  for (unsigned turn = 0; turn < 2 * this->kWays; ++turn) {
    const unsigned way = set.taken_by(10 + turn);
    // The tree goes from half to half: 0 2 1 3.
    EXPECT_EQ(way, this->kWays == 2 ? turn % 2 : turn % 2 * 2 + turn / 2 % 2);
    set.hold(way, 10 + turn);
  }
}

TYPED_TEST(CacheWays, ALineThatIsUsedStays) {
  for (unsigned kept = 0; kept < this->kWays; ++kept) {
    Set<TypeParam> set;
    this->fill(set);
    for (unsigned number = 10; number < 30; ++number) {
      EXPECT_TRUE(set.ask(kept));
      const unsigned way = set.taken_by(number);
      EXPECT_NE(way, kept);
      set.hold(way, number);
    }
  }
}

TYPED_TEST(CacheWays, ATornLineIsReplacedFirst) {
  Set<TypeParam> set;
  this->fill(set);
  set.tear(1);
  EXPECT_EQ(set.taken_by(10), 1u);
}

TYPED_TEST(CacheWays, UseOfAnEarlierFrameDoesNotCount) {
  test::Random random(1);
  for (unsigned run = 0; run < 200; ++run) {
    const bool full = run % 2 == 0, hit = test::chance(random, 50);
    std::vector<UseRow<TypeParam>> written;
    std::vector<unsigned> taken;
    for (unsigned i = 0; i < 2; ++i) {
      Set<TypeParam> set;
      for (unsigned way = 0; way < (full ? this->kWays : 1); ++way) set.hold(way, way);
      set.use() = test::random_token<UseRow<TypeParam>>(random);
      set.use().torn = full;
      if (hit) {
        EXPECT_TRUE(set.ask(0));
      } else {
        taken.push_back(set.taken_by(100));
      }
      written.push_back(set.used());
    }
    if (!hit) EXPECT_EQ(taken[0], taken[1]);
    EXPECT_TRUE(test::same(written[0], written[1]));
  }
}

struct Pointers : Of<2> {
  static constexpr Datapath kDatapath = Datapath::kFast;
};

TEST(CacheWaysOfNodes, APointerToAListIsNoUse) {
  test::UnitBench<CacheLookup<Pointers, NodeCache<Pointers>>> bench;
  bench.value(bench.unit.frame).line_mask = Word::from(Pointers::kLines - 1);
  for (const bool is_list : {true, false}) {
    bench.feed(bench.unit.request, {{}, Address::from(is_list ? 1u << (kAddressBits - 1) : 0u)});
    bench.run();
    EXPECT_EQ(bench.take(bench.unit.reply).size(), is_list ? 1u : 0u);
    EXPECT_EQ(bench.rows(bench.unit.used)[0].tree.bits.to_u64(), is_list ? 0u : 1u);
  }
}

}  // namespace
}  // namespace dynrt
