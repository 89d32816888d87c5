// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/picture_reader.h"

#include "Vpicture_reader.h"
#include "picture_reader_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// The narrow port has a short FIFO.
using Unit = PictureReaderOf<C, C::kPortBytes == 2 ? 8 : kPictureAhead>;

/// Small pictures, so that many begin and end.
void setup(Bench<Unit>& bench, const Run&) {
  bench.shape<PictureEvents>("events", [](PictureEvents& events, Random& random) {
    events.begins = random.below(200) == 0;
  });
  bench.shape<ScanConfig>("config", [](ScanConfig& c, Random& random) {
    c.width = Word::from(random.below(100));
    c.height = Word::from(random.below(20));
  });
}

DYNRT_COSIM(PictureReader, Unit, picture_reader, setup)

}  // namespace
}  // namespace dynrt::cosim
