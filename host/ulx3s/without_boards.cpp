// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Of a build without the Verilog of boards.
#include <string_view>

#include "host/error.h"
#include "host/ulx3s/simulated_ulx3s.h"

namespace dynrt::host {

namespace {

[[noreturn]] void no_verilog() {
  refuse(
      "this build has no Verilog of the ULX3S and of other boards at a serial line; run "
      "scripts/test --build-only, which makes it");
}

}  // namespace

std::string_view fast_ulx3s_core_json() { no_verilog(); }
std::string_view fast_port_core_json() { no_verilog(); }

std::unique_ptr<SimulatedUlx3s> make_simulated_ulx3s() { no_verilog(); }

}  // namespace dynrt::host
