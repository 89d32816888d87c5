// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/walk.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <glm/geometric.hpp>

#include "host/app/prepare.h"
#include "host/app/walk_folder.h"
#include "host/app/walk_report.h"
#include "host/board/configurations.h"
#include "host/error.h"
#include "host/render/fake_board.h"
#include "host/scene/animation.h"
#include "host/test_folder.h"

namespace dynrt::host {

/// No board of these tests is made by its name.
std::span<const Configuration> configurations() { return {}; }

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr unsigned kWidth = 8;
constexpr unsigned kHeight = 6;

constexpr char kSliding[] = R"({
  "objects": [{"name": "b", "parts": [{"generate": "sphere", "radius": 1, "subdivisions": 2, "colour": [1, 1, 1]}]}],
  "instances": [
    {"object": "b", "name": "still", "position": [9, 0, 0]},
    {"object": "b", "name": "far", "position": [-9, 0, 0]},
    {"object": "b", "name": "slides", "position": [0, 2, 0],
     "motion": {"keys": [{"time": 0}, {"time": 4, "position": [4, 2, 0]}]}}
  ],
  "camera": {"position": [0, 0, 20], "look_at": [0, 0, 0], "field_of_view": 40}
})";

class Walks : public testing::Test {
 protected:
  void SetUp() override { folder_.write("s.json", kSliding); }

  Prepared prepared(const std::string& scene = "") const {
    SceneArguments arguments;
    arguments.scene = scene.empty() ? path("s.json") : scene;
    const CoreInfo core = small_core();
    arguments.width = kWidth;
    arguments.height = kHeight;
    return prepare(arguments, &core);
  }
  std::string path(const std::string& name) const { return folder_.path(name); }
  std::vector<std::string> files(const std::string& name) const { return names_in(folder_ / name); }

  const FrameOptions options_{.width = kWidth, .height = kHeight, .timeout = 1000};
  const TestFolder folder_;
};

/// The board holds, word by word, the scene as it is laid out for its core at that time.
void expect_scene(const FakeBoard& board, Prepared scene, double time) {
  move_to(scene.scene, time);
  const View view{choose_camera(scene.scene, {}, kWidth, kHeight), kWidth, kHeight};
  const MemoryImage image = lay_out(scene.scene, view, board.core(), {.fit = false});
  for (const MemoryRun& run : image.runs()) {
    const auto* words = board.memory.at(run.bank).data() + run.address;
    EXPECT_TRUE(std::equal(run.words.begin(), run.words.end(), words))
        << "bank " << run.bank << " from " << run.address;
  }
}

TEST_F(Walks, SendOnlyWhatChanged) {
  Prepared scene = prepared();
  const WalkPlan plan(scene.scene, 5, {}, {});
  EXPECT_THAT(plan.times, ElementsAre(0, 1, 2, 3, 4));
  FakeBoard board;
  Walker walker(board, options_, scene, {}, plan);
  const std::uint64_t objects = 3 * 4 * 320;  // words of the triangles' matrices alone
  for (unsigned i = 0; i < 5; ++i) {
    const WalkRecord record = walker.render_frame(i, {}).record;
    EXPECT_EQ(record.frame, i);
    EXPECT_EQ(record.time, i);
    EXPECT_EQ(record.cycles, 1000u);
    EXPECT_GT(record.words, 12u * 4);
    EXPECT_LE(record.nodes, top_level_room(3).nodes);
    EXPECT_LE(record.entries, top_level_room(3).items);
    if (i == 0) {
      EXPECT_EQ(record.uploaded_words(), record.words);
    } else {
      // The instance's matrix, of which only the place moves, and the planes around it.
      EXPECT_GT(record.uploaded_words(), 0u);
      EXPECT_LT(record.uploaded_words(), record.words / 2);
    }
    EXPECT_GT(walker.scene_upload().bytes_written, 4 * objects);
  }
  expect_scene(board, prepared(), 4);
}

TEST_F(Walks, WhatStandsStillIsNotSentAgain) {
  Prepared scene = prepared();
  const WalkPlan plan(scene.scene, 3, 4.0, 6.0);  // after the last key
  FakeBoard board;
  Walker walker(board, options_, scene, {}, plan);
  walker.render_frame(0, {});
  const WalkRecord record = walker.render_frame(1, {}).record;
  EXPECT_EQ(record.uploaded_words(), 0u);
  EXPECT_EQ(record.upload, BusTraffic());
}

TEST_F(Walks, GoOnAsIfTheyHadNotStopped) {
  Prepared scene = prepared();
  const WalkPlan plan(scene.scene, 5, {}, {});
  FakeBoard board;
  Walker walker(board, options_, scene, {}, plan);
  WalkRecord expected;
  for (unsigned i = 0; i < 4; ++i) expected = walker.render_frame(i, {}).record;

  FakeBoard other;
  Walker later(other, options_, scene, {}, plan);
  const WalkRecord record = later.render_frame(3, {}).record;
  EXPECT_EQ(record.upload, expected.upload);
  EXPECT_EQ(record.words, expected.words);
  EXPECT_EQ(later.scene_upload(), walker.scene_upload());
  expect_scene(other, prepared(), 3);
}

/// Boxes in one place, which are apart only later.
constexpr char kScattering[] = R"({{
  "objects": [{{"name": "b", "parts": [{{"generate": "box", "from": [-1, -1, -1], "to": [1, 1, 1], "colour": [1, 1, 1]}}]}}],
  "instances": [{}],
  "camera": {{"position": [0, 0, 99], "look_at": [0, 0, 0], "field_of_view": 40}}
}})";

std::string scattering() {
  std::string instances;
  for (int i = 0; i < 729; ++i) {
    instances += fmt::format(
        R"({}{{"object": "b", "name": "b{}", "motion": {{"keys": [{{"time": 0}}, {{"time": 4, "position": [{}, {}, {}]}}]}}}})",
        i == 0 ? "" : ", ", i, 8 * (i % 9), 8 * (i / 9 % 9), 8 * (i / 81));
  }
  return fmt::format(kScattering, instances);
}

TEST_F(Walks, AFrameThatExceedsItsCoreIsRefusedAndTheNextIsNot) {
  std::ofstream(folder_ / "t.json") << scattering();
  Prepared scene = prepared(path("t.json"));
  CoreInfo& core = scene.objects.core;
  core.made_for = "t";
  core.stack_depth = 8;  // of the tree of a box
  FakeBoard board(core);
  // There and back again.
  WalkPlan plan(scene.scene, 3, {}, {});
  plan.times = {0, 4, 0};
  Walker walker(board, options_, scene, {}, plan);
  EXPECT_NO_THROW(walker.render_frame(0, {}));
  EXPECT_THAT([&] { walker.render_frame(1, {}); },
              ThrowsMessage<Exceeded>(
                  testing::AllOf(HasSubstr("frame 1 of 3 needs stack_depth "),
                                 HasSubstr("and configuration small, made for 't', has 8"))));
  EXPECT_NO_THROW(walker.render_frame(2, {}));
  // A core that was made for no scene renders them all, with a shallower tree if it must.
  core.made_for = small_core().made_for;
  EXPECT_NO_THROW(walker.render_frame(1, {}));
}

TEST_F(Walks, FramesTakeTurnsInTheFramebuffer) {
  Prepared scene = prepared();
  FakeBoard board;
  std::vector<std::uint64_t> bases;
  board.on_start = [&](const FrameConfig& frame, FakeBoard::Memory&) {
    bases.push_back(frame.frame_base.to_u64());
  };
  Walker walker(board, options_, scene, {}, WalkPlan(scene.scene, 3, {}, {}));
  for (unsigned i = 0; i < 3; ++i) walker.render_frame(i, {});
  EXPECT_THAT(bases, ElementsAre(0, 1u << 19, 0));
}

TEST_F(Walks, StillScenesAreWalkedAround) {
  const Prepared scene = prepared("blocks");
  const WalkPlan plan(scene.scene, 4, {}, {});
  EXPECT_TRUE(plan.orbit);
  const Box box = bounds(scene.scene);
  const glm::dvec3 centre = (box.low + box.high) / 2.0;
  glm::dvec3 sum(0);
  for (const double time : plan.times) {
    const Camera camera = plan.camera(scene.scene, {}, time, kWidth, kHeight);
    const glm::dvec3 arm = camera.position - centre;
    EXPECT_NEAR(glm::length(arm), glm::length(scene.view.camera.position - centre), 1e-9);
    EXPECT_NEAR(arm.y, scene.view.camera.position.y - centre.y, 1e-9);
    sum += glm::dvec3(arm.x, 0, arm.z);
  }
  EXPECT_LT(glm::length(sum), 1e-9) << "the four frames are a quarter of the circle apart";
  EXPECT_FALSE(WalkPlan(prepared().scene, 4, {}, {}).orbit);
}

TEST_F(Walks, NameWhatIsNoWalk) {
  const Scene scene = prepared().scene;
  EXPECT_THAT([&] { WalkPlan(scene, 0, {}, {}); },
              ThrowsMessage<UserError>("--frames 0: a walk has 1 to 9999 frames"));
  EXPECT_THAT([&] { WalkPlan(scene, 4, 4.5, {}); },
              ThrowsMessage<UserError>("--from 4.5 and --to 4: the walk must begin at 0 seconds or "
                                       "later and end after it begins"));
  EXPECT_THAT([&] { WalkPlan(scene, 4, -1.0, {}); },
              ThrowsMessage<UserError>(HasSubstr("--from -1")));
  EXPECT_THAT(WalkPlan(scene, 1, 2.0, {}).times, ElementsAre(2));
}

/// The frames of a walk, as a folder keeps them.
struct KeptFrame {
  Frame frame;
  WalkRecord record;

  explicit KeptFrame(unsigned number) {
    frame.width = kWidth;
    frame.height = kHeight;
    frame.pixels.assign(kWidth * kHeight, number);
    record.frame = number;
    record.time = 0.1 * number;
    record.cycles = 1000 + number;
    record.simulation_seconds = 0.3;
    record.tree_seconds = 0.7;
    record.pack_seconds = 0.1;
    record.upload = {3, 400, 0, 106};
    record.words = 500;
    record.nodes = 12;
    record.entries = 13;
  }
};

const WalkSettings kSettings = {{"SCENE", "s"}, {"--size", "8x6"}, {kSceneContent, "0123"}};

TEST_F(Walks, KeepWholeFramesOnly) {
  {
    WalkFolder folder(path("w"), kSettings, false);
    EXPECT_FALSE(fs::exists(path("w"))) << "nothing is written before there is a frame";
    for (const unsigned i : {0u, 1u, 2u}) folder.write(KeptFrame(i).frame, KeptFrame(i).record);
    folder.save();
  }
  fs::resize_file(path("w/frame_0001.png"), 40);
  fs::remove(path("w/frame_0002.png"));
  // Left by one that was killed; no process has this number.
  std::ofstream(path("w/.frame_0003.999999999.png")) << "half";
  std::ofstream(path("w/.walk.999999999.json")) << "half";
  const WalkFolder folder(path("w"), kSettings, false);
  EXPECT_THAT(files("w"), ElementsAre("frame_0000.png", "frame_0001.png", "walk.json"));
  const auto kept = folder.kept(0, kWidth, kHeight);
  ASSERT_TRUE(kept);
  EXPECT_EQ(json_of(*kept), json_of(KeptFrame(0).record));
  EXPECT_FALSE(folder.kept(1, kWidth, kHeight)) << "cut off";
  EXPECT_FALSE(folder.kept(2, kWidth, kHeight)) << "gone";
  EXPECT_FALSE(folder.kept(3, kWidth, kHeight)) << "never made";
  EXPECT_FALSE(folder.kept(0, kHeight, kWidth)) << "of another size";
}

TEST_F(Walks, FramesOfAnotherWalkAreNamed) {
  WalkFolder(path("w"), kSettings, false).write(KeptFrame(0).frame, KeptFrame(0).record);
  const auto opening = [&](std::size_t which, const std::string& value) {
    WalkSettings settings = kSettings;
    settings[which].second = value;
    return [this, settings] { WalkFolder(path("w"), settings, false); };
  };
  EXPECT_THAT(
      opening(1, "16x12"),
      ThrowsMessage<UserError>(
          path("w") + ": the folder holds frames of another walk, with --size '8x6' where this "
                      "walk has '16x12'; name another --out, or give --again to replace them"));
  EXPECT_THAT(opening(2, "4567"),
              ThrowsMessage<UserError>(
                  path("w") + ": the folder holds frames of an older version of the scene; name "
                              "another --out, or give --again to replace them"));
  WalkSettings more = kSettings;
  more.emplace_back("--later", "yes");
  EXPECT_THAT([&] { WalkFolder(path("w"), more, false); },
              ThrowsMessage<UserError>(testing::HasSubstr(
                  "frames of another walk, with --later '' where this walk has 'yes'")));
  std::ofstream(path("w/notes.txt")) << "the user's own";
  const WalkFolder anew(path("w"), {{"SCENE", "t"}}, true);
  EXPECT_THAT(files("w"), ElementsAre("notes.txt"));
}

TEST_F(Walks, PicturesThatNoWalkLeftAreNotTouched) {
  fs::create_directories(path("w"));
  std::ofstream(path("w/frame_0000.png")) << "mine";
  EXPECT_THAT(
      [&] { WalkFolder(path("w"), kSettings, false); },
      ThrowsMessage<UserError>(
          path("w") + ": the folder has a frame_0000.png but no walk.json, so dynrt did not write "
                      "it as a walk; name another --out, or give --again to replace its frames"));
  std::ofstream(path("w/walk.json")) << "{\"settings\": {}}";
  EXPECT_THAT([&] { WalkFolder(path("w"), kSettings, false); },
              ThrowsMessage<UserError>(
                  testing::StartsWith(path("w/walk.json") + ": a walk did not write this file (")));
  EXPECT_NO_THROW(check_walk_folder(path("fresh/")));
  EXPECT_THAT([&] { check_walk_folder(path("no/w")); },
              ThrowsMessage<UserError>(path("no/w") + ": there is no folder '" + path("no") +
                                       "'; create it or name a file elsewhere"));
  EXPECT_THAT(
      [&] { check_walk_folder(path("s.json")); },
      ThrowsMessage<UserError>(path("s.json") + ": cannot write this file (Not a directory); name "
                                                "a file in a folder that can be written"));
}

TEST_F(Walks, AreSummedUp) {
  std::vector<WalkRecord> records = {KeptFrame(0).record, KeptFrame(1).record};
  for (WalkRecord& record : records) record.tree_seconds = record.pack_seconds = 1e-6;
  records[0].cycles = 1'000'000;
  records[1].cycles = 3'000'000;
  records[1].upload = {2, 800, 0, 33000};  // a millisecond
  EXPECT_NEAR(frame_seconds(records[1], 100e6), 0.031, 1e-9);
  records[1].tree_seconds = 0.05;  // the core waits for the host
  EXPECT_NEAR(frame_seconds(records[1], 100e6), 0.051001, 1e-9);
  const WalkSummary summary{records, 1, {5, 4000, 0, 66000}, {.mhz = 100}};
  EXPECT_THAT(summary.text(),
              HasSubstr("walk        2 frames, 1 of them rendered before: 50.00 frames per second "
                        "at 100 MHz, at least 33.33 (frame 1); 32.78 with rebuild and upload\n"
                        "clock       100 MHz, as --clock says\n"));
  EXPECT_THAT(summary.text(),
              HasSubstr("rebuild     25.00 ms for each frame\n"
                        "upload      200 of the 500 words of a frame (1.00 ms), after 1,000 words "
                        "of objects once (2.00 ms)\n"));
  const auto json = summary.json();
  EXPECT_EQ(json["frames"].size(), 2u);
  EXPECT_NEAR(json["frames_per_second"].get<double>(), 50, 1e-9);
  EXPECT_EQ(json["clock"],
            (nlohmann::ordered_json{{"mhz", 100}, {"placed", false}, {"of_board", false}}));
  EXPECT_NEAR(json["frames"][1]["frames_per_second"].get<double>(), 100.0 / 3, 1e-9);
  records[0].cycles.reset();
  EXPECT_TRUE(summary.json()["frames_per_second"].is_null());
  EXPECT_THAT(walk_line(records[0], 100e6), HasSubstr(" -"));
}

}  // namespace
}  // namespace dynrt::host
