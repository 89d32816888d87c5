// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The stress cases on cores that were made for a scene: each case gives the general core's hits or
// is refused with the key that the core lacks.
#include <gmock/gmock.h>

#include <algorithm>

#include "configs/thesis.h"
#include "core/specialised.h"
#include "host/analysis/stress/run.h"

namespace dynrt::host::specialised {
namespace {

using Thesis = config::thesis;
using ::testing::ContainsRegex;

/// Of two levels, with short stacks and few addresses.
struct ForBlocks : Thesis {
  static constexpr unsigned kTopStackDepth = 10;
  static constexpr unsigned kStackDepth = 20;
  static constexpr unsigned kAddressBits = 13;
  static constexpr unsigned kMatrixBits = 11;
  static constexpr bool kUncompressed = false;
  static constexpr bool kCounters = false;
};
/// The core that `dynrt specialise office` makes.
struct ForOffice : Thesis {
  static constexpr unsigned kLevels = 1;
  static constexpr unsigned kTopStackDepth = 1;
  static constexpr unsigned kStackDepth = 25;
  static constexpr unsigned kObjectSlots = 0;
  static constexpr unsigned kAddressBits = 18;
  static constexpr unsigned kMatrixBits = 16;
  static constexpr bool kUncompressed = false;
  static constexpr bool kCounters = false;
};

constexpr char kSpecial[] = "special";

template <class C>
std::unique_ptr<Board> made_for(const std::string& scene) {
  CoreInfo core = core_info_of<C>();
  core.name = kSpecial;
  core.made_for = scene;
  core.general = std::make_shared<CoreConfiguration>(core_info_of<Thesis>());
  return std::make_unique<ModelBoard>(std::move(core), std::make_unique<NativeCoreOf<C>>());
}

struct Tally {
  std::size_t cases = 0, refused = 0, hits = 0, other = 0;
};

std::size_t other_hits(const std::vector<Frame>& found, const std::vector<Frame>& expected) {
  std::size_t other = 0;
  for (std::size_t f = 0; f < found.size(); ++f) {
    for (std::size_t i = 0; i < found[f].hits.size(); ++i) {
      const HitRecord& a = found[f].hits[i];
      const HitRecord& b = expected.at(f).hits.at(i);
      other += a.hit != b.hit || (a.hit && a.triangle != b.triangle);
    }
  }
  return other;
}

template <class C>
Tally run_all(const std::string& scene) {
  const auto general_board = [](const std::string& name) {
    const bool listed = std::ranges::find(configurations(), name, &Configuration::name) !=
                        configurations().end();
    return listed ? make_board(configurations(), {"model", name, ""}) : nullptr;
  };
  stress::Boards general(general_board, "thesis");
  stress::Boards special(
      [&](const std::string& name) {
        return name == kSpecial ? made_for<C>(scene) : general_board(name);
      },
      kSpecial);
  Tally tally;
  for (const stress::Case* c : stress::find_cases({})) {
    std::vector<Frame> expected, found;
    try {
      stress::run_case(*c, general, &expected);
    } catch (const stress::NoBoard&) {
      continue;  // of a configuration that the table lacks
    }
    const stress::Result result = stress::run_case(*c, special, &found);
    ++tally.cases;
    EXPECT_TRUE(result.within()) << stress::line_of(result);
    if (result.outcome.exceeds_core) {
      ++tally.refused;
      EXPECT_THAT(result.outcome.refusal,
                  ContainsRegex("needs [a-z_]+ .*, and configuration special, made for '" + scene +
                                "', has "));
      continue;
    }
    tally.hits += result.outcome.hits;
    tally.other += other_hits(found, expected);
  }
  return tally;
}

TEST(SpecialisedStress, ACoreOfTwoLevelsGivesTheGeneralCoresHits) {
  const Tally tally = run_all<ForBlocks>("blocks");
  EXPECT_GT(tally.refused, 0u);
  EXPECT_GT(tally.cases - tally.refused, tally.cases / 2);
  EXPECT_GT(tally.hits, 10'000u);
  EXPECT_EQ(tally.other, 0u);
}

// Rays of a core of one level are not multiplied with an instance's matrix, so that those that
// graze an edge may take the neighbouring triangle.
TEST(SpecialisedStress, ACoreOfOneLevelGivesTheGeneralCoresHits) {
  const Tally tally = run_all<ForOffice>("office");
  EXPECT_GT(tally.refused, 0u);
  EXPECT_GT(tally.cases - tally.refused, tally.cases / 4);
  EXPECT_GT(tally.hits, 1000u);
  EXPECT_LE(50 * tally.other, tally.hits);
}

}  // namespace
}  // namespace dynrt::host::specialised
