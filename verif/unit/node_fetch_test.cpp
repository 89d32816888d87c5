// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/node_fetch.h"

#include <memory>

#include "Vnode_fetch.h"
#include "node_fetch_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

using Event = TraversalEvent<C>;

/// A packet enters a level before anything else happens there; some fill their stacks.
class Stimulus {
 public:
  explicit Stimulus(const Run& run) : packets_(run) {}
  void draw(Event& e, Random& random) {
    e.packet = packets_.next(random);
    const bool deep = e.packet < PacketId<C>(8);
    const std::uint64_t choice = random.below(100);
    if (!entered(e) || choice == 0) {
      e.kind = TraversalKind::kEnter;
      e.terminated = 0;
      // No objects beside the main one.
      if (kMainFirst<C> && random.below(4) == 0) e.next = 0;
    } else if (choice < (deep ? 92 : 50)) {
      e.kind = TraversalKind::kPush;
    } else {
      e.kind = choice % 3 == 0 ? TraversalKind::kDescend : TraversalKind::kPop;
    }
    if (random.below(4) != 0) e.terminated = 0;
  }
  void begun(const Event& e) { entered(e) = true; }

 private:
  bool& entered(const Event& e) { return entered_[level_of(e.level)][e.packet.to_u64()]; }
  Packets packets_;
  bool entered_[2][C::kPackets] = {};
};

void setup(Bench<NodeFetch<C>>& bench, const Run& run) {
  auto stimulus = std::make_shared<Stimulus>(run);
  bench.packet<Event>("event", [](const Event& e) { return e.packet.to_u64(); });
  bench.shape<Event>("event", [stimulus](Event& e, Random& random) { stimulus->draw(e, random); });
  bench.begun<Event>("event", [stimulus](const Event& e) { stimulus->begun(e); });
}

DYNRT_COSIM(NodeFetch, NodeFetch<C>, node_fetch, setup)

}  // namespace
}  // namespace dynrt::cosim
