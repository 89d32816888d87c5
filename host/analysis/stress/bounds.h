// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The bounds of stress cases on cores that compute otherwise than the thesis's, where they differ
// by more than the cracks that a watertight core lacks.
#pragma once

#include <span>
#include <string>

#include "host/analysis/stress/outcome.h"
#include "host/format/core_info.h"

namespace dynrt::host::stress {

struct Bound {
  const char* name;  ///< of the case, with its group
  Allowed allowed;
  const char* why;
};

/// One file each.
std::span<const Bound> watertight_bounds();
std::span<const Bound> fast_bounds();
std::span<const Bound> fast_watertight_bounds();

/// Whether the errors of cores that compute like this one were measured.
bool is_measured(const CoreInfo& core);
/// Of a case; null where it is that of the thesis's core.
const Bound* bound_on(const CoreInfo& core, const std::string& full_name);

}  // namespace dynrt::host::stress
