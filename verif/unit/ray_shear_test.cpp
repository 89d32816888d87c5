// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/ray_shear.h"

#include "Vray_shear.h"
#include "ray_shear_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<RayShear<C>>& bench, const Run&) {
  bench.shape<ObjectRay<C>>("ray", [](ObjectRay<C>& r, Random& random) {
    // Components that are equally long decide which axis is taken.
    Vector<typename C::Real>& d = r.in_object.direction;
    if (random.below(2)) d.y = random.below(2) ? d.x : -d.x;
    if (random.below(2)) d.z = random.below(2) ? d.x : -d.y;
  });
}

DYNRT_COSIM(RayShear, RayShear<C>, ray_shear, setup)

}  // namespace
}  // namespace dynrt::cosim
