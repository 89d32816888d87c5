// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/ray_reciprocal.h"

#include <memory>

#include "Vray_reciprocal.h"
#include "ray_reciprocal_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// A ray's axes come one after the other, and so do a packet's rays, the lowest first.
[[maybe_unused]] void shape_axes(Bench<RayReciprocal<C>>& bench) {
  using Token = Repeated<TracedRay<C>>;
  auto next = std::make_shared<unsigned>(0);
  auto job = std::make_shared<TracedRay<C>>();
  bench.shape<Token>("traced", [next, job](Token& t, Random& random) {
    const unsigned axis = *next % 3;
    if (axis == 0) {
      const PacketId<C> packet = *next % 12 == 0
                                     ? number_below<PacketId<C>::kWidth>(random, C::kPackets)
                                     : job->ray.packet;
      const bool is_new = *next % 12 == 0 ? random.below(2) == 0 : job->is_new;
      *job = t.job;
      job->repeat = RepeatCount<C>(2);
      job->is_new = is_new;
      job->ray.packet = packet;
      job->ray.ray = RayIndex<C>::from(*next / 3 % kRays<C>);
    }
    t.job = *job;
    t.index = RepeatCount<C>::from(axis);
    t.last = axis == 2;
    ++*next;
  });
}

void setup(Bench<RayReciprocal<C>>& bench, const Run&) {
  if constexpr (!kInvertsAtOnce<C>) shape_axes(bench);
}

DYNRT_COSIM(RayReciprocal, RayReciprocal<C>, ray_reciprocal, setup)

}  // namespace
}  // namespace dynrt::cosim
