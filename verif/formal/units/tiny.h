// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The configuration thesis with numbers and tables small enough for a solver.
#pragma once

#include "configs/thesis.h"

namespace formal {

struct Tiny : dynrt::config::thesis {
  using Real = hls::Float<3, 3>;
  static constexpr unsigned kPackets = 2;
  static constexpr unsigned kMailboxSlots = 2;
};

}  // namespace formal
