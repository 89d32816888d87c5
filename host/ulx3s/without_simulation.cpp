// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Of a build without Verilog.
#include "host/error.h"
#include "host/ulx3s/simulated_ulx3s.h"
#include "host/ulx3s/ulx3s_messages.h"

namespace dynrt::host {

std::unique_ptr<SimulatedUlx3s> make_simulated_ulx3s() { refuse(messages::kNoSimulation); }

}  // namespace dynrt::host
