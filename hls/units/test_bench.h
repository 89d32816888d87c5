// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shared by the units' tests: a bench that binds every port of one unit to queues that the test can
// fill and read, configurations of any size, random tokens, and a comparison that names the field.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <vector>

#include "configs/thesis.h"
#include "hls/bits.h"
#include "hls/join.h"
#include "hls/random.h"
#include "units/memory_format.h"

namespace dynrt {
/// That of the configurations below, unless a test takes another.
using Real = config::thesis::Real;
}  // namespace dynrt

namespace dynrt::test {

/// The configuration `thesis` in another size. What is not a parameter here can be changed in the
/// same way: struct Lit : test::Config<> { static constexpr unsigned kLights = 2; };
template <unsigned Packets = 32, unsigned Lines = 512, unsigned StackDepth = 31, unsigned Slots = 8,
          class R = config::thesis::Real>
struct Config : config::thesis {
  using Real = R;
  static constexpr unsigned kPackets = Packets;
  static constexpr unsigned kLines = Lines;
  static constexpr unsigned kStackDepth = StackDepth;
  static constexpr unsigned kObjectSlots = Slots;
  static constexpr unsigned kTriangleSlots = Slots;
};

/// Configuration C with the fast datapath, and where besides a packet's rays start at one point.
template <class C>
struct Fast : C {
  static constexpr Datapath kDatapath = Datapath::kFast;
};
template <class C>
struct FastFromOnePoint : Fast<C> {
  static constexpr Origins kOrigins = Origins::kCommon;
};

/// Configuration C with packets of another size, and a typed test's list of all sizes.
template <class C, unsigned Rays>
struct PacketsOf : C {
  static constexpr unsigned kPacketRays = Rays;
};
template <class C>
using PacketSizes = testing::Types<PacketsOf<C, 4>, PacketsOf<C, 8>, PacketsOf<C, 16>>;

/// A unit alone, run as the join runs it.
template <class Unit>
class UnitBench {
 public:
  UnitBench() {
    join_.unit("unit", "unit", unit);
    hls::for_each_port(unit, [this](const std::string&, auto& port) { this->bind(port); });
  }

  Unit unit;

  template <class T>
  void feed(hls::In<T>& port, const T& token) {
    port.queue()->push(token);
  }
  void run() { join_.run(); }
  /// Transactions since the beginning.
  std::uint64_t transactions() const { return join_.counters().at("unit.transactions"); }
  /// The tokens written since the last call.
  template <class T>
  std::vector<T> take(hls::Out<T>& port) {
    auto& queue = *std::static_pointer_cast<hls::Fifo<T>>(bound_.at(&port));
    std::vector<T> tokens;
    while (!queue.empty()) tokens.push_back(queue.pop());
    return tokens;
  }
  /// The only token written since the last call.
  template <class T>
  T take_one(hls::Out<T>& port) {
    const std::vector<T> tokens = take(port);
    EXPECT_EQ(tokens.size(), 1u);
    return tokens.empty() ? T{} : tokens.front();
  }
  template <class T, unsigned N>
  const hls::Rows<T>& rows(hls::RamWrite<T, N>& port) {
    return *std::static_pointer_cast<hls::Rows<T>>(bound_.at(&port));
  }
  template <class T, unsigned N, unsigned L>
  const hls::Rows<T>& rows(hls::RamRead<T, N, L>& port) {
    return *std::static_pointer_cast<hls::Rows<T>>(bound_.at(&port));
  }
  template <class T>
  T& value(hls::Config<T>& port) {
    return *std::static_pointer_cast<T>(bound_.at(&port));
  }

 private:
  template <class T>
  void bind(hls::In<T>& port) {
    join_.input("in", port);
  }
  template <class T>
  void bind(hls::Out<T>& port) {
    bound_[&port] = join_.output("out", port);
  }
  template <class T, unsigned N>
  void bind(hls::RamWrite<T, N>& port) {
    bind_rows<T, N>(port);
  }
  template <class T, unsigned N, unsigned L>
  void bind(hls::RamRead<T, N, L>& port) {
    bind_rows<T, N>(port);
  }
  template <class T, unsigned N, class Port>
  void bind_rows(Port& port) {
    auto rows = std::make_shared<hls::Rows<T>>(N);
    join_.bank("ram", port, *rows);
    bound_[&port] = rows;
  }
  template <class T>
  void bind(hls::Config<T>& port) {
    auto value = std::make_shared<T>();
    join_.config<T>("config", value, {&port});
    bound_[&port] = value;
  }

  hls::Join join_;
  std::map<const void*, std::shared_ptr<void>> bound_;
};

using hls::testing::Random;

inline unsigned below(Random& random, unsigned limit) {
  return static_cast<unsigned>(random.below(limit));
}
inline bool chance(Random& random, unsigned percent) { return below(random, 100) < percent; }

/// Random and extreme fields; an enum may become a value that has no name.
template <class T>
T random_token(Random& random) {
  T token{};
  hls::for_each_leaf(token, [&random]<class L>(L& leaf, unsigned) {
    leaf = hls::testing::random_leaf<L>(random);
  });
  return token;
}

/// Succeeds if two tokens are equal, otherwise names the first field in which they differ.
template <class T>
testing::AssertionResult same(const T& actual, const T& expected) {
  const auto difference = hls::first_difference(actual, expected);
  if (!difference) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << difference->text() << "\n  actual:   " << hls::describe(actual)
         << "\n  expected: " << hls::describe(expected);
}
template <class T>
testing::AssertionResult same(const std::vector<T>& actual, const std::vector<T>& expected) {
  for (std::size_t i = 0; i < actual.size() && i < expected.size(); ++i) {
    const testing::AssertionResult equal = same(actual[i], expected[i]);
    if (!equal) return testing::AssertionFailure() << "token " << i << ": " << equal.message();
  }
  if (actual.size() == expected.size()) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << actual.size() << " tokens where " << expected.size() << " are expected";
}

}  // namespace dynrt::test
