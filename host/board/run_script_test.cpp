// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/run_script.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace dynrt::host {
namespace {

TEST(RunScript, GivesTheOutputWithoutItsLastNewlineAndTheExitCode) {
  const CommandOutput output = output_of({"sh", "-c", "echo one; printf two; exit 3"});
  EXPECT_EQ(output.text, "one\ntwo");
  EXPECT_EQ(output.code, 3);
  EXPECT_EQ(output_of({"/nowhere/at/all"}).code, -1);
}

TEST(RunScript, TellsTheStepsThatAreNoOutput) {
  std::vector<std::string> told;
  const auto tell = [&](const std::string& step) { told.push_back(step); };
  EXPECT_EQ(output_of({"sh", "-c", "echo '? one'; echo it; echo '? two'"}, tell).text, "it");
  EXPECT_EQ(told, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(output_of({"echo", "? one"}).text, "? one");
}

TEST(RunScript, InterruptsTheCommandIfNobodyHearsIt) {
  const auto defect = [](const std::string&) { throw std::logic_error("none"); };
  EXPECT_THROW(output_of({"sh", "-c", "echo '? it'; exec sleep 1000"}, defect), std::logic_error);
}

}  // namespace
}  // namespace dynrt::host
