// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Trees so deep that a ray fills a stack, on either level and on both.
#include "host/analysis/stress/case.h"
#include "host/analysis/stress/chains.h"

namespace dynrt::host::stress {

namespace {

/// The counter must count all losses of a full stack.
void run(Examiner& b, const Trial& trial) {
  const Rendered rendered = b.check(trial);
  if (rendered.dropped_pushes() == 0) b.count(Fault::kUnsaid, b.outcome()[Fault::kLost]);
}

/// On a core whose stacks are as deep as the trees.
Trial on_deep(Trial trial) {
  trial.configuration = "deep";
  return trial;
}

Case stack_case(const std::string& name, const std::string& about,
                const std::function<Trial(const MemoryFormat&)>& make, const Allowed& allowed = {},
                const std::string& why = "") {
  return Case(name, about, [make](Examiner& b) { run(b, make(b.numbers())); }, allowed, why);
}

constexpr char kWhy32[] =
    "the 32nd push finds a full stack of 31 entries, so the ray does not enter one leaf";
constexpr char kWhy60[] =
    "29 of 60 pushes find the stack full, so the ray does not enter 29 leaves";

}  // namespace

std::vector<Case> stack_cases() {
  return {
      stack_case("objects_tree_31", "31 planes before the nearest leaf of an object's tree",
                 [](const auto& n) { return lower_chain(n, 31); }),
      stack_case(
          "objects_tree_32", "32 planes", [](const auto& n) { return lower_chain(n, 32); },
          {.lost = 1}, kWhy32),
      stack_case(
          "objects_tree_60", "60 planes", [](const auto& n) { return lower_chain(n, 60); },
          {.lost = 29}, kWhy60),
      stack_case("scenes_tree_31", "31 planes before the nearest leaf of the scene's tree",
                 [](const auto& n) { return upper_chain(n, 31); }),
      stack_case(
          "scenes_tree_32", "32 planes", [](const auto& n) { return upper_chain(n, 32); },
          {.lost = 1}, kWhy32),
      stack_case(
          "scenes_tree_60", "60 planes", [](const auto& n) { return upper_chain(n, 60); },
          {.lost = 29}, kWhy60),
      stack_case("both_31", "both stacks filled to the last entry",
                 [](const auto&) { return nested_chains(31, 31); }),
      stack_case(
          "both_40", "40 planes on each level", [](const auto&) { return nested_chains(40, 40); },
          {.lost = 25}, "the ray does not enter 9 of 40 leaves on each level"),
      stack_case("deep_objects_tree_60",
                 "60 planes in an object's tree, on `deep`: stacks of 63 entries",
                 [](const auto& n) { return on_deep(lower_chain(n, 60)); }),
      stack_case("deep_scenes_tree_60",
                 "60 planes in the scene's tree, on `deep`: stacks of 63 entries",
                 [](const auto& n) { return on_deep(upper_chain(n, 60)); }),
      stack_case("deep_both_40", "40 planes on each level, on `deep`: stacks of 63 entries",
                 [](const auto&) { return on_deep(nested_chains(40, 40)); }),
  };
}

}  // namespace dynrt::host::stress
