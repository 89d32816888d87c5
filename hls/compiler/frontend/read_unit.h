// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The front end as a whole: from a unit's C++ to its netlist.
#pragma once

#include <string>
#include <vector>

#include "frontend/compile_unit.h"
#include "netlist/netlist.h"

namespace hlsc {

struct UnitNetlist {
  Netlist netlist;
  std::vector<std::string> includes;  ///< every file that was read
};

/// Throws Error where the unit cannot be lowered.
UnitNetlist read_unit(const UnitSource& source);

}  // namespace hlsc
