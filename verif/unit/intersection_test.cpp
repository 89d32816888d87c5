// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/intersection.h"

#include "Vintersection.h"
#include "intersection_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// Coordinates that are equal make products that are, and ends of an edge that are one point.
/// Of mapped triangles some with equal coordinates; generic, as other rays have none.
constexpr auto kSetup = [](auto& bench, const Run&) {
  if constexpr (kMapsCorners<C>) {
    bench.template shape<UnitRay<C>>("unit_ray", [](auto& in, Random& random) {
      auto& [a, b, c, cosine] = in.unit;
      if (random.below(4) == 0) b.x = random.below(2) ? a.x : -a.x;
      if (random.below(4) == 0) b.y = random.below(2) ? a.y : -a.y;
      if (random.below(4) == 0) c.x = random.below(2) ? b.x : a.y;
      if (random.below(4) == 0) c.y = random.below(2) ? b.y : -b.x;
    });
  }
};

DYNRT_COSIM(Intersection, Intersection<C>, intersection, kSetup)

}  // namespace
}  // namespace dynrt::cosim
