// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A netlist of random operations over random widths with every kind of port, to test the lowering.
// The token's lowest bits, which the bench counts up, address the rows of RAMs, so that no
// transaction meets another one's row; any value may address register files.
#pragma once

#include <cstdint>

#include "backend.h"

namespace hlsc {

inline constexpr unsigned kIdWidth = 7;  ///< bits of the number in tokens of the first In

Netlist random_netlist(std::uint32_t seed);

/// Clock and device change with the seed.
Options random_options(std::uint32_t seed, const char* delay_folder);

}  // namespace hlsc
