// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "host/error.h"
#include "host/stress/case.h"
#include "host/stress/messages.h"

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

}  // namespace

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
