// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_gather.h"

#include "Vmemory_gather.h"
#include "memory_gather_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<MemoryGather<C>>& bench, const Run& /*run*/) {
  // Answers of any number of beats, often of more than a line has.
  bench.shape<PortBeat<C>>("beat",
                           [](PortBeat<C>& b, Random& random) { b.last = random.below(3) == 0; });
}

DYNRT_COSIM(MemoryGather, MemoryGather<C>, memory_gather, setup)

}  // namespace
}  // namespace dynrt::cosim
