// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Trees of more levels than the usual stacks have entries: the configuration `deep` loses no hit of
// theirs, where `thesis` drops pushes and its counter says so.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/analysis/stress/run.h"
#include "host/board/configurations.h"

namespace dynrt::host::stress {
namespace {

std::unique_ptr<Board> model(const std::string& configuration) {
  return make_board(configurations(), {"model", configuration, ""});
}

class Deep : public testing::TestWithParam<std::string> {};

TEST_P(Deep, StacksLoseNothing) {
  const std::vector<std::string> names = {"stacks/" + GetParam()};
  for (const Case* c : find_cases(names)) {
    Boards deep(model, "deep");
    const Outcome all = run_case(*c, deep).outcome;
    EXPECT_GT(all.hits, 0u);
    EXPECT_EQ(all[Fault::kLost], 0u);
    EXPECT_EQ(all.dropped, 0u);
    EXPECT_TRUE(within(all, {}));

    Boards usual(model, "thesis");
    const Outcome some = run_case(*c, usual).outcome;
    EXPECT_GT(some[Fault::kLost], 0u);
    EXPECT_GT(some.dropped, 0u);
    EXPECT_EQ(some[Fault::kUnsaid], 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Trees, Deep,
                         testing::Values("objects_tree_32", "objects_tree_60", "scenes_tree_60",
                                         "both_40"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace dynrt::host::stress
