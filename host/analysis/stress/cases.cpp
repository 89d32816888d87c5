// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/analysis/stress/stress_messages.h"
#include "host/analysis/stress/watertight_bounds.h"
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
  for (Case& c : all) {
    if (const WatertightBound* bound = watertight_bound(c.full_name())) {
      c.watertight = bound->allowed;
    }
  }
  return all;
}

bool is_watertight(const CoreInfo& board) {
  return board.triangle_test == TriangleTest::kWatertight;
}

/// Tells whether the core computes like the two whose errors were measured. On a core of one level
/// rays lack the multiplication with an instance's matrix and its rounding.
bool is_measured(const CoreInfo& board) {
  const MemoryFormat& numbers = *board.format;
  return numbers.exponent_bits == kShippedFormat.exponent_bits &&
         numbers.mantissa_bits == kShippedFormat.mantissa_bits &&
         numbers.rounding == kShippedFormat.rounding && board.levels == 2 &&
         !board.clips_to_box() && board.divider == Divider::kQuotient &&
         board.triangle_matrix == TriangleMatrix::kNormalConsistent &&
         board.rays_sent == RaysSent::kTraced;
}

/// Reasons that hold for the thesis's test alone.
bool is_of_cracks(const std::string& why) {
  return why == reasons::kCracks || why == reasons::kSharedEdge;
}

}  // namespace

std::string Case::why_on(const CoreInfo& board) const {
  if (!is_watertight(board)) return why;
  const WatertightBound* bound = watertight_bound(full_name());
  return bound != nullptr ? bound->why : is_of_cracks(why) ? "" : why;
}

Allowed Case::allowed(const CoreInfo& board) const {
  Allowed allowed = unit_triangle;
  if (is_watertight(board)) {
    if (watertight) allowed = *watertight;
    if (is_of_cracks(why)) allowed.lost = allowed.twice = 0;
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
