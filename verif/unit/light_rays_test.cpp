// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/light_rays.h"

#include "Vsecondary_rays.h"
#include "secondary_rays_ports.h"
#include "unit/derivation_stimulus.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<LightRays<C>>& bench, const Run& run) {
  feed_derivations(bench, run);
  bench.shape<FrameRegisters<C>>("frame", [](FrameRegisters<C>& frame, Random& random) {
    frame.lights = Word::from(1 + random.below(C::kLights));
  });
}

DYNRT_COSIM(LightRays, LightRays<C>, secondary_rays, setup)

}  // namespace
}  // namespace dynrt::cosim
