// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "host/analysis/stress/bounds.h"
#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/analysis/stress/stress_messages.h"
#include "host/error.h"

namespace dynrt::host::stress {

namespace {

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const auto group : {sliver_cases, size_cases, far_cases, plane_cases, grazing_cases,
                           end_cases, edge_cases, degenerate_cases, instance_cases, overlap_cases,
                           stack_cases, exponent_cases, camera_cases, frame_cases}) {
    std::ranges::move(group(), std::back_inserter(all));
  }
  return all;
}

/// Reasons that hold for the thesis's test alone.
bool is_of_cracks(const std::string& why) {
  return why == reasons::kCracks || why == reasons::kSharedEdge;
}

}  // namespace

std::string Case::why_on(const CoreInfo& board) const {
  if (const Bound* bound = bound_on(board, full_name())) return bound->why;
  return is_watertight(board.triangle_test) && is_of_cracks(why) ? "" : why;
}

Allowed Case::allowed(const CoreInfo& board) const {
  Allowed allowed = on_thesis;
  if (const Bound* bound = bound_on(board, full_name())) {
    allowed = bound->allowed;
  } else if (is_watertight(board.triangle_test) && is_of_cracks(why)) {
    allowed.lost = allowed.twice = 0;
  }
  allowed.stated = is_measured(board);
  return allowed;
}

std::span<const Case> cases() {
  static const std::vector<Case> all = all_cases();
  return all;
}

std::vector<const Case*> find_cases(std::span<const std::string> names) {
  std::vector<const Case*> found;
  for (const std::string& name : names) {
    const std::size_t before = found.size();
    for (const Case& c : cases()) {
      if (c.full_name() == name || c.group == name) found.push_back(&c);
    }
    if (found.size() == before) {
      std::vector<std::string> known;
      for (const Case& c : cases()) known.push_back(c.full_name());
      refuse(messages::kNoCase, name, fmt::format("{}", fmt::join(known, ", ")));
    }
  }
  if (names.empty()) {
    for (const Case& c : cases()) found.push_back(&c);
  }
  return found;
}

}  // namespace dynrt::host::stress
