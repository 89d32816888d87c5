// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Every stress case on the model: no error exceeds its bound, and hits and pixels have the golden
// digests, to the last bit, with every compilation: -O3, -O0, or under the sanitizers. After an
// intended change the target update-stress renews them.
#include <fmt/format.h>

#include "verif/stress/stress_boards.h"

namespace dynrt::host::stress {
namespace {

class Stress : public ::testing::TestWithParam<Parameter> {};

TEST_P(Stress, IsWithinWhatIsAllowedAndGivesTheSameBits) {
  const auto& [configuration, number] = GetParam();
  const Case& c = cases()[number];
  try {
    Boards boards(open_model, configuration);
    const Result result = run_case(c, boards);
    EXPECT_TRUE(result.within()) << line_of(result);
    EXPECT_EQ(golden().at(configuration).at(c.full_name()),
              fmt::format("{:016x}", result.outcome.digest));
  } catch (const NoBoard& lacking) {
    GTEST_SKIP() << lacking.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Stress, every_case(), name_of);

}  // namespace
}  // namespace dynrt::host::stress
