// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/box_clip.h"

#include <memory>
#include <type_traits>

#include "Vbox_clip.h"
#include "box_clip_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// A packet's rays come one after the other, the lowest first.
void setup(Bench<BoxClip<C>>& bench, const Run&) {
  auto next = std::make_shared<unsigned>(0);
  auto packet = std::make_shared<PacketId<C>>();
  bench.shape<ObjectRay<C>>("ray", [next, packet](ObjectRay<C>& r, Random& random) {
    r.ray = RayIndex<C>::from(*next % kRays<C>);
    if (*next % kRays<C> == 0) *packet = number_below<PacketId<C>::kWidth>(random, C::kPackets);
    r.packet = *packet;
    ++*next;
    // Near the box more often than anywhere in the range of the numbers.
    if (random.below(4) == 0) return;
    for (auto* v : {&r.in_object.origin, &r.in_object.direction}) {
      for (auto* x : {&v->x, &v->y, &v->z}) {
        const double u = static_cast<double>(random.below(1u << 20)) / (1u << 18) - 2;
        *x = std::decay_t<decltype(*x)>::from_double(u);
      }
    }
  });
}

DYNRT_COSIM(BoxClip, BoxClip<C>, box_clip, setup)

}  // namespace
}  // namespace dynrt::cosim
