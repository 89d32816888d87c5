// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a program that is built alone says in place of the truth (without_truth.cpp).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/analysis/truth/require_truth.h"
#include "host/error.h"

namespace dynrt::host {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(WithoutTruth, SaysWhatIsMissingAndWhatBuildsIt) {
  EXPECT_THAT([] { require_truth(); },
              ThrowsMessage<UserError>(AllOf(HasSubstr("without CGAL and Embree"),
                                             HasSubstr("scripts/test --build-only"))));
}

}  // namespace
}  // namespace dynrt::host
