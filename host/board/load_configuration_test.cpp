// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/load_configuration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "host/error.h"
#include "host/test_folder.h"

namespace dynrt::host {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

class LoadConfiguration : public testing::Test {
 protected:
  std::string written(const std::string& name, const std::string& content) const {
    return folder_.write(name, content);
  }
  /// The library with a text in place of another of the same length.
  std::string with(const std::string& old, const std::string& text) const {
    std::string library = library_;
    for (std::size_t at = 0; (at = library.find(old, at)) != std::string::npos;) {
      library.replace(at, old.size(), text);
    }
    return library;
  }
  std::string of_this_build() const {
    return with(std::string(32, '0'), std::string(this_build().fingerprint));
  }

  const TestFolder folder_;
  const std::string library_ = text_of(DYNRT_LOADABLE_LIBRARY);
};

TEST_F(LoadConfiguration, TakesWhatTheBuildMadeBesideTheProgram) {
  constexpr Configuration kTable[] = {{.name = "of_a_test", .core = [] { return CoreInfo{}; }}};
  const fs::path beside = fs::path(this_build().description).parent_path() / "configurations";
  fs::create_directories(beside);
  const fs::path path = beside / "of_a_test.so";
  const auto write = [&](const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
  };
  // Of other sources it is as if it were not there: it would be made of the JSON file.
  write(library_);
  EXPECT_THAT([&] { make_board(kTable, {"model", "of_a_test", ""}); },
              ThrowsMessage<UserError>(HasSubstr("of_a_test.json: there is no such file")));
  write(of_this_build());
  EXPECT_EQ(make_board(kTable, {"model", "of_a_test", ""})->core().packets, 3u);
  fs::remove(path);
}

TEST_F(LoadConfiguration, IsNamedByItsFileAndKept) {
  const std::string path = written("mine.so", of_this_build());
  const Configuration& loaded = load_configuration(path);
  EXPECT_EQ(loaded.name, "mine");
  EXPECT_EQ(loaded.core().packets, 3u);
  EXPECT_EQ(&load_configuration(path), &loaded);
  const auto board = make_board({}, {"model", path, ""});
  EXPECT_EQ(board->core().name, "mine");
  EXPECT_EQ(board->core().packets, 3u);
}

TEST_F(LoadConfiguration, KnowsWhatALibraryWasMadeFrom) {
  const std::string path = written("special.so", of_this_build());
  const auto board = make_board({}, {"model", path, ""});
  EXPECT_TRUE(board->core().is_specialised());
  EXPECT_EQ(board->core().made_for, "sail");
  ASSERT_NE(board->core().general, nullptr);
  EXPECT_EQ(board->core().general->lights, 8u);
  EXPECT_EQ(general_of(path), "whitted");
}

TEST_F(LoadConfiguration, SaysWhyAFileIsNone) {
  const auto expect_refused = [](const std::string& path, const std::string& what) {
    EXPECT_THAT([&] { load_configuration(path); },
                ThrowsMessage<UserError>("configuration " + path + ": " + what));
  };
  expect_refused("nowhere.so", "there is no such file");
  expect_refused("nowhere.json", "there is no such file");
  constexpr char kNotWhole[] =
      "the shared library is cut off; make it again with scripts/configuration";
  expect_refused(written("text.so", "no library"), kNotWhole);
  expect_refused(written("cut.so", of_this_build().substr(0, library_.size() - 100)), kNotWhole);
  expect_refused(written("other.so", library_),
                 "it was made from other sources or by another compiler than this program; make it "
                 "again with scripts/configuration");
  expect_refused(
      written("foreign.so", with("dynrt_configuration", "other_configuration")),
      "this shared library is not a configuration of dynrt; make one with scripts/configuration");
}

TEST_F(LoadConfiguration, KnowsTheGeneralConfigurationOfAFile) {
  const std::string mine = written(
      "mine.json", R"({"like": "thesis", "stack_depth": {"value": 40, "reason": "deep trees"}})");
  const std::string special =
      written("special.json", R"({"made_for": {"value": "sail", "reason": "it was asked for"},
                                  "made_from": ")" +
                                  mine + R"(", "stack_depth": 3})");
  CoreInfo core;
  core.name = "special";
  core.made_from = mine;
  add_general(core);
  ASSERT_NE(core.general, nullptr);
  EXPECT_EQ(core.general->name, "mine");
  EXPECT_EQ(core.general->stack_depth, 40u);
  EXPECT_EQ(core.general->packets, 32u);
  EXPECT_EQ(general_of(special), mine);
  EXPECT_EQ(general_of(mine), mine);
  EXPECT_EQ(general_of("thesis"), "thesis");
}

TEST_F(LoadConfiguration, KnowsTheListedConfigurationThatAFileWasMadeFrom) {
  const std::string special =
      written("special.json", R"({"made_for": "sail", "made_from": "whitted"})");
  CoreInfo core;
  core.made_from = "whitted";
  add_general(core);
  ASSERT_NE(core.general, nullptr);
  EXPECT_EQ(core.general->lights, 8u);
  EXPECT_EQ(general_of(special), "whitted");
}

TEST_F(LoadConfiguration, WhatTheScriptRefusesIsTheUsersMistake) {
  const std::string path = written("mine.json", R"({"packets": 0})");
  EXPECT_THAT([&] { load_configuration(path); },
              ThrowsMessage<UserError>(
                  AllOf(HasSubstr("configuration " + path + ": "),
                        HasSubstr("key 'packets' (packets in flight in a pipeline)"))));
}

}  // namespace
}  // namespace dynrt::host
