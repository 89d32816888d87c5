// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The program's walks, interrupted ones among them.
#include <chrono>
#include <cstdlib>

#include "host/app/program_test.h"

namespace dynrt::host {
namespace {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST_F(App, WalksIntoAFolder) {
  const std::string walk = std::string("walk blocks --frames 3 --out w") + kModel;
  const Outcome outcome = run(walk + "--json f.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("f.json", "w"));
  EXPECT_THAT(outcome.out, HasSubstr("note        neither the scene nor its camera moves, so the "
                                     "camera goes once round the scene's centre\n"));
  EXPECT_THAT(outcome.out, ContainsRegex("walk        3 frames\n"));
  EXPECT_THAT(outcome.out, HasSubstr("images      w, 32x24\n"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "f.json"));
  EXPECT_EQ(json["walk"]["frames"].size(), 3u);
  // The camera alone moves: its matrix, twelve words.
  EXPECT_LE(json["walk"]["frames"][1]["upload"]["words"], 12);

  // What is there is not made again; what is missing is.
  const std::string second = text_of(folder_ / "w/frame_0001.png");
  fs::remove(folder_ / "w/frame_0001.png");
  const Outcome resumed = run(walk);
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_THAT(resumed.out, HasSubstr("walk        3 frames, 2 of them rendered before\n"));
  EXPECT_EQ(text_of(folder_ / "w/frame_0001.png"), second);
  EXPECT_NE(text_of(folder_ / "w/frame_0000.png"), second);

  const Outcome other = run(walk + "--fov 30");
  EXPECT_EQ(other.code, 2);
  EXPECT_EQ(other.err,
            "dynrt: w: the folder holds frames of another walk, with --fov '' where this walk has "
            "'30'; name another --out, or give --again to replace them\n");
  EXPECT_EQ(run(walk + "--fov 30 --again").code, 0);
  EXPECT_NE(text_of(folder_ / "w/frame_0001.png"), second);
}

TEST_F(App, AWalkTakesTheTreesOfAnEarlierOne) {
  const TestFolder cache;
  ASSERT_EQ(::setenv("DYNRT_CACHE", cache.path().c_str(), 1), 0);
  const std::string walk = std::string("walk blocks --frames 1") + kModel + "--out ";
  const Outcome outcome = run(walk + "first --json f.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(", built or taken from an earlier run in "));
  const auto scene = nlohmann::json::parse(text_of(folder_ / "f.json"))["scene"];
  EXPECT_EQ(scene["trees_may_be_kept"], true);
  const fs::path trees = cache / "trees";
  const std::vector<std::string> kept = names_in(trees);
  ASSERT_THAT(kept, Not(IsEmpty()));

  // A tree that is built is written anew.
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const std::string& tree : kept) fs::last_write_time(trees / tree, long_ago);
  EXPECT_EQ(run(walk + "second").code, 0);
  EXPECT_EQ(names_in(trees), kept);
  for (const std::string& tree : kept) EXPECT_EQ(fs::last_write_time(trees / tree), long_ago);
  EXPECT_EQ(text_of(folder_ / "second/frame_0000.png"), text_of(folder_ / "first/frame_0000.png"));
}

TEST_F(App, AWalkHasTheFiguresOfEachFrame) {
  const std::string walk = std::string("walk blocks --frames 2") + kModel + "--json f.json --out ";
  constexpr unsigned kRays = 32 * 24;
  const auto frames = [&] {
    return nlohmann::json::parse(text_of(folder_ / "f.json"))["walk"]["frames"];
  };
  ASSERT_EQ(run(walk + "w").code, 0);
  for (const auto& frame : frames()) {
    EXPECT_EQ(frame["figures"]["memory"]["pixel_bytes_written"], 4 * kRays);
    EXPECT_EQ(frame["figures"]["memory"]["hit_bytes_written"], 0);
  }
  ASSERT_EQ(run(walk + "h --hits").code, 0);
  const auto with_hits = frames();
  EXPECT_EQ(with_hits[1]["figures"]["memory"]["hit_bytes_written"], 24 * kRays);
  EXPECT_NE(with_hits[0]["figures"]["hits"], with_hits[1]["figures"]["hits"]);

  fs::remove(folder_ / "h/frame_0001.png");
  ASSERT_EQ(run(walk + "h --hits").code, 0);
  const auto resumed = frames();
  EXPECT_TRUE(resumed[0]["figures"].is_null()) << "it was there";
  EXPECT_EQ(resumed[1]["figures"]["hits"], with_hits[1]["figures"]["hits"]);

  const Outcome other = run(walk + "h");
  EXPECT_THAT(other.err, HasSubstr("with --hits 'yes' where this walk has 'no'"));
}

TEST_F(App, WalksIntoAGif) {
  const std::string walk = std::string("walk blocks --frames 2") + kModel;
  // As if it had been interrupted after its first frame.
  EXPECT_EQ(run(walk + "--out blocks.gif.frames").code, 0);
  fs::remove(folder_ / "blocks.gif.frames/frame_0001.png");
  const Outcome outcome = run(walk);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("walk        2 frames, 1 of them rendered before\n"));
  EXPECT_THAT(outcome.files, ElementsAre("blocks.gif")) << "the frames' folder is gone";
  EXPECT_TRUE(text_of(folder_ / "blocks.gif").starts_with("GIF89a"));
}

TEST_F(App, AWalkThatIsKilledGoesOn) {
  const std::string walk = std::string("walk blocks --frames 40 --out w") + kModel;
  // Killed at its second picture, without a chance to tidy up.
  const std::string killed = "cd '" + folder_.path().string() + "' && { '" DYNRT_PROGRAM "' " +
                             walk +
                             " > /dev/null & } && while [ ! -e w/frame_0001.png ]; do sleep 0.01; "
                             "done; kill -9 $!; wait $!";
  ASSERT_NE(std::system(killed.c_str()), 0);
  EXPECT_FALSE(fs::exists(folder_ / "w/frame_0039.png"));
  const Outcome outcome = run(walk);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("walk        40 frames"));
  std::size_t files = 0;
  for (const auto& file : fs::directory_iterator(folder_ / "w")) {
    ++files;
    EXPECT_NE(file.path().filename().string()[0], '.') << file.path();
  }
  EXPECT_EQ(files, 41u);
}

TEST_F(App, BadWalksAreRefused) {
  expect_mistake(std::string("walk blocks --frames 0") + kModel,
                 "dynrt: --frames 0: a walk has 1 to 9999 frames\n");
  expect_mistake(std::string("walk blocks --out a.png") + kModel,
                 "dynrt: --out a.png: a walk is written to a folder, as PNG files, or to a .gif "
                 "file\n");
  expect_mistake(std::string("walk blocks --out a.JPG") + kModel,
                 StartsWith("dynrt: --out a.JPG: a walk is written to a folder"));
  expect_mistake(std::string("walk blocks --out w --json w/walk.json") + kModel,
                 HasSubstr("w/walk"));
  expect_mistake(
      std::string("walk blocks --out w --json w") + kModel,
      StartsWith("dynrt: --json w: this file lies in the folder where the walk keeps its frames"));
  expect_mistake(std::string("walk blocks --out no/where") + kModel,
                 "dynrt: no/where: there is no folder 'no'; create it or name a file elsewhere\n");
  expect_mistake(std::string("walk blocks --from 3 --to 2") + kModel,
                 "dynrt: --from 3 and --to 2: the walk must begin at 0 seconds or later and end "
                 "after it begins\n");
}

TEST_F(App, ALightThatSomethingMovesOverIsRefused) {
  std::ofstream(folder_ / "m.json") << R"({"about": "a ball passes a lamp",
    "objects": [{"name": "ball", "parts": [
      {"generate": "sphere", "colour": [1, 1, 1], "radius": 1, "subdivisions": 1}]}],
    "instances": [{"object": "ball", "name": "ball", "position": [5, 0, 0], "motion": {"keys": [
      {"time": 0, "position": [5, 0, 0]}, {"time": 2, "position": [-5, 0, 0]}]}}],
    "lights": [{"name": "lamp", "position": [0.1, 0.2, 0]}],
    "camera": {"position": [0, 0, 9], "look_at": [0, 0, 0]}})";
  expect_mistake("walk m.json --config lit --board model --frames 3 --size 8x8 --out w",
                 testing::AllOf(HasSubstr("light 'lamp'"), HasSubstr("(after 1 seconds)\n")));
}

}  // namespace
}  // namespace dynrt::host
