// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/startup.h"

#include "Vstartup.h"
#include "startup_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<Startup<C>>& bench, const Run&) {
  bench.shape<uint<10>>("number",
                        [](uint<10>& n, Random& random) { n = number_below<10>(random, 1024); });
}

DYNRT_COSIM(Startup, Startup<C>, startup, setup)

}  // namespace
}  // namespace dynrt::cosim
