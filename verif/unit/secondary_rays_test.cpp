// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/secondary_rays.h"

#include "Vsecondary_rays.h"
#include "secondary_rays_ports.h"
#include "unit/derivation_stimulus.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<SecondaryRays<C>>& bench, const Run& run) {
  feed_derivations(bench, run);
  bench.shape<FrameRegisters<C>>("frame", [](FrameRegisters<C>& frame, Random& random) {
    frame.lights = Word::from(random.below(C::kLights + 1));
    frame.reflections = Word::from(random.below(C::kReflections + 1));
  });
}

DYNRT_COSIM(SecondaryRays, SecondaryRays<C>, secondary_rays, setup)

}  // namespace
}  // namespace dynrt::cosim
