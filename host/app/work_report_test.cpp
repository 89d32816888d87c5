// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the tracer in doubles counts is what the core counts of itself, as its native model; so what
// it counts of cores that there are not can be believed. It is up to one in a hundred less: with 17
// significant bits a hit cannot always be told from the plane just behind it, and the packet goes
// on to the next leaf.
#include "host/app/work_report.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "host/analysis/counts/counts.h"
#include "host/app/board_frame.h"
#include "host/render/figures.h"

namespace dynrt::host {
namespace {

std::uint64_t count(const Frame& frame, const std::string& name) {
  if (const auto value = value_of(frame, name)) return *value;
  ADD_FAILURE() << "the core has no counter " << name;
  return 0;
}

/// The work of a frame by the tokens that the core's units handed on.
WorkCounts work_of(const Frame& frame) {
  WorkCounts work;
  work.packets = count(frame, "shade_job.tokens");
  work.list_entries = count(frame, "list_lookup.transactions");
  // Four candidates for every triangle, and four that reset the hits of a new packet.
  work.triangles = count(frame, "collect_hits.transactions") / 4 - work.packets;
  work.objects = count(frame, "transform_job.tokens") - work.triangles - work.packets;
  // The list gets a job for every leaf and for every entry that is done with. A leaf that no living
  // ray reaches gives it none, and counts as a step here.
  work.leaf_fetches = count(frame, "list_job.tokens") - work.list_entries;
  work.object_steps = count(frame, "node_lookup.transactions") - work.leaf_fetches;
  work.hits = frame.hit_count();
  return work;
}

class CountedWork : public testing::TestWithParam<const char*> {};

TEST_P(CountedWork, IsThatOfTheCore) {
  constexpr unsigned kWidth = 96, kHeight = 72;
  constexpr double kTolerance = 0.01;
  SceneArguments arguments;
  arguments.scene = GetParam();
  arguments.width = kWidth;
  arguments.height = kHeight;
  FrameOptions options = arguments.frame_options();
  options.timeout = 10'000'000;
  const auto board = open_board({"model", "thesis", ""}, options);
  const Prepared prepared = prepare(arguments, &board->core());
  const WorkCounts core = work_of(render_on(*board, options, prepared));
  const WorkCounts counted =
      trace_frame(prepared.scene, prepared.trees, prepared.view.camera, kWidth, kHeight).work;
  EXPECT_EQ(counted.packets, kWidth * kHeight / 4);
  EXPECT_EQ(core.packets, counted.packets);
  const auto expect_near = [](const char* what, std::uint64_t of_core, std::uint64_t of_tracer) {
    EXPECT_NEAR(static_cast<double>(of_core), static_cast<double>(of_tracer),
                kTolerance * static_cast<double>(of_core))
        << what;
  };
  expect_near("nodes fetched", core.steps() + core.leaf_fetches,
              counted.steps() + counted.leaf_fetches);
  expect_near("list entries", core.list_entries, counted.list_entries);
  expect_near("objects", core.objects, counted.objects);
  expect_near("triangles", core.triangles, counted.triangles);
  expect_near("hits", core.hits, counted.hits);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CountedWork, testing::Values("blocks", "conference", "trees4000"));

using Json = nlohmann::ordered_json;

class Reports : public testing::Test {
 protected:
  static Prepared conference() {
    SceneArguments arguments;
    arguments.scene = "conference";
    arguments.width = kWidth;
    arguments.height = kHeight;
    return prepare(arguments);
  }
  /// The figure of each row, which are all of the same picture.
  static std::map<std::string, double> figures(const Json& report, const std::string& key,
                                               const std::string& figure) {
    EXPECT_EQ(report["different_pixels"], 0);
    std::map<std::string, double> by_name;
    for (const Json& row : report["rows"]) {
      const Json& name = row[key];
      by_name[name.is_string() ? name.get<std::string>() : name.dump()] = row["packets"][figure];
    }
    return by_name;
  }

  static constexpr unsigned kWidth = 64, kHeight = 48;
  const Prepared prepared_ = conference();
};

TEST_F(Reports, EveryTreatmentOfOverlapBeatsNone) {
  const WorkReport report = overlap_report(prepared_);
  auto objects = figures(report.json, "method", "objects");
  auto triangles = figures(report.json, "method", "triangles");
  ASSERT_EQ(objects.size(), 5);
  for (const char* method : {"hierarchical", "mailbox", "core", "multiple_scenes"}) {
    EXPECT_LT(objects[method], 0.6 * objects["none"]) << method;
  }
  EXPECT_LT(triangles["core"], triangles["mailbox"]);
  EXPECT_EQ(report.json["rows"][0]["thesis_millions"]["steps"], 295.4);
}

TEST_F(Reports, MoreSlotsTransformLessAgain) {
  const WorkReport report = mailbox_report(prepared_);
  const Json& rows = report.json["rows"];
  ASSERT_EQ(rows.size(), 9);
  for (std::size_t i = 1; i < 7; ++i) {
    EXPECT_LE(rows[i]["objects_again"], rows[i - 1]["objects_again"]) << rows[i];
    EXPECT_LT(rows[i]["triangles_again"], rows[i - 1]["triangles_again"]) << rows[i];
  }
  EXPECT_GT(rows[0]["objects_again"], 1000);
  EXPECT_EQ(rows[6]["object_slots"], 32);
  EXPECT_EQ(rows[6]["objects_again"], 0);
  EXPECT_NE(report.text.find("       32         32"), std::string::npos) << report.text;
}

TEST_F(Reports, ClippingSavesStepsAndTriangles) {
  const WorkReport report = clipping_report(prepared_);
  auto inside = figures(report.json, "clipping", "object_steps");
  auto top = figures(report.json, "clipping", "top_steps");
  ASSERT_EQ(inside.size(), 6);
  EXPECT_LT(inside["objects"], 0.7 * inside["none"]);
  EXPECT_GT(top["both"], top["objects"]);  // the camera is in the room, where it is in vain
  EXPECT_LT(inside["from_outside"], inside["both"]);
  EXPECT_LT(inside["objects_free"], inside["from_outside"]);
}

}  // namespace
}  // namespace dynrt::host
