// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/bounds.h"

#include <algorithm>

namespace dynrt::host::stress {

namespace {

/// Of numbers and levels. On a core of one level rays lack the multiplication with an instance's
/// matrix and its rounding.
bool has_shipped_numbers(const CoreInfo& core) {
  const MemoryFormat& numbers = *core.format;
  return numbers.exponent_bits == kShippedFormat.exponent_bits &&
         numbers.mantissa_bits == kShippedFormat.mantissa_bits &&
         numbers.rounding == kShippedFormat.rounding && core.levels == 2 &&
         core.triangle_matrix == TriangleMatrix::kNormalConsistent;
}

/// Like `thesis`, or `watertight`.
bool computes_as_thesis(const CoreInfo& core) { return core.datapath == Datapath::kThesis; }
/// Like `fast`, or `fast_watertight`.
bool computes_as_fast(const CoreInfo& core) {
  return core.datapath == Datapath::kFast && core.tests_world_box();
}

const Bound* find(std::span<const Bound> bounds, const std::string& full_name) {
  const auto found = std::ranges::find(bounds, full_name, &Bound::name);
  return found == bounds.end() ? nullptr : &*found;
}

}  // namespace

bool is_measured(const CoreInfo& core) {
  return has_shipped_numbers(core) && (computes_as_thesis(core) || computes_as_fast(core));
}

const Bound* bound_on(const CoreInfo& core, const std::string& full_name) {
  const bool watertight = core.is_watertight();
  if (!computes_as_fast(core)) {
    return watertight ? find(watertight_bounds(), full_name) : nullptr;
  }
  if (!watertight) return find(fast_bounds(), full_name);
  const Bound* own = find(fast_watertight_bounds(), full_name);
  return own != nullptr ? own : find(watertight_bounds(), full_name);
}

}  // namespace dynrt::host::stress
