// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_answer.h"

#include "Vmemory_answer.h"
#include "memory_answer_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<MemoryAnswer<C>>& bench, const Run& /*run*/) {
  bench.shape<MemoryLine<C>>("line", [](MemoryLine<C>& line, Random& random) {
    line.id.kind = any_of<MemoryKind>(random, 3);
  });
}

DYNRT_COSIM(MemoryAnswer, MemoryAnswer<C>, memory_answer, setup)

}  // namespace
}  // namespace dynrt::cosim
