// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_fill.h"

#include "Vmemory_fill.h"
#include "memory_fill_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<MemoryFill<C>>& bench, const Run& /*run*/) {
  bench.shape<PortLine<C>>("fill", [](PortLine<C>& line, Random& random) {
    line.id.kind = any_of<MemoryKind>(random, 3);
    if constexpr (kHasSecondLevel<C>) line.invalidate = random.below(8) == 0;
  });
}

DYNRT_COSIM(MemoryFill, MemoryFill<C>, memory_fill, setup)

}  // namespace
}  // namespace dynrt::cosim
