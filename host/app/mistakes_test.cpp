// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What mistakes get: a sentence, an exit code, nothing left behind.
#include "host/app/program_test.h"

namespace dynrt::host {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

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
      "dynrt: --reflections: configuration lit traces at most 7 reflections of a ray, not 8\n");
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
                       ": write X,Y,Z[:R,G,B[:INTENSITY]] with a colour that is neither negative "
                       "nor black, and an intensity above zero, for example 1,3,2:1,0.9,0.8:5\n");
  }
  expect_mistake(render + "--light 1,2",
                 "dynrt: --light 1,2: write three numbers separated by commas, for example "
                 "1,2.5,-3\n");
  for (const std::string mirror : {"ground=2", "ground=", "ground=-0.1", "=x"}) {
    expect_mistake(render + "--mirror " + mirror,
                   "dynrt: --mirror " + mirror +
                       ": write MATERIAL[=PART] with a part from 0 to 1, for example chrome=0.9\n");
  }
  expect_mistake(render + "--mirror glass",
                 testing::MatchesRegex(
                     "dynrt: scene 'blocks' has no material 'glass'; its materials are .*\n"));
  expect_mistake(
      render + "--light 0,1.7,0",
      testing::MatchesRegex(
          "dynrt: scene 'blocks': light '--light 0,1.7,0' at \\(0, 1.7, 0\\) lies inside 'ball as "
          "it is', a closed object that no light leaves; move the light\n"));
  // The configuration that has no light rays does not mind.
  EXPECT_EQ(run("info blocks --light 0,1.7,0").code, 0);
}

TEST_F(App, ABoardThatNeverInterruptsIsATimeOut) {
  expect_mistake(
      std::string("render blocks") + kRtl + "--timeout 100",
      "dynrt: board rtl: no interrupt and no pixel for 100 clocks (a longer timeout allows more); "
      "0 pixels are written, the status is 0x1, the units: without input: stand_in 0\n");
}

TEST_F(App, ATimeOutNeedsAClock) {
  for (const std::string command : {"render", "walk"}) {
    expect_mistake(command + " blocks" + kModel + "--timeout 100",
                   "dynrt: --timeout 100: board model counts no clocks of its own, so it needs no "
                   "timeout; take board rtl or leave the timeout out\n");
  }
}

TEST_F(App, FoldersAreNoFiles) {
  fs::create_directories(folder_ / "models");
  fs::create_directories(folder_ / "made.json");
  expect_mistake(std::string("render models") + kModel,
                 "dynrt: models: this is a folder, but a scene is a file; give the path of a file "
                 "in it, such as models/model.obj\n");
  for (const std::string folder : {"models", "made.json"}) {
    expect_mistake("render blocks --board model --config " + folder,
                   "dynrt: configuration " + folder +
                       ": this is a folder, but a configuration is a file; name one, such as the " +
                       folder + "/configuration.json that dynrt specialise writes\n");
  }
}

TEST_F(App, BadSizesAreRefused) {
  const auto sentence = [](const std::string& size) {
    return "dynrt: --size: an image of " + size +
           " pixels is impossible: it has 1 to 1024 pixels a side and at most 349525 in all; the "
           "board's framebuffer and hit records hold no more\n";
  };
  expect_mistake("render blocks --size 0x24", sentence("0x24"));
  expect_mistake("render blocks --size 32x0", sentence("32x0"));
  expect_mistake("compare blocks --size 1025x2", sentence("1025x2"));
  expect_mistake("info blocks --size 1024x1024", sentence("1024x1024"));
  for (const std::string size : {"32", "x24", "32x24x3", "-1x2", "99999999999x1"}) {
    expect_mistake(
        "render blocks --size=" + size,
        "dynrt: --size " + size + ": write WIDTHxHEIGHT in pixels, for example 512x384\n");
  }
}

TEST_F(App, APixelLiesInTheImageAndGoesToAFile) {
  for (const std::string pixel : {"3", "3,", "x,1", "64,0", "0,48", "-1,0", "1,2,3"}) {
    expect_mistake("render blocks --size 64x48 --json figures.json --pixel=" + pixel,
                   "dynrt: --pixel " + pixel +
                       ": write the numbers of a pixel of this image, from 0,0 to 63,47\n");
  }
  for (const std::string flags : {"", " --no-hits --json figures.json"}) {
    expect_mistake("render blocks --pixel 1,2" + flags,
                   "dynrt: --pixel 1,2: its hit record goes to the file of --json; name one and "
                   "leave --no-hits out\n");
  }
}

TEST_F(App, WhatIsUnknownIsNamed) {
  expect_mistake("render blocks --config huge",
                 "dynrt: configuration huge: there is no such configuration; name one of "
                 "model_only, stand_in, lit, or a file FILE.json or FILE.so\n");
  expect_mistake("render blocks --config stand_in --board fpga",
                 "dynrt: board fpga: there is no such board; the boards are rtl, model, ulx3s "
                 "and serial:DEVICE\n");
  expect_mistake("render blocks --order hilbert",
                 "dynrt: --order hilbert: unknown; the orders are morton and scanline\n");
  expect_mistake("render blocks --speed 9",
                 testing::AllOf(StartsWith("dynrt: "), HasSubstr("--speed"),
                                HasSubstr("; dynrt render --help lists what there is\n")));
  expect_mistake("paint blocks",
                 "dynrt: paint: there is no such command; the commands are render, walk, compare, "
                 "info, report, choose, measure, stress, needs, specialise and view\n");
  expect_mistake("stress corners --config model_only",
                 StartsWith("dynrt: there is no stress case or group 'corners'; give one of these, "
                            "or the part before the slash: slivers/aspect_1e2, "));
  expect_mistake("stress --format 7x12 --config model_only",
                 "dynrt: --format 7x12: write the bits of exponent and mantissa, for example "
                 "7,12\n");
  expect_mistake("", HasSubstr("dynrt --help lists what there is"));
  expect_mistake("render", testing::AllOf(HasSubstr("SCENE"), HasSubstr("dynrt render --help")));
  expect_mistake("render no_such_scene --config stand_in", HasSubstr("no_such_scene"));
}

TEST_F(App, WhatTheConfigurationLacksIsRefused) {
  expect_mistake("render blocks --config stand_in --packets 65",
                 "dynrt: --packets: configuration stand_in holds 1 to 64 packets, not 65\n");
  expect_mistake("render blocks --config model_only --size 8x8",
                 StartsWith("dynrt: configuration model_only: it has only the native model, so it "
                            "has no board rtl; take a configuration with Verilog (stand_in)"));
  expect_mistake("render blocks --config stand_in --packets 0",
                 "dynrt: --packets: configuration stand_in holds 1 to 64 packets, not 0\n");
  expect_mistake(
      "render blocks --config stand_in --lines 3",
      "dynrt: --lines: the caches of configuration stand_in have 1, 2, 4 up to 512 lines, not 3\n");
  expect_mistake("render blocks --config stand_in --memory-latency 30",
                 StartsWith("dynrt: --memory-latency: the scene of configuration stand_in lies in "
                            "banks of SRAM"));
  expect_mistake("render blocks --config stand_in --row-clocks 5",
                 StartsWith("dynrt: --row-clocks: the scene of configuration stand_in lies in "));
  expect_mistake("render blocks --config stand_in --clock 0",
                 "dynrt: --clock 0: the clock is a number of MHz above zero\n");
  expect_mistake("render blocks --config stand_in --clock inf",
                 "dynrt: --clock: inf is not a finite number; dynrt render --help lists what there "
                 "is\n");
  expect_mistake("render blocks --config stand_in --device ecp5-25",
                 StartsWith("dynrt: --device ecp5-25: no core was placed on such a device, so it "
                            "has no clock; those with a clock: ecp5-85"));
  expect_mistake("walk blocks --config stand_in --grade 9",
                 StartsWith("dynrt: --grade 9: no core was placed on ecp5-85 of this grade, so it "
                            "has no clock; those with a clock: 6"));
  for (const std::string flag : {"--packets", "--lines", "--timeout"}) {
    expect_mistake("render blocks --config stand_in " + flag + "=-1",
                   "dynrt: " + flag +
                       ": -1 is not a whole number from 0 to 4294967295; dynrt "
                       "render --help lists what there is\n");
  }
  expect_mistake("render blocks --config stand_in --timeout 0",
                 "dynrt: --timeout 0: the board needs at least one clock\n");
}

TEST_F(App, BadWishesForACoreAreRefused) {
  const auto mistake = [&](const std::string& flags, const testing::Matcher<std::string>& what) {
    expect_mistake("specialise office --config model_only --no-hardware " + flags, what);
  };
  for (const std::string none : {"-1", "nan", "inf"}) {
    mistake("--max-slowdown=" + none,
            "dynrt: --max-slowdown " + none + ": a part in percent, 0 or more\n");
  }
  for (const std::string none : {"0", "nan"}) {
    mistake("--max-error " + none, "dynrt: --max-error " + none + ": must be a number above 0\n");
  }
  mistake("--measure primary.t_p99",
          "dynrt: --measure primary.t_p99: there is no bound; --max-error says how large this "
          "error may be\n");
  mistake("--keep speed",
          StartsWith("dynrt: there is no key 'speed' to keep; the keys are pipelines, "));
  mistake("--jobs 0", HasSubstr("--jobs: at least one is needed"));
  mistake("--out /dev/null", StartsWith("dynrt: --out /dev/null: cannot be written ("));
  mistake("--json /nowhere/f.json", HasSubstr("/nowhere"));
  mistake("--fov wide", StartsWith("dynrt: --fov: wide is not a finite number; dynrt specialise "));
  expect_mistake("specialise nowhere.obj --no-hardware", HasSubstr("nowhere.obj"));
  expect_mistake("specialise office --device fpga",
                 StartsWith("dynrt: --device fpga: unknown; the devices are ecp5-85, "));
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
  expect_mistake("render blocks --config stand_in --out image.jpg",
                 "dynrt: image.jpg: dynrt does not write the image format '.jpg'; the name must "
                 "end in .png or .exr\n");
  expect_mistake(
      "render blocks --config stand_in --out no/where/image.png",
      "dynrt: no/where/image.png: there is no folder 'no/where'; create it or name a file "
      "elsewhere\n");
  expect_mistake("render blocks --config stand_in --out /proc/image.png",
                 "dynrt: /proc/image.png: cannot write this file (its folder cannot be written); "
                 "name a file in a folder that can be written\n");
  expect_mistake("render blocks --config stand_in --json no/where/f.json",
                 HasSubstr("no/where/f.json: there is no folder 'no/where'"));
  expect_mistake("info blocks --json no/where/f.json",
                 HasSubstr("no/where/f.json: there is no folder 'no/where'"));
  expect_mistake("render blocks --config stand_in --trace no/where/f.fst",
                 HasSubstr("no/where/f.fst: there is no folder 'no/where'"));
  expect_mistake("render blocks --config stand_in --board model --trace f.fst",
                 "dynrt: waveforms: only board rtl has signals to record; take board rtl or leave "
                 "the waveforms out\n");
  expect_mistake("render no_such_scene --config stand_in --trace f.fst",
                 HasSubstr("no_such_scene"));
}

TEST_F(App, OutputsAreCheckedBeforeTheSceneIsLoaded) {
  // The default name too: a folder named like it is in its way.
  fs::create_directories(folder_ / "gone.png");
  const Outcome outcome = run("render gone --config stand_in");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err,
            "dynrt: gone.png: cannot write this file (Is a directory); name a file in a folder "
            "that can be written\n");
}

TEST_F(App, OutputsOfOneNameAreRefused) {
  expect_mistake("render blocks --config stand_in --out a.png --json ./a.png",
                 "dynrt: --json ./a.png: --out writes the same file; name another file\n");
  expect_mistake("render blocks --config stand_in --json blocks.png",
                 "dynrt: --json blocks.png: --out writes the same file; name another file\n");
  expect_mistake("render blocks --config stand_in --out a.png --trace a.png",
                 "dynrt: --trace a.png: --out writes the same file; name another file\n");
}

TEST_F(App, AReportThatCannotBePrintedIsAnError) {
  for (const char* arguments : {"info blocks", "--help"}) {
    // The last redirection is the one that counts.
    const Outcome outcome = run(arguments, "/dev/full");
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.err,
              "dynrt: cannot print the report (No space left on device); free some space or "
              "redirect the output to another place\n");
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
