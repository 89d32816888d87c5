// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/light_columns.h"

#include "Vlight_columns.h"
#include "light_columns_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<LightColumns<C>>& bench, const Run&) {
  using Column = LightColumns<C>::Column;
  bench.shape<Column>("fetched", [](Column& c, Random& random) {
    if (random.below(2) == 0) {
      c.context.kind = TransformKind::kSecondary;
      c.context.extras.derived =
          DerivedRay<C>{Derivation::kLight, number_below<kRayBits<C>>(random, kRays<C>)};
    }
  });
}

DYNRT_COSIM(LightColumns, LightColumns<C>, light_columns, setup)

}  // namespace
}  // namespace dynrt::cosim
