// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Events as they come to the unit that decides which rays follow, for its co-simulation.
#pragma once

#include <memory>

#include "unit/cosimulate.h"
#include "units/shading_tokens.h"

namespace dynrt::cosim {

/// A packet's primary rays are shaded first; afterwards anything may come. Where light rays are
/// made at once, none comes alone.
class DerivationStimulus {
 public:
  explicit DerivationStimulus(const Run& run) : packets_(run) {}
  void draw(DerivationEvent<C>& d, Random& random) {
    d.packet = packets_.next(random);
    const bool known = known_[d.packet.to_u64()];
    d.shaded = kLightsAtOnce<C> || !known || random.below(4) == 0;
    d.kind = known ? any_of<RayKind>(random, kHasMirrors<C> ? 3 : 2) : RayKind::kPrimary;
  }
  void begun(const DerivationEvent<C>& d) { known_[d.packet.to_u64()] = true; }

 private:
  Packets packets_;
  bool known_[C::kPackets] = {};
};

template <class Unit>
void feed_derivations(Bench<Unit>& bench, const Run& run) {
  auto stimulus = std::make_shared<DerivationStimulus>(run);
  bench.template packet<DerivationEvent<C>>(
      "derive", [](const DerivationEvent<C>& d) { return d.packet.to_u64(); });
  bench.template shape<DerivationEvent<C>>(
      "derive", [stimulus](DerivationEvent<C>& d, Random& random) { stimulus->draw(d, random); });
  bench.template begun<DerivationEvent<C>>(
      "derive", [stimulus](const DerivationEvent<C>& d) { stimulus->begun(d); });
}

}  // namespace dynrt::cosim
