// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The looking and the filling half of a cache, joined as the core joins them, with a memory whose
// answers come late and in any order.
#include "units/cache_lookup.h"

#include "units/cache_fill.h"
#include "units/test_bench.h"

namespace dynrt {
namespace {

template <unsigned Lines, unsigned Ways = 1, unsigned Nodes = 1>
struct Of : test::Config<8, Lines> {
  static constexpr unsigned kWays = Ways;
  static constexpr unsigned kLineNodes = Nodes;
};

/// Lookup and fill share lines and waiting contexts.
template <class C, class Kind>
class Cache {
 public:
  using Line = Items<typename Kind::Line, Kind::kItems>;
  using Reply = typename Kind::Reply;
  using Request = CacheRequest<typename Kind::Context>;

  explicit Cache(unsigned lines) {
    join_.unit("lookup", "lookup", lookup_);
    join_.unit("fill", "fill", fill_);
    frame_->line_mask = Word::from(lines - 1);
    join_.config<FrameRegisters<C>>("frame", frame_, {&lookup_.frame, &fill_.frame});
    join_.input("request", lookup_.request);
    join_.input("fill", fill_.fill);
    hit_ = join_.output("hit", lookup_.reply);
    filled_ = join_.output("filled", fill_.reply);
    miss_ = join_.output("miss", lookup_.miss);
    for (unsigned i = 0; i < C::kWays; ++i) {
      join_.ram<hls::Hazard::kTorn>("lines", port_of<C::kWays>(fill_.lines, i),
                                    std::array{&port_of<C::kWays>(lookup_.lines, i)});
    }
    join_.ram("waiting", lookup_.waiting, std::array{&fill_.waiting});
    if constexpr (kHasWays<C>) {
      join_.ram<hls::Hazard::kTorn>("use", lookup_.used, std::array{&lookup_.use});
    }
  }
  void request(const Request& r) {
    lookup_.request.queue()->push(r);
    join_.run();
  }
  void fill(const CacheLine<C, Line>& f) {
    fill_.fill.queue()->push(f);
    join_.run();
  }
  std::vector<Reply> hits() { return all(*hit_); }
  std::vector<Reply> filled() { return all(*filled_); }
  std::vector<MemoryRequest<C>> misses() { return all(*miss_); }

 private:
  template <class T>
  static std::vector<T> all(hls::Fifo<T>& queue) {
    std::vector<T> tokens;
    while (!queue.empty()) tokens.push_back(queue.pop());
    return tokens;
  }
  CacheLookup<C, Kind> lookup_;
  CacheFill<C, Kind> fill_;
  std::shared_ptr<FrameRegisters<C>> frame_ = std::make_shared<FrameRegisters<C>>();
  hls::Join join_;
  std::shared_ptr<hls::Fifo<Reply>> hit_, filled_;
  std::shared_ptr<hls::Fifo<MemoryRequest<C>>> miss_;
};

/// What lies at an address: no two addresses hold the same.
template <class Line>
Line memory(std::uint64_t address) {
  test::Random random(address);
  Line line{};
  hls::for_each_leaf(line, [&]<class L>(L& leaf, unsigned) {
    leaf = hls::leaf_from_bits<L>(
        uint<hls::bit_width_of<L>()>::from(random.next() << kAddressBits ^ address));
  });
  return line;
}

/// The line of a cache that it lies in.
template <class Kind>
auto line_at(std::uint64_t address) {
  return items_of<Kind::kItems>([address](unsigned i) {
    return memory<typename Kind::Line>(address / Kind::kItems * Kind::kItems + i);
  });
}

struct Counts {
  unsigned hits = 0, misses = 0;
};

/// Random requests of as many clients as there are keys; the memory answers when it likes.
template <class C, class Kind>
Counts run(unsigned lines, unsigned addresses, unsigned requests) {
  using Context = typename Kind::Context;
  Cache<C, Kind> cache(lines);
  test::Random random(lines);
  struct Client {
    bool waits = false;
    Context context;
  };
  std::vector<Client> clients(kCacheKeys<Kind>);
  std::vector<MemoryRequest<C>> pending;
  Counts counts;
  const auto answer_one = [&] {
    const std::size_t i = test::below(random, static_cast<unsigned>(pending.size()));
    const MemoryRequest<C> r = pending[i];
    pending.erase(pending.begin() + static_cast<std::ptrdiff_t>(i));
    cache.fill({false, r.key, r.address, line_at<Kind>(r.address.to_u64())});
    const auto line = memory<typename Kind::Line>(r.address.to_u64());
    Client& client = clients[r.key.to_u64()];
    const auto replies = cache.filled();
    ASSERT_EQ(replies.size(), 1u);
    ASSERT_TRUE(test::same(replies[0], Kind::reply(client.context, r.address, line)));
    client.waits = false;
  };
  while (counts.hits + counts.misses < requests) {
    if (!pending.empty() && test::chance(random, 40)) answer_one();
    auto context = test::random_token<Context>(random);
    const unsigned key = static_cast<unsigned>(Kind::key(context).to_u64());
    if (clients[key].waits) continue;
    const Address address = Address::from(test::below(random, addresses));
    clients[key].context = context;
    cache.request({context, address});
    const auto hits = cache.hits();
    const auto misses = cache.misses();
    EXPECT_EQ(hits.size() + misses.size(), 1u);
    for (const auto& reply : hits) {
      ++counts.hits;
      const auto line = memory<typename Kind::Line>(address.to_u64());
      EXPECT_TRUE(test::same(reply, Kind::reply(context, address, line)));
    }
    for (const MemoryRequest<C>& miss : misses) {
      ++counts.misses;
      clients[key].waits = true;
      EXPECT_TRUE(
          test::same(miss, {.kind = Kind::kKind, .key = Kind::key(context), .address = address}));
      pending.push_back(miss);
    }
    if (testing::Test::HasFailure()) break;
  }
  return counts;
}

template <class C>
void expect_the_data_of_each_line() {
  for (unsigned lines = C::kWays * kEntriesOfLine<C>; lines <= 512; lines *= 2) {
    SCOPED_TRACE(testing::Message() << lines << " lines");
    for (const Counts& counts : {run<C, NodeCache<C>>(lines, 3 * lines, 4000),
                                 run<C, ListCache<C>>(lines, 3 * lines, 4000),
                                 run<C, MatrixCache<C>>(lines, 3 * lines, 4000)}) {
      EXPECT_GT(counts.hits, 300u);
      EXPECT_GT(counts.misses, 1000u);
    }
  }
}

TEST(CacheLookup, NeverDeliversAnotherLinesData) { expect_the_data_of_each_line<Of<512>>(); }
TEST(CacheLookup, NeverDeliversAnotherLinesDataOfTwoWays) {
  expect_the_data_of_each_line<Of<512, 2>>();
}
TEST(CacheLookup, NeverDeliversAnotherLinesDataOfFourWays) {
  expect_the_data_of_each_line<Of<512, 4>>();
}

TEST(CacheLookup, NeverDeliversAnotherItemsData) {
  expect_the_data_of_each_line<Of<512, 1, 2>>();
  expect_the_data_of_each_line<Of<512, 2, 2>>();
  expect_the_data_of_each_line<Of<512, 4, 8>>();
}

TEST(CacheLookup, ALineIsFetchedOnceForAllItsItems) {
  using C = Of<16, 1, 4>;
  using Kind = ListCache<C>;
  static_assert(Kind::kItems == 8);
  Cache<C, Kind> cache(16);
  cache.request({{}, Address(13)});
  const auto misses = cache.misses();
  ASSERT_EQ(misses.size(), 1u);
  EXPECT_EQ(misses[0].address, Address(13));
  cache.fill({false, misses[0].key, misses[0].address, line_at<Kind>(13)});
  for (unsigned address = 8; address < 16; ++address) {
    cache.request({{}, Address::from(address)});
    const auto hits = cache.hits();
    ASSERT_EQ(hits.size(), 1u) << address;
    EXPECT_TRUE(test::same(hits[0].entry, memory<CoreListEntry<C>>(address)));
  }
  for (const unsigned beside : {7, 16}) {
    cache.request({{}, Address::from(beside)});
    EXPECT_TRUE(cache.hits().empty()) << beside;
  }
}

TEST(CacheLookup, ACoreMayHaveFewerLines) {
  run<Of<1>, NodeCache<Of<1>>>(1, 3, 2000);
  run<Of<2>, MatrixCache<Of<2>>>(1, 3, 2000);
  run<Of<64>, ListCache<Of<64>>>(64, 200, 2000);
  run<Of<2, 2>, NodeCache<Of<2, 2>>>(2, 6, 2000);
  run<Of<8, 4>, MatrixCache<Of<8, 4>>>(4, 12, 2000);
}

template <class C>
void expect_all_lines_in_use() {
  for (unsigned lines = C::kWays; lines <= 512; lines *= 2) {
    Cache<C, ListCache<C>> cache(lines);
    for (unsigned pass = 0; pass < 2; ++pass) {
      for (unsigned a = 1000; a < 1000 + lines; ++a) {
        cache.request({{}, Address::from(a)});
        for (const auto& miss : cache.misses()) {
          EXPECT_EQ(pass, 0u);
          cache.fill({false, miss.key, miss.address, memory<ListEntry>(a)});
        }
      }
      EXPECT_EQ(cache.hits().size(), pass == 0 ? 0 : lines);
    }
    cache.request({{}, Address::from(1000 + lines)});
    EXPECT_EQ(cache.misses().size(), 1u) << "one line too many";
  }
}

TEST(CacheLookup, HoldsAsManyConsecutiveLinesAsTheFrameAllows) {
  expect_all_lines_in_use<Of<512>>();
  expect_all_lines_in_use<Of<512, 2>>();
  expect_all_lines_in_use<Of<512, 4>>();
}

TEST(CacheLookup, AnInvalidatedLineIsFetchedAgain) {
  using C = Of<8>;
  Cache<C, NodeCache<C>> cache(8);
  const auto ask = [&cache](unsigned address) {
    cache.request({{}, Address::from(address)});
    return cache.hits().size();
  };
  for (const unsigned address : {16, 17}) {
    EXPECT_EQ(ask(address), 0u);
    cache.fill({false, {}, Address::from(address), memory<Node<Real>>(address)});
    EXPECT_EQ(ask(address), 1u);
  }
  cache.filled();
  cache.fill({true, {}, 0, {}});
  EXPECT_TRUE(cache.filled().empty()) << "nobody waited for it";
  EXPECT_EQ(ask(0), 0u) << "the line holds nothing, not even what invalidated it";
  EXPECT_EQ(ask(16), 0u);
  EXPECT_EQ(ask(17), 1u) << "its neighbour stays";
}

template <class C>
void expect_all_ways_invalidated() {
  Cache<C, NodeCache<C>> cache(C::kLines);
  const auto misses = [&cache] {
    for (unsigned i = 0; i < C::kWays; ++i) cache.request({{}, Address::from(1 + i * kSets<C>)});
    cache.hits();
    return cache.misses();
  };
  for (unsigned i = 0; i < C::kWays; ++i) {
    cache.request({{}, Address::from(1 + i * kSets<C>)});
    for (const auto& miss : cache.misses()) cache.fill({false, miss.key, miss.address, {}});
  }
  EXPECT_TRUE(misses().empty());
  cache.fill({true, {}, 1, {}});
  EXPECT_EQ(misses().size(), C::kWays);
}

TEST(CacheLookup, AnInvalidationEmptiesAllWaysOfASet) {
  expect_all_ways_invalidated<Of<8>>();
  expect_all_ways_invalidated<Of<8, 2>>();
  expect_all_ways_invalidated<Of<8, 4>>();
}

TEST(CacheLookup, AMissStopsNobodyElse) {
  using C = Of<8>;
  Cache<C, NodeCache<C>> cache(8);
  const auto context = [](unsigned packet) {
    StepContext<C> c;
    c.packet = PacketId<C>::from(packet);
    return c;
  };
  cache.fill({false, 7, 5, memory<Node<Real>>(5)});
  cache.request({context(1), 3});
  cache.request({context(2), 5});
  cache.request({context(3), 4});
  EXPECT_EQ(cache.misses().size(), 2u);
  ASSERT_EQ(cache.hits().size(), 1u);
  cache.filled();
  cache.fill({false, 3, 4, memory<Node<Real>>(4)});
  const auto filled = cache.filled();
  ASSERT_EQ(filled.size(), 1u);
  EXPECT_EQ(filled[0].context.packet, PacketId<C>(3)) << "in the order in which the memory answers";
}

}  // namespace
}  // namespace dynrt
