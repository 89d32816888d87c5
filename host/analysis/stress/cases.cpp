// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "host/analysis/stress/bounds.h"
#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/error.h"

namespace dynrt::host::stress {

namespace {

std::vector<Case> all_cases() {
  struct Group {
    const char* name;
    std::vector<Case> (*cases)();
  };
  static constexpr Group kGroups[] = {
      {"slivers", sliver_cases},
      {"sizes", size_cases},
      {"far", far_cases},
      {"planes", plane_cases},
      {"grazing", grazing_cases},
      {"ends", end_cases},
      {"edges", edge_cases},
      {"degenerate", degenerate_cases},
      {"instances", instance_cases},
      {"overlap", overlap_cases},
      {"stacks", stack_cases},
      {"exponents", exponent_cases},
      {"cameras", camera_cases},
      {"frames", frame_cases},
  };
  std::vector<Case> all;
  for (const Group& group : kGroups) {
    for (Case& c : group.cases()) {
      c.group = group.name;
      all.push_back(std::move(c));
    }
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
  return board.is_watertight() && is_of_cracks(why) ? "" : why;
}

Allowed Case::allowed(const CoreInfo& board) const {
  Allowed allowed = on_thesis;
  if (const Bound* bound = bound_on(board, full_name())) {
    allowed = bound->allowed;
  } else if (board.is_watertight() && is_of_cracks(why)) {
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
      refuse(
          "there is no stress case or group '{}'; give one of these, or the part before the slash: "
          "{}",
          name, fmt::format("{}", fmt::join(known, ", ")));
    }
  }
  if (names.empty()) {
    for (const Case& c : cases()) found.push_back(&c);
  }
  return found;
}

}  // namespace dynrt::host::stress
