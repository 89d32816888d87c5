// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_interface.h"

#include "Vmemory_interface.h"
#include "memory_interface_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<MemoryInterface<C>>& bench, const Run&) {
  using Token = typename decltype(MemoryInterface<C>::request)::Data;
  bench.shape<Token>("request", []<class T>(T& r, Random& random) {
    if constexpr (requires { r.job; }) {
      r.job.kind = any_of<MemoryKind>(random, 3);
    } else {
      r.kind = any_of<MemoryKind>(random, 3);
    }
  });
}

DYNRT_COSIM(MemoryInterface, MemoryInterface<C>, memory_interface, setup)

}  // namespace
}  // namespace dynrt::cosim
