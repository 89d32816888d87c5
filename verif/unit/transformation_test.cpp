// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/transformation.h"

#include "Vtransformation.h"
#include "transformation_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<Transformation<C>>&, const Run&) {}

DYNRT_COSIM(Transformation, Transformation<C>, transformation, setup)

}  // namespace
}  // namespace dynrt::cosim
