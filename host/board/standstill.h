// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The state of each unit of a core that has stopped, from two readings of its counters.
#pragma once

#include <span>
#include <string>

#include "host/board/board.h"

namespace dynrt::host {

/// "stalled: list 12; at work: shading 9; without input: startup 544, ..": every unit with its
/// transactions. A unit is stalled if tokens waited for room in its outputs between the two
/// readings; else it worked or had no input. Both readings have the same counters in the same
/// order.
std::string where_units_stand(std::span<const Counter> before, std::span<const Counter> after);

}  // namespace dynrt::host
