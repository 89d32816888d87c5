// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shared by the tests of the whole program.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/run_program.h"

namespace dynrt::host {
namespace fs = std::filesystem;

inline constexpr char kModel[] = " --config model_only --board model --size 32x24 ";
inline constexpr char kRtl[] = " --config stand_in --size 32x24 ";
inline constexpr char kLit[] = " --config lit --board model --size 32x24 ";

class App : public testing::Test {
 protected:
  Outcome run(const std::string& arguments, const std::string& stdout_to = {}) const {
    return run_program(DYNRT_PROGRAM, arguments, folder_.path(), stdout_to);
  }
  /// The user's mistake: one sentence, exit code 2, nothing left behind.
  void expect_mistake(const std::string& arguments, const testing::Matcher<std::string>& sentence) {
    const std::vector<std::string> before = names_in(folder_.path());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_THAT(outcome.err, sentence) << arguments;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.out, testing::IsEmpty());
    EXPECT_EQ(outcome.files, before) << arguments;
  }

  const TestFolder folder_;
};

}  // namespace dynrt::host
