// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The bounds of stress cases for a core with the watertight triangle test, if they differ from
// those of the thesis's test by more than its cracks.
#pragma once

#include <string>

#include "host/analysis/stress/outcome.h"

namespace dynrt::host::stress {

struct WatertightBound {
  const char* name;  ///< of the case, with its group
  Allowed allowed;
  const char* why;
};

/// Null where there is none.
const WatertightBound* watertight_bound(const std::string& full_name);

}  // namespace dynrt::host::stress
