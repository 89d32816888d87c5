// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/ray_reciprocal.h"

#include "Vray_reciprocal.h"
#include "ray_reciprocal_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<RayReciprocal<C>>&, const Run&) {}

DYNRT_COSIM(RayReciprocal, RayReciprocal<C>, ray_reciprocal, setup)

}  // namespace
}  // namespace dynrt::cosim
