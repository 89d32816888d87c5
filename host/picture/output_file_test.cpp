// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/picture/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "host/error.h"
#include "host/test_folder.h"

namespace dynrt::host {
namespace {

namespace fs = std::filesystem;
using testing::ThrowsMessage;

class OutputFile : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }
  std::vector<std::string> files() const { return names_in(folder_.path()); }

  const TestFolder folder_;
};

TEST_F(OutputFile, TextIsWrittenWhole) {
  write_text(path("figures.json"), "{}\n");
  EXPECT_EQ(text_of(path("figures.json")), "{}\n");
  EXPECT_THAT(files(), testing::ElementsAre("figures.json"));
}

TEST_F(OutputFile, NothingIsLeftOfWhatFailed) {
  write_text(path("figures.json"), "old");
  const auto fail = [&] {
    write_whole(path("figures.json"), [](const std::string& temporary) {
      std::ofstream(temporary) << "half";
      throw UserError("no more");
    });
  };
  EXPECT_THAT(fail, ThrowsMessage<UserError>("no more"));
  EXPECT_EQ(text_of(path("figures.json")), "old");
  EXPECT_THAT(files(), testing::ElementsAre("figures.json"));
}

/// Without the fixture, whose folder a process that is killed would leave behind.
TEST(InterruptedProgram, RemovesItsUnfinishedFiles) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const TestFolder folder("dynrt-interrupted");
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    const auto interrupted = [&] {
      UnfinishedFile kept(folder.path("kept"));
      const UnfinishedFile waves(folder.path("waves"));
      std::ofstream(folder.path("kept")) << "whole";
      std::ofstream(folder.path("waves")) << "half";
      kept.keep();
      std::raise(signal);
    };
    EXPECT_EXIT(interrupted(), testing::KilledBySignal(signal), "");
    EXPECT_THAT(names_in(folder.path()), testing::ElementsAre("kept"));
  }
}

TEST_F(OutputFile, PlacesThatCannotBeWrittenAreRefused) {
  EXPECT_THAT(
      [] { check_output_path("/proc/image.json"); },
      ThrowsMessage<UserError>("/proc/image.json: cannot write this file (its folder cannot be "
                               "written); name a file in a folder that can be written"));
  EXPECT_THAT([&] { check_output_path(path("missing/f.json")); },
              ThrowsMessage<UserError>(path("missing/f.json") + ": there is no folder '" +
                                       path("missing") + "'; create it or name a file elsewhere"));
  check_output_path(path("f.json"));
  EXPECT_TRUE(files().empty());
}

TEST_F(OutputFile, PicturesOfAnUnknownFormatAreRefused) {
  for (const std::string extension : {".jpg", ""}) {
    const Output outputs[] = {{"--json", "figures.json"}, {"--out", "image" + extension, true}};
    EXPECT_THAT(
        [&] { check_outputs(outputs); },
        ThrowsMessage<UserError>("image" + extension + ": dynrt does not write the image format '" +
                                 extension + "'; the name must end in .png or .exr"));
  }
  const Output outputs[] = {{"--out", path("image.png"), true},
                            {"--scan-out", path("d.exr"), true}};
  EXPECT_NO_THROW(check_outputs(outputs));
}

TEST_F(OutputFile, TwoOutputsOfOneNameAreRefused) {
  fs::create_directory(path("folder"));
  const Output outputs[] = {{"--out", path("a.png")}, {"--json", path("folder/../a.png")}};
  EXPECT_THAT([&] { check_outputs(outputs); },
              ThrowsMessage<UserError>("--json " + outputs[1].path +
                                       ": --out writes the same file; name another file"));
  const Output relative[] = {{"--out", "a.png"}, {"--trace", "./a.png"}};
  EXPECT_THAT(
      [&] { check_outputs(relative); },
      ThrowsMessage<UserError>("--trace ./a.png: --out writes the same file; name another file"));
  const Output others[] = {{"--out", path("a.png")}, {"--json", ""}, {"--trace", ""}};
  EXPECT_NO_THROW(check_outputs(others));
}

}  // namespace
}  // namespace dynrt::host
