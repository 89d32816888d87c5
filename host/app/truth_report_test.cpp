// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/truth_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/board/configurations.h"

namespace dynrt::host {

/// The report opens no board.
std::span<const Configuration> configurations() { return {}; }

namespace {

using testing::HasSubstr;

WorkReport report_of(const std::string& scene) {
  SceneArguments arguments;
  arguments.scene = scene;
  arguments.width = 96;
  arguments.height = 72;
  return truth_report(prepare(arguments));
}

TEST(TruthReport, ExplainsEveryDifferenceFromEmbree) {
  const WorkReport report = report_of("office");
  const auto& truth = report.json["truth"];
  EXPECT_EQ(truth["rays"], 96 * 72);
  EXPECT_EQ(truth["hits"], 96 * 72) << "the room is closed";
  EXPECT_GT(truth["tied"], 0) << "some of its furniture has the same triangle twice";
  const auto& embree = report.json["embree"];
  std::uint64_t sum = 0;
  for (const auto& [name, count] : embree.items()) sum += count.get<std::uint64_t>();
  EXPECT_EQ(sum, 96 * 72);
  EXPECT_EQ(embree["unexplained"], 0);
  EXPECT_THAT(report.text, HasSubstr("truth       6,912 rays"));
  EXPECT_THAT(report.text, HasSubstr("not explained"));
}

TEST(TruthReport, SaysWhatEmbreeIsNotAskedAbout) {
  const WorkReport report = report_of("unit_objects");
  EXPECT_FALSE(report.json.contains("embree"));
  EXPECT_GT(report.json["truth"]["hits"], 0);
  EXPECT_THAT(report.text, HasSubstr("not compared, as the scene has rectangles or ellipsoids"));
}

}  // namespace
}  // namespace dynrt::host
