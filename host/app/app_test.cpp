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
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_THAT(outcome.err, sentence) << arguments;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.files, IsEmpty()) << arguments;
  }

  fs::path folder_;
};

TEST_F(App, HelpTellsEverything) {
  const Outcome program = run("--help");
  EXPECT_EQ(program.code, 0);
  for (const char* word : {"render", "compare", "info", "Exit codes"}) {
    EXPECT_THAT(program.out, HasSubstr(word));
  }
  const Outcome render = run("render --help");
  EXPECT_EQ(render.code, 0);
  for (const char* flag : {"--board", "--config", "--size", "--out", "--trace", "--packets",
                           "--lines", "--order", "--position", "--look-at", "--up", "--fov",
                           "--json", "--clock", "--timeout", "--scan-out", "office", "stand_in"}) {
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
                 "dynrt: --config huge: unknown; this build has model_only, stand_in\n");
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
  expect_mistake("paint blocks",
                 "dynrt: paint: unknown; the commands are render, compare and info\n");
  expect_mistake("", HasSubstr("dynrt --help lists what there is"));
  expect_mistake("render", testing::AllOf(HasSubstr("SCENE"), HasSubstr("dynrt render --help")));
  expect_mistake("render no_such_scene --config stand_in", HasSubstr("no_such_scene"));
}

TEST_F(App, WhatTheConfigurationLacksIsRefused) {
  expect_mistake("render blocks --config stand_in --packets 5",
                 "dynrt: --packets 5: configuration stand_in holds 1 to 4 packets\n");
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
