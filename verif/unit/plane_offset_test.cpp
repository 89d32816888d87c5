// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/plane_offset.h"

#include "Vplane_offset.h"
#include "plane_offset_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<PlaneOffset<C>>&, const Run&) {}

DYNRT_COSIM(PlaneOffset, PlaneOffset<C>, plane_offset, setup)

}  // namespace
}  // namespace dynrt::cosim
