// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "ulx3s/verilated_ulx3s.h"

#include "Vulx3s_board.h"

namespace dynrt::host {

std::unique_ptr<SimulatedUlx3s> make_simulated_ulx3s() {
  return std::make_unique<VerilatedUlx3s<Vulx3s_board>>();
}

}  // namespace dynrt::host
