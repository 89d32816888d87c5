// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The stress cases: scenes and rays with hard numbers (thesis chapters 3 to 5 with 17 bits of
// significand), each small enough to read, each with the errors that are allowed and their reason.
// The program and the tests run this one table, and docs/results/stress.md is made from it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/analysis/stress/examiner.h"
#include "host/analysis/stress/outcome.h"

namespace dynrt::host::stress {

struct Case {
  Case(std::string its_name, std::string its_about, std::function<void(Examiner&)> its_run,
       const Allowed& allowed_on_thesis = {}, std::string reason = "")
      : name(std::move(its_name)),
        about(std::move(its_about)),
        run(std::move(its_run)),
        on_thesis(allowed_on_thesis),
        why(std::move(reason)) {}

  std::string group;  ///< set where the groups are joined
  std::string name;   ///< within the group
  std::string about;  ///< description of scene and rays
  std::function<void(Examiner&)> run;
  Allowed on_thesis;  ///< the allowed errors of cores that compute as the thesis's
  std::string why;    ///< their reason

  /// The allowed errors on a board, and their reason; stated if its core computes like those that
  /// were measured. A watertight core has no cracks between triangles.
  Allowed allowed(const CoreInfo& board) const;
  std::string why_on(const CoreInfo& board) const;

  std::string full_name() const { return group + "/" + name; }
};

/// All, group by group.
std::span<const Case> cases();

/// The cases of a name or of a group, or all; throws UserError that lists the names.
std::vector<const Case*> find_cases(std::span<const std::string> names);

// One file each.
std::vector<Case> sliver_cases();
std::vector<Case> size_cases();
std::vector<Case> far_cases();
std::vector<Case> plane_cases();
std::vector<Case> grazing_cases();
std::vector<Case> end_cases();
std::vector<Case> edge_cases();
std::vector<Case> degenerate_cases();
std::vector<Case> instance_cases();
std::vector<Case> overlap_cases();
std::vector<Case> stack_cases();
std::vector<Case> exponent_cases();
std::vector<Case> camera_cases();
std::vector<Case> frame_cases();

}  // namespace dynrt::host::stress
