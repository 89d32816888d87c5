// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The program as a user meets it: what it writes, what it says, and what bad input gets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/app/run_program.h"

namespace dynrt::host {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr char kModel[] = " --config model_only --board model --size 32x24 ";
constexpr char kRtl[] = " --config stand_in --size 32x24 ";

class App : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::path(testing::TempDir()) /
        (std::string("dynrt_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments, const std::string& stdout_to = {}) const {
    return run_program(DYNRT_PROGRAM, arguments, folder_, stdout_to);
  }
  /// The user's mistake: one sentence, exit code 2, nothing left behind.
  void expect_mistake(const std::string& arguments, const testing::Matcher<std::string>& sentence) {
    const std::vector<std::string> before = names_in(folder_);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_THAT(outcome.err, sentence) << arguments;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_EQ(outcome.files, before) << arguments;
  }

  fs::path folder_;
};

TEST_F(App, HelpTellsEverything) {
  const Outcome program = run("--help");
  EXPECT_EQ(program.code, 0);
  for (const char* word : {"render", "walk", "compare", "info", "report", "Exit codes"}) {
    EXPECT_THAT(program.out, HasSubstr(word));
  }
  const Outcome render = run("render --help");
  EXPECT_EQ(render.code, 0);
  for (const char* flag :
       {"--board",    "--config", "--size",     "--out",     "--trace",  "--packets",
        "--lines",    "--order",  "--position", "--look-at", "--up",     "--fov",
        "--json",     "--clock",  "--timeout",  "--light",   "--mirror", "--reflections",
        "--scan-out", "office",   "stand_in"}) {
    EXPECT_THAT(render.out, HasSubstr(flag));
  }
}

TEST_F(App, RendersOnTheModel) {
  const Outcome outcome = run(std::string("render blocks") + kModel + "--json figures.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());  // no progress in a pipe
  EXPECT_THAT(outcome.files, ElementsAre("blocks.png", "figures.json"));
  EXPECT_THAT(outcome.out, HasSubstr("image       blocks.png, 32x24"));
  EXPECT_THAT(outcome.out, ContainsRegex("scene       blocks: [0-9]+ triangles in 3 objects"));
  EXPECT_THAT(outcome.out, HasSubstr("pixels      768, of which"));
  EXPECT_THAT(outcome.out, ContainsRegex("node cache +[0-9,]+ +[0-9.]+ %"));

  const auto json = nlohmann::json::parse(text_of(folder_ / "figures.json"));
  EXPECT_EQ(json["frame"]["width"], 32);
  EXPECT_TRUE(json["frame"]["cycles"].is_null());
  EXPECT_GT(json["frame"]["hits"], 100);
  EXPECT_LT(json["frame"]["hits"], 768);
  EXPECT_GT(json["frame"]["units"]["node_lookup"]["transactions"], 768);
  EXPECT_GT(json["frame"]["caches"]["node"]["hit_rate"], 0.5);
  EXPECT_GT(json["scene"]["memory"]["nodes"], 100);
}

TEST_F(App, ShowsTheImageOnTheDisplay) {
  const Outcome outcome =
      run(std::string("render blocks") + kRtl + "--scan-out display.png --json figures.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("blocks.png", "display.png", "figures.json"));
  EXPECT_THAT(outcome.out,
              HasSubstr("scan-out    display.png, 640x480, 3 clocks a pixel, 67.46 displays per "
                        "second; 0 pixels differ from the frame's"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "figures.json"));
  EXPECT_EQ(json["scan_out"]["image"], "display.png");
  EXPECT_EQ(json["scan_out"]["pixels_different"], 0);

  expect_mistake(std::string("render blocks") + kModel + "--scan-out display.png",
                 StartsWith("dynrt: board model of configuration model_only has no scan-out; take "
                            "board rtl and a configuration with the key scan_out"));
  expect_mistake("render blocks --config stand_in --size 641x20 --scan-out display.png",
                 StartsWith("dynrt: a picture of 641x20 does not fit the display of 640x480"));
  expect_mistake(std::string("render blocks") + kRtl + "--scan-out display.bmp",
                 HasSubstr("display.bmp"));
}

TEST_F(App, TheOrderOfRaysAndThePacketsInFlightDoNotChangeTheImage) {
  run(std::string("render blocks") + kModel + "--out a.png");
  run(std::string("render blocks") + kModel + "--out b.png --order scanline --packets 3 --lines 4");
  run(std::string("render blocks") + kModel + "--out c.png --fov 20");
  EXPECT_FALSE(text_of(folder_ / "a.png").empty());
  EXPECT_EQ(text_of(folder_ / "a.png"), text_of(folder_ / "b.png"));
  EXPECT_NE(text_of(folder_ / "a.png"), text_of(folder_ / "c.png"));
}

TEST_F(App, RendersOnTheVerilogWithWaveforms) {
  const Outcome outcome = run(std::string("render blocks") + kRtl +
                              "--out image.exr --trace waves.fst --json f.json --clock 100");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("f.json", "image.exr", "waves.fst"));
  EXPECT_THAT(outcome.out, ContainsRegex("frame       [0-9,]+ cycles, [0-9.]+ frames per second at "
                                         "100 MHz, [0-9.]+ rays per clock"));
  EXPECT_THAT(outcome.out, ContainsRegex("simulation  [0-9.]+ s, [0-9,]+ clocks per second"));
  EXPECT_THAT(outcome.out, ContainsRegex("bus         [0-9,]+ bytes written"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "f.json"));
  // One word a clock, so all but the start-up does work.
  EXPECT_EQ(json["frame"]["units"]["stand_in"]["transactions"], 768);
  EXPECT_GT(json["frame"]["units"]["stand_in"]["utilisation"], 0.8);
}

TEST_F(App, CompareFindsTheStandInsDifferences) {
  const Outcome outcome = run("compare blocks --config stand_in --size 32x24 --json f.json");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("f.json"));
  EXPECT_THAT(outcome.out,
              ContainsRegex("compared    768 hit records, 768 pixels, 0 counters of rtl "
                            "and model: 768 \\+ [0-9]+ \\+ [1-9][0-9]* differ"));
  EXPECT_THAT(outcome.out, ContainsRegex("first difference: pixel \\(0, 0\\), [a-z]+: rtl has .*, "
                                         "model has "));
  const auto json = nlohmann::json::parse(text_of(folder_ / "f.json"));
  EXPECT_EQ(json["comparison"]["identical"], false);
  EXPECT_EQ(json["comparison"]["different_hits"], 768);
  EXPECT_EQ(json["comparison"]["first"]["x"], 0);
}

TEST_F(App, InfoShowsTheScene) {
  const Outcome outcome = run("info blocks --json info.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("info.json"));
  EXPECT_THAT(outcome.out, ContainsRegex("trees       [0-9,]+ nodes, [0-9,]+ list entries, [0-9]+ "
                                         "levels of instances and [0-9]+ of triangles, built in"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "info.json"));
  EXPECT_EQ(json["objects"].size(), 3u);
  EXPECT_EQ(json["memory"]["matrix_limit"], 131072);
}

TEST_F(App, ReportsCountWhatOtherCoresWouldDo) {
  const Outcome outcome = run("report overlap blocks --size 32x24 --json f.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("f.json"));
  EXPECT_THAT(outcome.out, ContainsRegex("hierarchical tree +70.3 +[0-9.]+ +[0-9.]+ +2.0"));
  EXPECT_THAT(outcome.out, HasSubstr("pixels that differ between the rows: 0\n"));
  EXPECT_EQ(nlohmann::json::parse(text_of(folder_ / "f.json"))["rows"].size(), 5);
  expect_mistake("report",
                 "dynrt: report: which one is missing; the reports are overlap, mailbox "
                 "and clipping\n");
  expect_mistake("report paint", HasSubstr("was not expected: paint; dynrt report --help lists"));
  expect_mistake("report mailbox blocks --size 33x24",
                 "dynrt: --size 33x24: work is counted for packets of 2x2 rays, so both must be "
                 "even, above 0 and at most 4096\n");
}

TEST_F(App, WhatTheUserShouldKnowIsNoted) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "m.obj")
      << "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n";
  const std::string note =
      "m.obj: the material file 'gone.mtl' is not there, so its materials are grey";
  for (const std::string command : {"info m.obj",
                                    "render m.obj --config model_only --board model "
                                    "--size 8x8",
                                    "compare m.obj --config stand_in "
                                    "--size 8x8"}) {
    const Outcome outcome = run(command + " --json f.json");
    EXPECT_THAT(outcome.out, HasSubstr("\nnote        " + note + "\n")) << command;
    EXPECT_THAT(
        outcome.out,
        HasSubstr("scene       m: 1 triangle in 1 object, 1 instance (1 point or line left out)\n"))
        << command;
    const auto json = nlohmann::json::parse(text_of(folder_ / "f.json"));
    EXPECT_EQ((command[0] == 'i' ? json : json["scene"])["notes"], nlohmann::json({note}));
  }
}

constexpr char kLit[] = " --config lit --board model --size 32x24 ";

TEST_F(App, FlagsOfLightAndMirrorChangeTheImage) {
  const std::string render = std::string("render blocks") + kLit;
  const std::string kFlags[] = {"",
                                "--light 4,7,5",
                                "--light 4,7,5:1,0.5,0:3",
                                "--light 4,7,5 --light -6,5,3",
                                "--mirror box",
                                "--mirror box=0.2",
                                "--mirror box --reflections 0"};
  std::vector<std::string> images;
  for (const std::string& flags : kFlags) {
    const Outcome outcome = run(render + flags);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    images.push_back(text_of(folder_ / "blocks.png"));
  }
  std::ranges::sort(images);
  EXPECT_TRUE(std::ranges::adjacent_find(images) == images.end()) << "two are the same";
}

TEST_F(App, LightsAndMirrorsWithoutRaysForThemAreRefused) {
  const auto mistake = [&](const std::string& flag, const std::string& lacks) {
    expect_mistake(std::string("render blocks") + kModel + flag,
                   "dynrt: " + flag.substr(0, flag.find(' ')) +
                       ": configuration model_only has no " + lacks + "; take --config lit\n");
  };
  mistake("--light 1,2,3", "light rays");
  mistake("--mirror box", "reflected rays");
  mistake("--reflections 1", "reflected rays");
  expect_mistake(
      std::string("render blocks") + kLit + "--reflections 8",
      "dynrt: --reflections 8: configuration lit traces at most 7 reflections of a ray\n");
  const Outcome lamps = run(std::string("render lamps") + kModel);
  EXPECT_EQ(lamps.code, 0);
  EXPECT_THAT(lamps.out,
              HasSubstr("note        the scene has 2 lights, but configuration model_only "
                        "has no light rays and lights it from the eye; take --config "
                        "lit\n"));
  EXPECT_THAT(lamps.out,
              HasSubstr("note        the scene has 2 mirrors, but configuration model_only "
                        "has no reflected rays; take --config lit\n"));
}

TEST_F(App, BadLightsAndMirrorsAreRefused) {
  const std::string render = std::string("render blocks") + kLit;
  for (const std::string light :
       {"1,2,3:0,0,0", "1,2,3:1,1,-1", "1,2,3:1,1,1:0", "1,2,3:1,1,1:x"}) {
    expect_mistake(render + "--light " + light,
                   "dynrt: --light " + light +
                       ": write X,Y,Z[:R,G,B[:INTENSITY]] with a colour that is not negative nor "
                       "black and an intensity above zero, for example 1,3,2:1,0.9,0.8:5\n");
  }
  expect_mistake(render + "--light 1,2",
                 "dynrt: --light 1,2: write three numbers separated by commas, for example "
                 "1,2.5,-3\n");
  for (const std::string mirror : {"ground=2", "ground=", "ground=-0.1", "=x"}) {
    expect_mistake(render + "--mirror " + mirror,
                   "dynrt: --mirror " + mirror +
                       ": write MATERIAL[=PART] with a part from 0 to 1, for example chrome=0.9\n");
  }
  expect_mistake(
      render + "--mirror glass",
      testing::MatchesRegex("dynrt: scene 'blocks' has no material 'glass'; it has .*\n"));
  expect_mistake(
      render + "--light 0,1.7,0",
      testing::MatchesRegex("dynrt: scene 'blocks': light '--light 0,1.7,0' at \\(0, 1.7, 0\\) "
                            "lies inside 'ball as it is', which is closed and lets none "
                            "of it out; move the light\n"));
  // The configuration that has no light rays does not mind.
  EXPECT_EQ(run("info blocks --light 0,1.7,0").code, 0);
}

TEST_F(App, WalksIntoAFolder) {
  const std::string walk = std::string("walk blocks --frames 3 --out w") + kModel;
  const Outcome outcome = run(walk + "--json f.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("f.json", "w"));
  EXPECT_THAT(outcome.out, HasSubstr("note        nothing moves in the scene, nor does its camera: "
                                     "it goes round the scene's centre once\n"));
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
  EXPECT_THAT(resumed.out, HasSubstr("walk        3 frames, 2 of them there already\n"));
  EXPECT_EQ(text_of(folder_ / "w/frame_0001.png"), second);
  EXPECT_NE(text_of(folder_ / "w/frame_0000.png"), second);

  const Outcome other = run(walk + "--fov 30");
  EXPECT_EQ(other.code, 2);
  EXPECT_EQ(other.err,
            "dynrt: w: holds frames of another walk, with --fov '' where this one has '30'; name "
            "another --out, or give --again to begin anew\n");
  EXPECT_EQ(run(walk + "--fov 30 --again").code, 0);
  EXPECT_NE(text_of(folder_ / "w/frame_0001.png"), second);
}

TEST_F(App, WalksIntoAGif) {
  const std::string walk = std::string("walk blocks --frames 2") + kModel;
  // As if it had been interrupted after its first frame.
  EXPECT_EQ(run(walk + "--out blocks.gif.frames").code, 0);
  fs::remove(folder_ / "blocks.gif.frames/frame_0001.png");
  const Outcome outcome = run(walk);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("walk        2 frames, 1 of them there already\n"));
  EXPECT_THAT(outcome.files, ElementsAre("blocks.gif")) << "the frames' folder is gone";
  EXPECT_TRUE(text_of(folder_ / "blocks.gif").starts_with("GIF89a"));
}

TEST_F(App, AWalkThatIsKilledGoesOn) {
  const std::string walk = std::string("walk blocks --frames 40 --out w") + kModel;
  // Killed at its second picture, without a chance to tidy up.
  const std::string killed = "cd '" + folder_.string() + "' && { '" DYNRT_PROGRAM "' " + walk +
                             " > /dev/null & } && while [ ! -e w/frame_0001.png ]; do sleep 0.01; "
                             "done; kill -9 $!; wait $!";
  fs::create_directories(folder_);
  ASSERT_NE(std::system(killed.c_str()), 0);
  EXPECT_FALSE(fs::exists(folder_ / "w/frame_0039.png"));
  const Outcome outcome = run(walk);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("walk        40 frames, [0-9]+ of them there already\n"));
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
  expect_mistake(std::string("walk blocks --out w --json w") + kModel,
                 StartsWith("dynrt: --json w: lies where the walk keeps its frames"));
  expect_mistake(std::string("walk blocks --out no/where") + kModel,
                 "dynrt: no/where: there is no folder 'no'; create it or name a file elsewhere\n");
  expect_mistake(std::string("walk blocks --from 3 --to 2") + kModel,
                 "dynrt: --from 3 and --to 2: the walk must begin at 0 seconds or later and end "
                 "after it begins\n");
}

TEST_F(App, ALightThatSomethingMovesOverIsRefused) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "m.json") << R"({"about": "a ball passes a lamp",
    "objects": [{"name": "ball", "parts": [{"generate": "sphere", "radius": 1, "subdivisions": 1}]}],
    "instances": [{"object": "ball", "name": "ball", "position": [5, 0, 0], "motion": {"keys": [
      {"time": 0, "position": [5, 0, 0]}, {"time": 2, "position": [-5, 0, 0]}]}}],
    "lights": [{"name": "lamp", "position": [0.1, 0.2, 0]}],
    "camera": {"position": [0, 0, 9], "look_at": [0, 0, 0]}})";
  expect_mistake("walk m.json --config lit --board model --frames 3 --size 8x8 --out w",
                 testing::AllOf(HasSubstr("light 'lamp'"), HasSubstr("(after 1 seconds)\n")));
}

TEST_F(App, ABoardThatNeverInterruptsIsATimeOut) {
  expect_mistake(
      std::string("render blocks") + kRtl + "--timeout 100",
      "dynrt: board rtl: no interrupt and no pixel for 100 clocks (--timeout allows more); "
      "0 pixels are written, status 0x1, the units stand at without input: stand_in 0\n");
}

TEST_F(App, BadSizesAreRefused) {
  const auto limit =
      ": an image has 1 to 1024 pixels a side and at most 349525 in all, which is what the board's "
      "framebuffer and hit records hold\n";
  expect_mistake("render blocks --size 0x24", std::string("dynrt: --size 0x24") + limit);
  expect_mistake("render blocks --size 32x0", std::string("dynrt: --size 32x0") + limit);
  expect_mistake("compare blocks --size 1025x2", std::string("dynrt: --size 1025x2") + limit);
  expect_mistake("info blocks --size 1024x1024", std::string("dynrt: --size 1024x1024") + limit);
  for (const std::string size : {"32", "x24", "32x24x3", "-1x2", "99999999999x1"}) {
    expect_mistake(
        "render blocks --size=" + size,
        "dynrt: --size " + size + ": write WIDTHxHEIGHT in pixels, for example 512x384\n");
  }
}

TEST_F(App, WhatIsUnknownIsNamed) {
  expect_mistake("render blocks --config huge",
                 "dynrt: --config huge: unknown; this build has model_only, stand_in, lit\n");
  expect_mistake("render blocks --config stand_in --board fpga",
                 "dynrt: --board fpga: unknown; the boards are rtl and model\n");
  expect_mistake("render blocks --config model_only",
                 "dynrt: --board rtl: the Verilog of configuration model_only is not part of this "
                 "build; configure with -DDYNRT_RTL=ON or take --board model\n");
  expect_mistake("render blocks --order hilbert",
                 "dynrt: --order hilbert: unknown; the orders are morton and scanline\n");
  expect_mistake("render blocks --speed 9",
                 testing::AllOf(StartsWith("dynrt: "), HasSubstr("--speed"),
                                HasSubstr("; dynrt render --help lists what there is\n")));
  expect_mistake(
      "paint blocks",
      "dynrt: paint: unknown; the commands are render, walk, compare, info and report\n");
  expect_mistake("", HasSubstr("dynrt --help lists what there is"));
  expect_mistake("render", testing::AllOf(HasSubstr("SCENE"), HasSubstr("dynrt render --help")));
  expect_mistake("render no_such_scene --config stand_in", HasSubstr("no_such_scene"));
}

TEST_F(App, WhatTheConfigurationLacksIsRefused) {
  expect_mistake("render blocks --config stand_in --packets 5",
                 "dynrt: --packets 5: configuration stand_in holds 1 to 4 packets\n");
  expect_mistake("render blocks --config model_only --size 8x8",
                 StartsWith("dynrt: --config model_only: is the native model alone, so it has no "
                            "board rtl; take one of those with Verilog, stand_in"));
  expect_mistake("render blocks --config stand_in --packets 0",
                 "dynrt: --packets 0: configuration stand_in holds 1 to 4 packets\n");
  expect_mistake(
      "render blocks --config stand_in --lines 3",
      "dynrt: --lines 3: the caches of configuration stand_in have 1, 2, 4 up to 16 lines\n");
  expect_mistake("render blocks --config stand_in --clock 0",
                 "dynrt: --clock 0: the clock is a number of MHz above zero\n");
  expect_mistake("render blocks --config stand_in --clock inf",
                 "dynrt: --clock: inf is not a finite number; dynrt render --help lists what there "
                 "is\n");
  for (const std::string flag : {"--packets", "--lines", "--timeout"}) {
    expect_mistake("render blocks --config stand_in " + flag + "=-1",
                   "dynrt: " + flag +
                       ": -1 is not a whole number from 0 to 4294967295; dynrt "
                       "render --help lists what there is\n");
  }
  expect_mistake("render blocks --config stand_in --timeout 0",
                 "dynrt: --timeout 0: the board needs at least one clock\n");
}

TEST_F(App, BadCamerasAreRefused) {
  expect_mistake("render blocks --config stand_in --position 1,2",
                 "dynrt: --position 1,2: write three numbers separated by commas, for example "
                 "1,2.5,-3\n");
  expect_mistake("info blocks --look-at a,b,c",
                 "dynrt: --look-at a,b,c: write three numbers separated by commas, for example "
                 "1,2.5,-3\n");
  expect_mistake("info blocks --fov 180", HasSubstr("field of view"));
  expect_mistake("info blocks --fov wide",
                 "dynrt: --fov: wide is not a finite number; dynrt info --help lists what there "
                 "is\n");
  for (const std::string numbers : {"1e300,0,0", "0,inf,0", "0,0,nan"}) {
    expect_mistake(
        "info blocks --position " + numbers,
        "dynrt: --position " + numbers + ": the numbers must lie within -6.07e+09 and 6.07e+09\n");
  }
}

TEST_F(App, OutputsThatCannotBeWrittenAreRefused) {
  expect_mistake(
      "render blocks --config stand_in --out image.jpg",
      "dynrt: image.jpg: the image format '.jpg' is not one of dynrt's; the name must end "
      "in .png or .exr\n");
  expect_mistake(
      "render blocks --config stand_in --out no/where/image.png",
      "dynrt: no/where/image.png: there is no folder 'no/where'; create it or name a file "
      "elsewhere\n");
  expect_mistake("render blocks --config stand_in --out /proc/image.png",
                 "dynrt: /proc/image.png: cannot be written (its folder takes no files); name a "
                 "file in a folder that can\n");
  expect_mistake("render blocks --config stand_in --json no/where/f.json",
                 HasSubstr("no/where/f.json: there is no folder 'no/where'"));
  expect_mistake("info blocks --json no/where/f.json",
                 HasSubstr("no/where/f.json: there is no folder 'no/where'"));
  expect_mistake("render blocks --config stand_in --trace no/where/f.fst",
                 HasSubstr("no/where/f.fst: there is no folder 'no/where'"));
  expect_mistake("render blocks --config stand_in --board model --trace f.fst",
                 "dynrt: --trace: only --board rtl has signals to record; leave the flag out or "
                 "choose that board\n");
  expect_mistake("render no_such_scene --config stand_in --trace f.fst",
                 HasSubstr("no_such_scene"));
}

TEST_F(App, OutputsAreCheckedBeforeTheSceneIsLoaded) {
  // The default name too: a folder named like it is in its way.
  fs::create_directories(folder_ / "gone.png");
  const Outcome outcome = run("render gone --config stand_in");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err,
            "dynrt: gone.png: cannot be written (Is a directory); name a file in a folder that "
            "can\n");
}

TEST_F(App, OutputsOfOneNameAreRefused) {
  expect_mistake("render blocks --config stand_in --out a.png --json ./a.png",
                 "dynrt: --json ./a.png: --out writes the same file; name another one\n");
  expect_mistake("render blocks --config stand_in --json blocks.png",
                 "dynrt: --json blocks.png: --out writes the same file; name another one\n");
  expect_mistake("render blocks --config stand_in --out a.png --trace a.png",
                 "dynrt: --trace a.png: --out writes the same file; name another one\n");
}

TEST_F(App, AReportThatCannotBePrintedIsAnError) {
  for (const char* arguments : {"info blocks", "--help"}) {
    // The last redirection is the one that counts.
    const Outcome outcome = run(arguments, "/dev/full");
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.err,
              "dynrt: the report cannot be printed (No space left on device); free some space or "
              "send it elsewhere\n");
  }
}

TEST_F(App, WaveformsOfATimeOutAreKept) {
  const Outcome outcome =
      run(std::string("render blocks") + kRtl + "--timeout 100 --trace waves.fst");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.files, ElementsAre("waves.fst"));
}

}  // namespace
}  // namespace dynrt::host
