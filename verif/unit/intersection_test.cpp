// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/intersection.h"

#include "Vintersection.h"
#include "intersection_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<Intersection<C>>&, const Run&) {}

DYNRT_COSIM(Intersection, Intersection<C>, intersection, setup)

}  // namespace
}  // namespace dynrt::cosim
