// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/picture_pixels.h"

#include "Vpicture_pixels.h"
#include "picture_pixels_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

using Unit = PicturePixelsOf<C>;

/// Small pictures, so that many begin and end.
void setup(Bench<Unit>& bench, const Run&) {
  bench.shape<ScanConfig>("config", [](ScanConfig& c, Random& random) {
    c.width = Word::from(1 + random.below(100));
    c.height = Word::from(1 + random.below(20));
  });
}

DYNRT_COSIM(PicturePixels, Unit, picture_pixels, setup)

}  // namespace
}  // namespace dynrt::cosim
