// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Entries as they come to a mailbox, for its co-simulation.
#pragma once

#include <memory>

#include "unit/cosimulate.h"
#include "units/traversal_tokens.h"

namespace dynrt::cosim {

using Entry = MailboxEntry<C>;

/// A packet is new, then has objects, and after the first of them triangles.
class MailboxStimulus {
 public:
  explicit MailboxStimulus(const Run& run) : packets_(run) {}
  void draw(Entry& e, Random& random) {
    e.packet = packets_.next(random);
    const Known known = known_[e.packet.to_u64()];
    e.clear = known == Known::kNothing || random.below(40) == 0;
    e.level = Level::from(known == Known::kTriangles && !e.clear && random.below(8) != 0);
    e.entry.matrix = number_below<C::kMatrixBits>(random, 12);
    // A leaf is reached by some ray.
    if (e.active == RayMask<C>{}) e.active = RayMask<C>(1);
  }
  void begun(const Entry& e) {
    Known& known = known_[e.packet.to_u64()];
    if (e.clear && known == Known::kNothing) {
      known = Known::kObjects;
    } else if (!e.clear) {
      known = Known::kTriangles;
    }
  }

 private:
  enum class Known : unsigned char { kNothing, kObjects, kTriangles };
  Packets packets_;
  Known known_[C::kPackets] = {};
};

template <class Unit>
void feed_entries(Bench<Unit>& bench, const Run& run) {
  auto stimulus = std::make_shared<MailboxStimulus>(run);
  bench.template packet<Entry>("entry", [](const Entry& e) { return e.packet.to_u64(); });
  bench.template shape<Entry>("entry",
                              [stimulus](Entry& e, Random& random) { stimulus->draw(e, random); });
  bench.template begun<Entry>("entry", [stimulus](const Entry& e) { stimulus->begun(e); });
}

}  // namespace dynrt::cosim
