// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/format/configuration_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace dynrt {
namespace {

TEST(ConfigurationJson, GivesBackEveryListedConfiguration) {
  ASSERT_FALSE(listed_configurations().empty());
  for (const CoreConfiguration& listed : listed_configurations()) {
    EXPECT_EQ(configuration_of(json_of(listed)), listed) << listed.name;
  }
}

TEST(ConfigurationJson, WritesValuesAsTheTableHasThem) {
  const auto listed = listed_configurations();
  const auto found = std::ranges::find(listed, "primitives", &CoreConfiguration::name);
  ASSERT_NE(found, listed.end());
  const Json json = json_of(*found);
  EXPECT_EQ(json.begin().key(), "name");
  EXPECT_EQ(json.at("packets"), 32);
  EXPECT_EQ(json.at("rounding"), "nearest_even");
  EXPECT_EQ(json.at("primitives"), Json({"triangle", "sphere", "rectangle"}));
  EXPECT_EQ(value_of(*found, "lights"), 0);
  EXPECT_THROW(value_of(*found, "lihgts"), std::out_of_range);
}

TEST(ConfigurationJson, WritesAWholeNumberAsOne) {
  CoreConfiguration configuration;
  EXPECT_EQ(value_of(configuration, "clock_ns").dump(), "0");
  configuration.clock_ns = 12;
  EXPECT_EQ(json_of(configuration).at("clock_ns").dump(), "12");
  configuration.clock_ns = 8.5;
  EXPECT_EQ(value_of(configuration, "clock_ns").dump(), "8.5");
}

TEST(ConfigurationJson, ReadsAValueBesideItsReason) {
  const auto read = configuration_of(Json::parse(
      R"({"made_for": {"value": "office", "reason": "it was asked for"},
          "packets": {"value": 7, "reason": "more cost area"},
          "primitives": {"value": ["sphere"], "reason": "the scene has no others"}})"));
  EXPECT_EQ(read.made_for, "office");
  EXPECT_EQ(read.packets, 7u);
  EXPECT_FALSE(read.primitives.triangle);
  EXPECT_TRUE(read.primitives.sphere);
  EXPECT_THROW(configuration_of(Json::parse(R"({"packets": {"reason": "none"}})")),
               std::invalid_argument);
}

TEST(ConfigurationJson, IsLikeAListedConfiguration) {
  const auto listed = listed_configurations();
  const auto thesis = std::ranges::find(listed, "thesis", &CoreConfiguration::name);
  ASSERT_NE(thesis, listed.end());
  ASSERT_TRUE(thesis->scan_out);
  const auto read = configuration_of(Json::parse(R"({"like": "thesis", "packets": 4})"));
  CoreConfiguration expected = *thesis;
  expected.name = expected.about = "";
  expected.scan_out = false;  // which is not inherited
  expected.packets = 4;
  EXPECT_EQ(read, expected);
  EXPECT_THROW(configuration_of(Json{{"like", "thesys"}}), std::invalid_argument);
}

TEST(ConfigurationJson, SaysWhatHasThePlaceOfAKeyThatIsGone) {
  EXPECT_THAT([] { configuration_of(Json{{"divider", "reciprocal"}}); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  ::testing::HasSubstr("the key 'divider' is gone; 'datapath' = \"fast\" has it")));
}

TEST(ConfigurationJson, HoldsAConfigurationAgainstTheRules) {
  for (const CoreConfiguration& one : listed_configurations()) {
    EXPECT_EQ(broken_rule(one), "") << one.name;
  }
  CoreConfiguration configuration = *listed_configuration("watertight");
  configuration.levels = 1;
  EXPECT_THAT(std::string(broken_rule(configuration)),
              ::testing::StartsWith("with levels 1 the key 'triangle_test' must be unit_triangle"));
}

TEST(ConfigurationJson, RefusesWhatIsOfAnotherKind) {
  EXPECT_THROW(configuration_of(Json{{"rounding", "up"}}), std::invalid_argument);
  EXPECT_THROW(configuration_of(Json{{"packets", "many"}}), std::invalid_argument);
  EXPECT_EQ(configuration_of(Json::object()), CoreConfiguration{});
}

}  // namespace
}  // namespace dynrt
