// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/standstill.h"

#include <gtest/gtest.h>

#include <vector>

namespace dynrt::host {
namespace {

std::vector<Counter> reading(std::uint64_t list, std::uint64_t list_stalls, std::uint64_t shading) {
  return {{"list_job.tokens", 99, true},
          {"startup.transactions", 544, true},
          {"shading.transactions", shading, true},
          {"list.transactions", list, true},
          {"startup.stalls", 7, false},
          {"shading.stalls", 0, false},
          {"list.stalls", list_stalls, false}};
}

TEST(Standstill, ShowsTheStalledUnitsFirstAndNothingButUnits) {
  EXPECT_EQ(where_units_stand(reading(12, 40, 8), reading(12, 90, 9)),
            "stalled: list 12; at work: shading 9; without input: startup 544");
  EXPECT_EQ(where_units_stand(reading(12, 40, 9), reading(13, 41, 9)),
            "stalled: list 13; without input: startup 544, shading 9");
}

TEST(Standstill, AllMayBeWithoutInput) {
  EXPECT_EQ(where_units_stand(reading(12, 40, 9), reading(12, 40, 9)),
            "without input: startup 544, shading 9, list 12");
}

TEST(Standstill, NothingIsKnownWithoutCounters) {
  EXPECT_EQ(where_units_stand({}, {}), "not known, as the configuration has no counters");
}

}  // namespace
}  // namespace dynrt::host
