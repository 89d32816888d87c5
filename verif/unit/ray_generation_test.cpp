// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/ray_generation.h"

#include "Vray_generation.h"
#include "ray_generation_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// Small images end and large ones do not; scanline order passes nothing over.
void setup(Bench<RayGeneration<C>>& bench, const Run& run) {
  const bool large = run.number % 3 == 2;
  const bool scanline = run.number % 2 == 1;
  if (large) bench.may_be_silent("done");
  bench.may_be_silent("skipped");
  bench.shape<FrameRegisters<C>>("frame", [=](FrameRegisters<C>& frame, Random& random) {
    const unsigned limit = large ? 1024 : 60;
    const auto width = static_cast<unsigned>(1 + random.below(limit));
    const auto height = large ? 1024u : static_cast<unsigned>(1 + random.below(limit));
    frame.packets = Word::from(1 + random.below(C::kPackets));
    frame.width = Word::from(width);
    frame.height = Word::from(height);
    frame.scanline = Word::from(scanline);
    frame.morton_bits = Word::from(morton_bits(width, height, kRays<C>));
  });
}

DYNRT_COSIM(RayGeneration, RayGeneration<C>, ray_generation, setup)

}  // namespace
}  // namespace dynrt::cosim
