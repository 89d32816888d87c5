// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/packet_decision.h"

#include "Vpacket_decision.h"
#include "packet_decision_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<PacketDecision<C>>& bench, const Run&) {
  bench.shape<Step<C>>("step_in", [](Step<C>& s, Random& random) {
    if (random.below(8) == 0) s.node.left = 0;
    if (random.below(8) == 0) s.node.right = 0;
  });
}

DYNRT_COSIM(PacketDecision, PacketDecision<C>, packet_decision, setup)

}  // namespace
}  // namespace dynrt::cosim
