// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/specialise_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/app/special_core.h"
#include "host/format/configuration_json.h"

namespace dynrt::host {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// A core that differs in the depth of its stack alone.
Json result_for(const CoreConfiguration& general) {
  std::vector<Decision> decisions;
  for_each_key(general, [&](const ConfigurationKey& key, const auto&) {
    if (!key.of_core) return;
    const std::string name(key.name);
    decisions.push_back({name, value_of(general, key.name), "as in thesis: nothing decides it"});
  });
  decisions = replaced(decisions, {{"stack_depth", 14, "the deepest tree pushes at most 14"}});
  const Json before = {{"LUT4", 33000}, {"FF", 20000}, {"multiplier", 0}, {"clocks", 1000}};
  const Json now = {{"LUT4", 22000}, {"FF", 20000}, {"multiplier", 0}, {"clocks", 1010}};
  return {{"configuration", json_of(decisions)},
          {"left_out", left_out(decisions, general)},
          {"costs", {{"general", before}, {"special", now}, {"less", savings(before, now)}}},
          {"layouts", Json::object()},
          {"curves", {{"packets", {{"32", 1000}, {"16", 1010}}}, {"lines", Json::object()}}}};
}

TEST(SpecialisePage, SaysWhatIsLeftOutAndWhatThatSaves) {
  const CoreConfiguration thesis = *listed_configuration("thesis");
  Json result = result_for(thesis);
  const std::string page = specialise_page("office: one object", thesis, result);
  EXPECT_THAT(page, HasSubstr("scene       office: one object\ncore        from thesis, "));
  EXPECT_THAT(page, ContainsRegex("\n  stack_depth +31 +14 +the deepest tree pushes at most 14\n"));
  EXPECT_THAT(page, ContainsRegex("\n  LUTs +33,000 +22,000 +33.3 %\n"));
  EXPECT_THAT(page, ContainsRegex("\n  multipliers +0 +0 +-\n"));
  EXPECT_THAT(page, ContainsRegex("\n  clocks of a frame +1,000 +1,010 +1.0 % more\n"));
  EXPECT_THAT(page, ContainsRegex("\n  packets +32 +16\n  clocks +1,000 +1,010\n"));
  EXPECT_THAT(page, HasSubstr("\n  as in thesis: "));
  EXPECT_THAT(page, Not(HasSubstr("\n  lines  ")));
  EXPECT_THAT(page, Not(HasSubstr("line_nodes   ")));
  result["layouts"] = {{"1", {{"clocks", 1200}, {"bytes_per_ray", 6.84}}},
                       {"2", {{"clocks", 1000}, {"bytes_per_ray", nullptr}}}};
  EXPECT_THAT(specialise_page("office", thesis, result),
              ContainsRegex("\n  line_nodes +1 +2\n  clocks +1,200 +1,000\n"
                            "  bytes a ray +6.84 +-\n"));
}

TEST(SpecialisePage, SavingsAreAPartOfTheGeneralCore) {
  EXPECT_EQ(savings({{"LUT4", 400}, {"multiplier", 0}, {"stages", 95}},
                    {{"LUT4", 300}, {"multiplier", 0}, {"stages", 95}}),
            (Json{{"LUT4", 25.0}, {"stages", 0.0}}));
}

TEST(SpecialCore, HasTheNameOfItsScene) {
  EXPECT_EQ(core_name("office"), "office");
  EXPECT_EQ(core_name("/a b/c d.gltf"), "c_d");
  EXPECT_EQ(core_name("maps.pk3:one"), "maps_one");
}

}  // namespace
}  // namespace dynrt::host
