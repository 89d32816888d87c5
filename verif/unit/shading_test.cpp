// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/shading.h"

#include "Vshading.h"
#include "shading_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<Shading<C>>& bench, const Run& run) {
  using Job = Repeated<ShadeJob<C>>;
  bench.shape<Job>("job", [](Job& j, Random& random) {
    j.index = number_below<RepeatCount<C>::kWidth>(random, kLastWrite<C>.to_u64() + 1);
    j.last = j.index == kLastWrite<C>;
  });
  const bool write_hits = run.number % 3 != 1;
  bench.shape<FrameRegisters<C>>("frame", [write_hits](FrameRegisters<C>& frame, Random& random) {
    frame.width = Word::from(200 + random.below(825));
    frame.height = Word::from(200 + random.below(825));
    frame.frame_base = number_below<32>(random, kBankWords);
    frame.write_hits = Word::from(write_hits);
  });
  if (!write_hits && !kHasPort<C>) {
    bench.may_be_silent("bank_1");
    bench.may_be_silent("bank_2");
  }
}

DYNRT_COSIM(Shading, Shading<C>, shading, setup)

}  // namespace
}  // namespace dynrt::cosim
