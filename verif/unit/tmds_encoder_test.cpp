// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/tmds_encoder.h"

#include "Vtmds_encoder.h"
#include "tmds_encoder_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<TmdsEncoder>& bench, const Run&) {
  bench.shape<ScanPixel>("pixel", [](ScanPixel& pixel, Random& random) {
    pixel.visible = random.below(20) != 0;  // long enough for every disparity
  });
}

DYNRT_COSIM(TmdsEncoder, TmdsEncoder, tmds_encoder, setup)

}  // namespace
}  // namespace dynrt::cosim
