// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/send_packet.h"

#include "Vsend_packet.h"
#include "send_packet_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<SendPacket<C>>& bench, const Run&) {
  using Job = Repeated<SendJob<C>>;
  bench.shape<Job>("job", [](Job& j, Random& random) {
    j.job.kind = any_of<TransformKind>(random, kHasSecondary<C> ? 4 : 3);
    j.job.repeat = j.job.kind == TransformKind::kSecondary ? RepeatCount<C>(1)
                   : kMapsCorners<C> && j.job.kind == TransformKind::kTriangle
                       ? RepeatCount<C>(3 * kRays<C> - 1)
                   : kMapsBlocks<C> && j.job.kind == TransformKind::kTriangle
                       ? RepeatCount<C>(kRays<C> - 1)
                   : random.below(2) == 0 ? RepeatCount<C>(kRays<C>)
                                          : RepeatCount<C>(2 * kRays<C> - 1);
    j.index = number_below<RepeatCount<C>::kWidth>(random, j.job.repeat.to_u64() + 1);
    j.last = j.index == j.job.repeat;
  });
}

DYNRT_COSIM(SendPacket, SendPacket<C>, send_packet, setup)

}  // namespace
}  // namespace dynrt::cosim
