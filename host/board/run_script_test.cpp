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

TEST(RunScript, AnswersTheLinesThatAsk) {
  std::vector<std::string> asked;
  const Answer answer = [&](const std::string& question) {
    asked.push_back(question);
    return "<" + question + ">";
  };
  const CommandOutput output = output_of(
      {"sh", "-c", "echo '? first'; read -r a; echo '? second'; read -r b; echo \"$a and $b\""},
      answer);
  EXPECT_EQ(asked, (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(output.text, "<first> and <second>");
  EXPECT_EQ(output.code, 0);
}

TEST(RunScript, IsNotHurtByACommandThatDoesNotWaitForItsAnswer) {
  const std::string much(1 << 22, 'x');
  const auto answer = [&](const std::string&) { return much; };
  EXPECT_EQ(output_of({"sh", "-c", "echo '? it'; exit 4"}, answer).code, 4);
}

TEST(RunScript, EndsTheCommandWhereThereIsNoAnswer) {
  const auto defect = [](const std::string&) -> std::string { throw std::logic_error("none"); };
  EXPECT_THROW(output_of({"sh", "-c", "echo '? it'; read -r a"}, defect), std::logic_error);
}

}  // namespace
}  // namespace dynrt::host
