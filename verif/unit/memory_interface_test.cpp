// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_interface.h"

#include "Vmemory_interface.h"
#include "memory_interface_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<MemoryInterface<C>>& bench, const Run&) {
  bench.shape<MemoryRequest<C>>("request", [](MemoryRequest<C>& r, Random& random) {
    r.kind = any_of<MemoryKind>(random, 3);
  });
}

DYNRT_COSIM(MemoryInterface, MemoryInterface<C>, memory_interface, setup)

}  // namespace
}  // namespace dynrt::cosim
