// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_write.h"

#include "Vmemory_write.h"
#include "memory_write_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<MemoryWrite<C>>& bench, const Run& /*run*/) {
  using Burst = Repeated<WriteBurst<C>>;
  constexpr unsigned kBeats = WriteBurst<C>::beats(kWriteBytes);
  bench.shape<Burst>("burst", [](Burst& b, Random& random) {
    b.index = number_below<decltype(b.index)::kWidth>(random, kBeats);
    b.last = random.below(kBeats) == 0;
  });
}

DYNRT_COSIM(MemoryWrite, MemoryWrite<C>, memory_write, setup)

}  // namespace
}  // namespace dynrt::cosim
