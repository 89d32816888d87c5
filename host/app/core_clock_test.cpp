// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/core_clock.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/error.h"

namespace dynrt::host {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

CoreInfo core_of(std::string_view configuration) {
  return CoreInfo(*listed_configuration(configuration));
}

/// The one of the device and grade that stand without flags.
const PlacedClock& first() { return placed_clocks().front(); }
/// The one that every configuration without a placement gets there.
const PlacedClock& slowest() {
  const PlacedClock* least = &first();
  for (const PlacedClock& c : placed_clocks()) {
    if (c.device == first().device && c.grade == first().grade && c.mhz < least->mhz) least = &c;
  }
  return *least;
}

TEST(CoreClock, IsThatOfThePlacedConfiguration) {
  const CoreClock clock = ClockFlags{}.clock_of(core_of(first().configuration));
  EXPECT_TRUE(clock.own);
  EXPECT_EQ(clock.mhz, first().mhz);
  EXPECT_EQ(clock.text(),
            fmt::format("clock       {:g} MHz, placed: {} on {}, median of {} seeds ({:g} to {:g} "
                        "MHz), on {}\n",
                        first().mhz, first().configuration, first().where(), first().seeds,
                        first().lowest_mhz, first().highest_mhz, first().date));
  EXPECT_EQ(clock.json()["date"], first().date);
  EXPECT_EQ(clock.json()["of_this_configuration"], true);
}

TEST(CoreClock, OfAnotherCoreIsSaidToBeSo) {
  CoreInfo other = core_of(first().configuration);
  ++other.packets;
  other.name = "other";
  EXPECT_THAT(ClockFlags{}.clock_of(other).text(),
              HasSubstr(fmt::format("placed: {} on {}; other was not placed and may miss it\n",
                                    slowest().configuration, slowest().where())));
}

TEST(CoreClock, OfAFileWithTheNameOfAPlacedConfigurationIsSaidToBeOfOtherKeys) {
  CoreInfo core = core_of(first().configuration);
  ++core.packets;
  const CoreClock clock = ClockFlags{}.clock_of(core);
  EXPECT_FALSE(clock.own);
  EXPECT_EQ(clock.mhz, slowest().mhz);
  EXPECT_THAT(clock.text(),
              HasSubstr(fmt::format("placed: {} on {}; this core has other keys, was not placed "
                                    "and may miss it\n",
                                    slowest().configuration, slowest().where())));
  EXPECT_EQ(clock.json()["of_this_configuration"], false);
}

TEST(CoreClock, MayBeGiven) {
  ClockFlags flags;
  flags.mhz = 85;
  EXPECT_EQ(flags.clock_of(core_of("thesis")).text(), "clock       85 MHz, as --clock says\n");
  flags.device = "none";
  EXPECT_THROW(flags.check(), UserError);
}

TEST(CoreClock, OfABoardThatExistsIsTheBoards) {
  const CoreClock clock = ClockFlags{}.clock_of(core_of(first().configuration), 78.125e6);
  EXPECT_EQ(clock.text(), "clock       78.125 MHz, that of the board\n");
  EXPECT_EQ(clock.json(),
            (nlohmann::ordered_json{{"mhz", 78.125}, {"placed", false}, {"of_board", true}}));
  ClockFlags given;
  given.mhz = 85;
  EXPECT_EQ(given.clock_of(core_of("thesis"), 78.125e6).mhz, 85);
}

TEST(CoreClock, EveryPlacementIsFound) {
  for (const PlacedClock& placed : placed_clocks()) {
    ClockFlags flags;
    flags.device = placed.device;
    flags.grade = placed.grade;
    EXPECT_NO_THROW(flags.check());
    const CoreClock clock = flags.clock_of(core_of(placed.configuration));
    EXPECT_EQ(clock.placed, &placed);
    EXPECT_TRUE(clock.own);
  }
}

TEST(CoreClock, DevicesAndGradesWithoutAPlacementAreRefused) {
  ClockFlags flags;
  flags.device = "ice40-hx8k";
  EXPECT_THAT([&] { flags.check(); },
              ThrowsMessage<UserError>(HasSubstr("--device ice40-hx8k: no core was placed on such "
                                                 "a device, so it has no clock; those with a "
                                                 "clock: ecp5-85")));
  flags = {};
  flags.grade = "5";
  EXPECT_THAT([&] { flags.check(); },
              ThrowsMessage<UserError>(HasSubstr("--grade 5: no core was placed on ecp5-85 of this "
                                                 "grade")));
}

}  // namespace
}  // namespace dynrt::host
