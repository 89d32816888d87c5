// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/intersection.h"

#include "Vintersection.h"
#include "intersection_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// Coordinates that are equal make products that are, and ends of an edge that are one point.
template <class Real>
void shape_triangle(MappedTriangle<Real>& triangle, Random& random) {
  auto& [a, b, c, cosine] = triangle;
  if (random.below(4) == 0) b.x = random.below(2) ? a.x : -a.x;
  if (random.below(4) == 0) b.y = random.below(2) ? a.y : -a.y;
  if (random.below(4) == 0) c.x = random.below(2) ? b.x : a.y;
  if (random.below(4) == 0) c.y = random.below(2) ? b.y : -b.x;
}
/// A ray in the triangle's space may be any.
template <class Real>
void shape_triangle(Ray<Real>&, Random&) {}

void setup(Bench<Intersection<C>>& bench, const Run&) {
  bench.shape<UnitRay<C>>("unit_ray",
                          [](UnitRay<C>& in, Random& random) { shape_triangle(in.unit, random); });
}

DYNRT_COSIM(Intersection, Intersection<C>, intersection, setup)

}  // namespace
}  // namespace dynrt::cosim
