// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the program does and says.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "host/app/program_test.h"
#include "host/app/scene_flags.h"

namespace dynrt::host {
namespace {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

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
        "--scan-out", "--device", "--grade",    "ecp5-85",   "office",   "stand_in"}) {
    EXPECT_THAT(render.out, HasSubstr(flag));
  }
}

TEST_F(App, SaysItsVersion) {
  const Outcome outcome = run("--version");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, testing::MatchesRegex("dynrt [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

// What takes a program long to start are the libraries that it brings: OpenImageIO alone is 250.
TEST_F(App, StartsWithFewLibraries) {
  FILE* loader = popen("LD_TRACE_LOADED_OBJECTS=1 " DYNRT_PROGRAM, "r");
  ASSERT_NE(loader, nullptr);
  int libraries = 0;
  char line[1024];
  while (std::fgets(line, sizeof line, loader) != nullptr) {
    EXPECT_THAT(std::string(line), testing::Not(HasSubstr("OpenImageIO")));
    ++libraries;
  }
  EXPECT_EQ(pclose(loader), 0);
  EXPECT_GT(libraries, 3);
  EXPECT_LT(libraries, 40);
}

TEST_F(App, RendersOnTheModel) {
  const Outcome outcome = run(std::string("render blocks") + kModel + "--json figures.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());  // no progress in a pipe
  EXPECT_THAT(outcome.files, ElementsAre("blocks.png", "figures.json"));
  EXPECT_THAT(outcome.out, HasSubstr("image       blocks.png, 32x24"));
  EXPECT_THAT(outcome.out, ContainsRegex("scene       blocks: [0-9]+ triangles in 3 objects"));
  EXPECT_THAT(outcome.out, HasSubstr("pixels      768, "));
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
  const Outcome outcome = run(std::string("render blocks") + kRtl +
                              "--scan-out display.png --json figures.json --clock 85");
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

TEST_F(App, APictureNeedsNoHitRecords) {
  run(std::string("render blocks") + kModel + "--out a.png");
  const Outcome outcome =
      run(std::string("render blocks") + kModel + "--out b.png --no-hits --json b.json");
  EXPECT_EQ(text_of(folder_ / "a.png"), text_of(folder_ / "b.png"));
  EXPECT_THAT(outcome.out, ContainsRegex("pixels      [0-9,]+, without hit records\n"));
  EXPECT_TRUE(nlohmann::json::parse(text_of(folder_ / "b.json"))["frame"]["hits"].is_null());
}

TEST_F(App, RendersOnTheVerilogWithWaveforms) {
  const Outcome outcome = run(std::string("render blocks") + kRtl +
                              "--out image.exr --trace waves.fst --json f.json --clock 100 "
                              "--packets 4 --lines 16");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("f.json", "image.exr", "waves.fst"));
  EXPECT_THAT(outcome.out, ContainsRegex("frame       [0-9,]+ cycles, [0-9.]+ frames per second at "
                                         "100 MHz, [0-9.]+ rays per clock\n"
                                         "clock       100 MHz, as --clock says\n"));
  EXPECT_THAT(outcome.out, ContainsRegex("simulation  [0-9.]+ s, [0-9,]+ clocks per second"));
  EXPECT_THAT(outcome.out, ContainsRegex("bus         [0-9,]+ bytes written"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "f.json"));
  // One word a clock, so all but the start-up does work.
  EXPECT_EQ(json["frame"]["units"]["stand_in"]["transactions"], 768);
  EXPECT_GT(json["frame"]["units"]["stand_in"]["utilisation"], 0.8);
}

TEST_F(App, StatesFramesAtThePlacedClock) {
  // The stand-in gets the slowest of the clocks on the default device and grade.
  nlohmann::json slowest;
  for (const auto& one : nlohmann::json::parse(text_of(DYNRT_CLOCKS))) {
    if (one["grade"] == "6" && (slowest.is_null() || one["mhz"] < slowest["mhz"])) slowest = one;
  }
  const double mhz = slowest["mhz"];
  const Outcome outcome = run(std::string("render blocks") + kRtl + "--json f.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(fmt::format(" frames per second at {:g} MHz, ", mhz)));
  EXPECT_THAT(outcome.out,
              HasSubstr(fmt::format("\nclock       {:g} MHz, placed: {} on Lattice LFE5U-85F, "
                                    "grade 6; stand_in was not placed and may miss it\n",
                                    mhz, slowest["configuration"].get<std::string>())));
  const auto frame = nlohmann::json::parse(text_of(folder_ / "f.json"))["frame"];
  EXPECT_EQ(frame["clock_hz"], mhz * 1e6);
  EXPECT_DOUBLE_EQ(frame["frames_per_second"].get<double>(),
                   mhz * 1e6 / frame["cycles"].get<double>());
  const auto& clock = frame["clock"];
  EXPECT_EQ(clock["mhz"], mhz);
  EXPECT_EQ(clock["placed"], true);
  EXPECT_EQ(clock["of_this_configuration"], false);
  for (const char* const field : {"configuration", "device", "grade", "lowest_mhz", "highest_mhz",
                                  "seeds", "placer", "date", "verilog"}) {
    EXPECT_EQ(clock[field], slowest[field]) << field;
  }
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

TEST_F(App, StressTellsWhatGoesWrongAgainstWhatIsAllowed) {
  const Outcome outcome =
      run("stress slivers/aspect_1e2 edges/vertices --config model_only --json f.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("f.json"));
  EXPECT_THAT(outcome.out, ContainsRegex("ok +slivers/aspect_1e2 .*: 960 rays, 960 hit; nothing "
                                         "wrong"));
  EXPECT_THAT(outcome.out, ContainsRegex("ok +edges/vertices .*; lost 15 \\(of 15 allowed\\)"));
  EXPECT_THAT(outcome.out, HasSubstr("2 cases, 1156 rays, 1141 hit; none exceed what is allowed"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "f.json"));
  EXPECT_EQ(json["cases"][1]["wrong"]["lost"], 15);
  EXPECT_EQ(json["exceeding"], 0);
}

TEST_F(App, StressRefusesAFormatByItsFlag) {
  expect_mistake("stress slivers/aspect_1e2 --format 7,99",
                 HasSubstr("dynrt: --format 7,99: key 'mantissa_bits'"));
}

TEST_F(App, StressFindsThatTheStandInTracesNoRays) {
  const Outcome outcome = run("stress slivers/aspect_1e2 --config stand_in --board rtl");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("EXCEEDS +slivers/aspect_1e2"));
  EXPECT_THAT(outcome.out, HasSubstr("; 1 exceed what is allowed"));
}

TEST_F(App, ReportsCountWhatOtherCoresWouldDo) {
  const Outcome outcome = run("report overlap blocks --size 32x24 --json f.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.files, ElementsAre("f.json"));
  EXPECT_THAT(outcome.out, ContainsRegex("hierarchical tree +70.3 +[0-9.]+ +[0-9.]+ +2.0"));
  EXPECT_THAT(outcome.out, HasSubstr("pixels that differ between the rows: 0\n"));
  EXPECT_EQ(nlohmann::json::parse(text_of(folder_ / "f.json"))["rows"].size(), 5);
  expect_mistake("report",
                 "dynrt: report: name a report; the reports are overlap, mailbox, clipping, error, "
                 "hardware and truth\n");
  expect_mistake("report paint", HasSubstr("was not expected: paint; dynrt report --help lists"));
  expect_mistake("report mailbox blocks --size 33x24",
                 "dynrt: --size 33x24: dynrt counts work for packets of 2x2 rays, so both numbers "
                 "must be even, above 0 and at most 4096\n");
}

TEST_F(App, WhatTheUserShouldKnowIsNoted) {
  std::ofstream(folder_ / "m.obj")
      << "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n";
  const std::string note = "m.obj: there is no material file 'gone.mtl', so its materials are grey";
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

TEST_F(App, ACameraThatSeesNothingIsNoted) {
  std::ofstream(folder_ / "m.obj") << "v 10 0 0\nv 12 0 0\nv 10 3 0\nf 1 2 3\n";
  const std::string render = std::string("render m.obj") + kModel;
  const std::string away = " --position 11,1,50 --look-at 11,1,90";
  const Outcome outcome = run(render + away + " --json f.json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out,
              HasSubstr("\nnote        no ray hits anything; the scene lies between "
                        "(10, 0, 0) and (12, 3, 0), and this camera sees all of it: "));
  const auto json = nlohmann::json::parse(text_of(folder_ / "f.json"));
  const std::string note = json["scene"]["notes"].at(0);
  const std::string camera = note.substr(note.find("--position"));
  const Outcome mended = run(render + camera + " --json f.json");
  EXPECT_THAT(mended.out, testing::Not(HasSubstr("no ray hits")));
  EXPECT_GT(nlohmann::json::parse(text_of(folder_ / "f.json"))["frame"]["hits"], 50);
}

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

}  // namespace
}  // namespace dynrt::host
