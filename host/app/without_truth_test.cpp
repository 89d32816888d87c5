// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a program that is built alone says in place of the truth (without_truth.cpp).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/app/command.h"
#include "host/app/truth_report.h"
#include "host/error.h"

namespace dynrt::host {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const auto kSaysWhatIsMissing = ThrowsMessage<UserError>(
    AllOf(HasSubstr("without CGAL and Embree"), HasSubstr("scripts/test --build-only")));

TEST(WithoutTruth, SaysWhatIsMissingAndWhatBuildsIt) {
  EXPECT_THAT([] { require_truth(); }, kSaysWhatIsMissing);
}

TEST(WithoutTruth, ItsCommandsTakeAnyFlagAndSaySo) {
  CLI::App program;
  const Command measure = add_measure_command(program);
  const Command stress = add_stress_command(program);
  program.parse("measure office --size 8x6 --out somewhere");
  EXPECT_TRUE(measure.app->parsed());
  EXPECT_THAT([&] { measure.run(); }, kSaysWhatIsMissing);
  program.parse("stress --list far/cube");
  EXPECT_TRUE(stress.app->parsed());
  EXPECT_THAT([&] { stress.run(); }, kSaysWhatIsMissing);
}

}  // namespace
}  // namespace dynrt::host
