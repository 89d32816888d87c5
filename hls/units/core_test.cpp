// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// No units of the core wait for each other in a circle: a writer waits for the readers of its
// channel where the channel's FIFO does not hold every packet.
#include "units/core.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "configs/fast.h"
#include "configs/fast_lit.h"
#include "configs/fast_watertight.h"
#include "configs/primitives.h"
#include "configs/thesis.h"
#include "configs/watertight.h"
#include "configs/whitted.h"

namespace dynrt {
namespace {

template <class General>
struct Fast : General {
  static constexpr Datapath kDatapath = Datapath::kFast;
};
template <class General>
struct OneLevel : General {
  static constexpr unsigned kLevels = 1;
};
template <class General>
struct Pair : General {
  static constexpr unsigned kPipelines = 2;
  static constexpr unsigned kMemoryClocks = 2;
};
struct Split : config::whitted {
  static constexpr Crossing kCrossing = Crossing::kSplit;
};

std::string unit_of(const std::string& port) { return port.substr(0, port.find('.')); }

/// By unit, those that it waits for.
using Waits = std::map<std::string, std::set<std::string>>;

Waits waits_of(const hls::JoinRecord& join) {
  Waits waits;
  for (const hls::ChannelRecord& channel : join.channels) {
    for (const std::string& writer : channel.from) {
      if (channel.holds_all(writer)) continue;
      for (const std::string& reader : channel.to) waits[unit_of(writer)].insert(unit_of(reader));
    }
  }
  return waits;
}

/// The units of a circle through `unit`, which `path` leads to, or nothing.
std::string circle(const Waits& waits, const std::string& unit, std::vector<std::string>& path,
                   std::set<std::string>& done) {
  std::string text;
  for (const std::string& on_path : path) {
    if (!text.empty() || on_path == unit) text += on_path + " waits for ";
  }
  if (!text.empty()) return text + unit;
  if (!done.insert(unit).second || !waits.contains(unit)) return {};
  path.push_back(unit);
  for (const std::string& next : waits.at(unit)) {
    const std::string found = circle(waits, next, path, done);
    if (!found.empty()) return found;
  }
  path.pop_back();
  return {};
}

std::string circle_in(const Waits& waits) {
  std::set<std::string> done;
  for (const auto& [unit, readers] : waits) {
    std::vector<std::string> path;
    const std::string found = circle(waits, unit, path, done);
    if (!found.empty()) return found;
  }
  return {};
}

template <class C>
void expect_no_circle() {
  hls::Join join;
  Banks<C> banks;
  const auto core = std::make_unique<Core<C>>(join, banks);
  const Waits waits = waits_of(join.record());
  EXPECT_GT(waits.size(), 10u);
  EXPECT_EQ(circle_in(waits), "");
}

template <class C>
class Circles : public testing::Test {};
using Cores =
    testing::Types<config::thesis, config::watertight, config::whitted, Split, config::fast,
                   config::fast_watertight, config::fast_lit, Fast<config::thesis>,
                   Fast<config::whitted>, Fast<Split>, Fast<config::primitives>,
                   Fast<OneLevel<config::whitted>>, OneLevel<config::fast>, Pair<config::thesis>,
                   Pair<config::whitted>, Pair<config::fast>>;
TYPED_TEST_SUITE(Circles, Cores);

TYPED_TEST(Circles, NoUnitsWaitForEachOther) { expect_no_circle<TypeParam>(); }

TEST(CirclesOfUnits, OneIsFound) {
  EXPECT_EQ(circle_in({{"a", {"b"}}, {"b", {"c", "d"}}, {"d", {"b"}}}),
            "b waits for d waits for b");
  EXPECT_EQ(circle_in({{"a", {"b", "c"}}, {"b", {"c"}}}), "");
}

}  // namespace
}  // namespace dynrt
