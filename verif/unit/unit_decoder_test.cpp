// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/unit_decoder.h"

#include "Vunit_decoder.h"
#include "unit/cosimulate.h"
#include "unit_decoder_ports.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<UnitDecoder<C>>&, const Run&) {}

DYNRT_COSIM(UnitDecoder, UnitDecoder<C>, unit_decoder, setup)

}  // namespace
}  // namespace dynrt::cosim
