// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs the unit's C++ alone, as a join runs it, and then its Verilog against its C++ on random
// samples, both ends stalling at random; every token must be the same to the last bit.
#include <cmath>
#include <cstdio>

#include "Vsmooth.h"
#include "cosim/bench.h"
#include "hls/join.h"
#include "smooth.h"
#include "smooth_ports.h"

namespace {

/// With a weight of 1/2 each sample of 1 after a first one of 2 halves the distance to 1.
bool halves_the_distance() {
  using example::Real;
  example::Smooth smooth;
  hls::Join join;
  join.unit("smooth", "smooth", smooth);
  const auto sample = join.input("sample", smooth.sample);
  const auto smoothed = join.output("smoothed", smooth.smoothed);
  join.constant(smooth.weight, Real::from_double(0.5));
  sample->push({3, true, Real::from_double(2)});
  for (int i = 0; i < 4; ++i) sample->push({3, false, Real::from_double(1)});
  join.run();
  for (int i = 0; i <= 4; ++i) {
    const double value = smoothed->pop().value.to_double();
    if (value != 1 + std::ldexp(1.0, -i)) {
      std::fprintf(stderr, "sample %d is smoothed to %g\n", i, value);
      return false;
    }
  }
  return true;
}

}  // namespace

int main() {
  if (!halves_the_distance()) return 1;
  Vsmooth dut;
  hls::cosim::Bench<example::Smooth> bench("smooth", dut,
                                           [](auto& v, auto& f) { visit_ports_smooth(v, f); });
  // A channel's state is read before the sample before it is written back unless that has left.
  bench.packet<example::Sample>("sample", [](const auto& s) { return s.channel.to_u64(); });
  return bench.run({.transactions = 20'000}).ok ? 0 : 1;  // run() prints the result
}
