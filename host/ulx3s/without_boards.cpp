// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Of a build without the Verilog of boards.
#include <string_view>

#include "host/error.h"
#include "host/ulx3s/simulated_ulx3s.h"
#include "host/ulx3s/ulx3s_messages.h"

namespace dynrt::host {

std::string_view fast_ulx3s_core_json() { refuse(messages::kNoVerilogOfBoards); }
std::string_view fast_port_core_json() { refuse(messages::kNoVerilogOfBoards); }

std::unique_ptr<SimulatedUlx3s> make_simulated_ulx3s() { refuse(messages::kNoVerilogOfBoards); }

}  // namespace dynrt::host
