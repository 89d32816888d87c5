// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/world_box.h"

#include "Vworld_box.h"
#include "unit/cosimulate.h"
#include "world_box_ports.h"

namespace dynrt::cosim {
namespace {

using Real = C::Real;

double near_one(Random& random) {
  return static_cast<double>(random.below(1u << 20)) / (1u << 18) - 2;
}

/// Boxes around and before the eye more often than anywhere in the range of the numbers.
void setup(Bench<WorldBox<C>>& bench, const Run&) {
  using Job = Repeated<BoxJob<C>>;
  bench.shape<Job>("job", [](Job& j, Random& random) {
    j.job.repeat = number_below<RepeatCount<C>::kWidth>(random, kRays<C>);
    j.index = number_below<RepeatCount<C>::kWidth>(random, j.job.repeat.to_u64() + 1);
    j.last = j.index == j.job.repeat;
  });
  bench.shape<BoxedObject<C>>("object", [](BoxedObject<C>& o, Random& random) {
    if (random.below(4) == 0) return;
    for (Slab<Real>& slab : o.slabs) {
      const double low = near_one(random);
      slab.low = Bound<Real>::from_double(low);
      slab.high = Bound<Real>::from_double(low + 2);
    }
  });
  bench.shape<Vector<Real>>("reciprocal", [](Vector<Real>& r, Random& random) {
    if (random.below(4) == 0) return;
    r = {Real::from_double(near_one(random)), Real::from_double(near_one(random)),
         Real::from_double(near_one(random))};
  });
}

DYNRT_COSIM(WorldBox, WorldBox<C>, world_box, setup)

}  // namespace
}  // namespace dynrt::cosim
