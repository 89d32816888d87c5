// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Intersection with the unit triangle (thesis 5.2): t = -oz / dz, u = t dx + ox, v = t dy + oy, a
// hit where t > 0, u >= -e, v >= -e and u + v <= 1 + e. The z component of the direction is its
// scalar product with the triangle's normal (5.1.2).
#pragma once

#include "units/tokens.h"

namespace dynrt {

template <class C>
struct Intersection {
  using Real = typename C::Real;

  hls::In<UnitRay<C>> unit_ray;
  hls::Out<HitCandidate<C>> candidate;
  HLS_PORTS(unit_ray, candidate)

  void step() {
    const UnitRay<C> in = unit_ray.read();
    const Vector<Real>& o = in.unit.origin;
    const Vector<Real>& d = in.unit.direction;
    HitCandidate<C> out;
    out.packet = in.packet;
    out.ray = in.ray;
    out.reset = in.reset;
    out.t = -o.z / d.z;
    out.u = out.t * d.x + o.x;
    out.v = out.t * d.y + o.y;
    out.cosine = d.z;
    constexpr Real kLow = Real::from_double(-C::kEpsilon);
    constexpr Real kHigh = Real::from_double(1.0 + C::kEpsilon);
    out.hit = !in.reset && !out.t.sign() && !(out.u < kLow) && !(out.v < kLow) &&
              !(kHigh < out.u + out.v);
    candidate.write(out);
  }
};

}  // namespace dynrt
