// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/packet_decoder.h"

#include "Vpacket_decoder.h"
#include "packet_decoder_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// The first vector of all is an origin.
void setup(Bench<PacketDecoder<C>>& bench, const Run&) {
  bench.shape<PacketVector<C>>(
      "vector", [](PacketVector<C>& v, Random& random) { v.point = random.below(5) == 0; });
  bench.shape<JobRecord<C>>("record", [](JobRecord<C>& record, Random& random) {
    record.kind = any_of<TransformKind>(random, 3);
    // Half of them, so that every pass of a derived ray is among the few rows.
    if (kHasSecondary<C> && random.below(2) == 0) record.kind = TransformKind::kSecondary;
  });
}

DYNRT_COSIM(PacketDecoder, PacketDecoder<C>, packet_decoder, setup)

}  // namespace
}  // namespace dynrt::cosim
