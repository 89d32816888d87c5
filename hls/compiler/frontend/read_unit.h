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

/// The steps of the front end after which UnitSource::print_after can have the IR printed, in
/// order.
const std::vector<std::string>& ir_passes();

/// Throws Error if the unit cannot be lowered.
UnitNetlist read_unit(const UnitSource& source);

}  // namespace hlsc
