// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs the unit's Verilog against its C++ on random samples, both ends stalling at random; every
// token must be the same to the last bit.
#include "Vsmooth.h"
#include "cosim/bench.h"
#include "smooth.h"
#include "smooth_ports.h"

int main() {
  Vsmooth dut;
  hls::cosim::Bench<example::Smooth> bench("smooth", dut,
                                           [](auto& v, auto& f) { visit_ports_smooth(v, f); });
  // A channel's state is read before the sample before it is written back unless that has left.
  bench.packet<example::Sample>("sample", [](const auto& s) { return s.channel.to_u64(); });
  return bench.run({.transactions = 20'000}).ok ? 0 : 1;  // run() prints the result
}
