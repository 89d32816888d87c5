// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/unit_activity.h"

#include <gtest/gtest.h>

#include "hls/join_test_units.h"

namespace dynrt {
namespace {

using hls::Lack;
using hls::testing::Add;
using hls::testing::Byte;
using Counts = std::vector<std::uint32_t>;

/// A unit between two FIFOs, of whose frames four parts are wanted.
struct Activity : testing::Test {
  hls::Join join{hls::ModuleSchedules{{"add", {.stages = 2, .room = 4}}}};
  Add add;
  FrameWatch watch{.parts = 4};
  Activity() {
    join.unit("add", "add", add);
    join.constant(add.value, Byte(1));
    join.input("in", add.in);
    join.output("out", add.out);
    watch.units = {"add"};
  }
};

TEST_F(Activity, HasWorkAndWaitsInPartsThatGrow) {
  UnitActivity activity(join, watch);
  activity.works(0, 0);
  activity.waited(0, 0, Lack::kToken, 1, 7);
  activity.works(0, 7);
  EXPECT_EQ(watch.part_clocks, 2u);
  EXPECT_EQ(watch.work[0], (Counts{1, 0, 0, 1}));
  ASSERT_EQ(watch.waits.size(), 1u);
  EXPECT_EQ(watch.waits[0].clocks, (Counts{1, 2, 2, 1}));
  activity.waited(0, 1, Lack::kRoom, 8, 10);
  activity.waited(0, 0, Lack::kToken, 10, 11);
  EXPECT_EQ(watch.part_clocks, 4u);
  EXPECT_EQ(watch.work[0], (Counts{1, 1, 0, 0}));
  ASSERT_EQ(watch.waits.size(), 2u);
  EXPECT_EQ(watch.waits[0].clocks, (Counts{3, 3, 1, 0}));
  EXPECT_TRUE(watch.waits[1].for_room);
  EXPECT_EQ(watch.waits[1].fifo, 1u);
  EXPECT_EQ(watch.waits[1].clocks, (Counts{0, 0, 2, 0}));
}

TEST_F(Activity, HasTheFillOfFifos) {
  UnitActivity activity(join, watch);
  ASSERT_EQ(watch.fifos.size(), 2u);
  EXPECT_EQ(watch.fifos[0].channel, "in");
  EXPECT_EQ(watch.fifos[1].port, "add.out");
  EXPECT_EQ(watch.fifos[1].depth, 5u);
  activity.passed(1, 0, 5);
  activity.passed(1, 1, 6);
  activity.passed(1, 6, 7);  // the first is gone
  EXPECT_EQ(watch.fifos[1].tokens, 3u);
  EXPECT_EQ(watch.fifos[1].clocks, 6u + 6 + 2);
  EXPECT_EQ(watch.fifos[1].most, 2u);
  EXPECT_EQ(watch.fifos[0].tokens, 0u);
}

TEST_F(Activity, OfAFrameBeforeIsForgotten) {
  {
    UnitActivity(join, watch).waited(0, 0, Lack::kToken, 0, 100);
  }
  const UnitActivity activity(join, watch);
  EXPECT_EQ(watch.part_clocks, 1u);
  EXPECT_TRUE(watch.waits.empty());
}

}  // namespace
}  // namespace dynrt
