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
#include "configs/full.h"
#include "configs/primitives.h"
#include "configs/thesis.h"
#include "configs/watertight.h"
#include "configs/whitted.h"
#include "configs/whitted_split.h"

namespace dynrt {
namespace {

template <class General>
struct OneFifo : General {
  static constexpr PacketFifos kPacketFifos = PacketFifos::kOne;
};
template <class General>
struct CommonOrigin : General {
  static constexpr Origins kOrigins = Origins::kCommon;
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
struct OneLevelFast : OneLevel<config::fast> {
  static constexpr ObjectBox kObjectBox = ObjectBox::kNodes;
};
struct Lit : config::fast {
  static constexpr ObjectBox kObjectBox = ObjectBox::kNodes;
  static constexpr unsigned kLights = 2;
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

struct BoxUnit : config::full {
  static constexpr ObjectBox kObjectBox = ObjectBox::kUnit;
};

template <class C>
class Circles : public testing::Test {};
using Cores =
    testing::Types<config::thesis, BoxUnit, config::watertight, config::whitted,
                   config::whitted_split, config::fast, config::fast_lit, OneFifo<config::thesis>,
                   OneFifo<BoxUnit>, OneFifo<config::watertight>, OneFifo<config::whitted>,
                   OneFifo<config::whitted_split>, OneFifo<config::primitives>, OneFifo<Lit>,
                   OneFifo<CommonOrigin<config::watertight>>, OneFifo<OneLevel<config::whitted>>,
                   OneLevelFast, Pair<config::thesis>, Pair<config::whitted>, Pair<config::fast>>;
TYPED_TEST_SUITE(Circles, Cores);

TYPED_TEST(Circles, NoUnitsWaitForEachOther) { expect_no_circle<TypeParam>(); }

TEST(CirclesOfUnits, OneIsFound) {
  EXPECT_EQ(circle_in({{"a", {"b"}}, {"b", {"c", "d"}}, {"d", {"b"}}}),
            "b waits for d waits for b");
  EXPECT_EQ(circle_in({{"a", {"b", "c"}}, {"b", {"c"}}}), "");
}

}  // namespace
}  // namespace dynrt
