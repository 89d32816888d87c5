// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Intersection with the unit objects (thesis 5.2), of which a configuration has some.
//
// The triangle: t = -oz / dz, u = t dx + ox, v = t dy + oy, a hit where t > 0, u >= -e, v >= -e and
// u + v <= 1 + e. The rectangle: the same, but u <= 1 + e and v <= 1 + e. The z component of the
// direction is its scalar product with the unit normal (5.1.2).
//
// The sphere: s = -(o.d) / (d.d) is where the ray comes nearest to the centre, at p = s d + o; with
// r = sqrt((1 - p.p) (d.d)) it is hit at t = s -+ r / (d.d), where d has the scalar product -+ r
// with the normal. That 1 - p.p is taken at p and not at o keeps the digits of a small sphere far
// away. The nearer hit counts unless it lies behind the ray's origin; u and v are p's x and y.
//
// Of a watertight configuration the triangle comes to the ray instead (units/watertight.h,
// units/plane_map.h).
//
// Where the plane's or the sphere's normal has not length one in the world, the matrix brings the
// factor that the scalar product lacks.
#pragma once

#include "units/intersection_tokens.h"

namespace dynrt {

template <class C>
struct Intersection {
  using Real = typename C::Real;

  hls::In<UnitRay<C>> unit_ray;
  hls::Out<HitCandidate<C>> candidate;
  HLS_PORTS(unit_ray, candidate)

  void step() {
    const UnitRay<C> in = unit_ray.read();
    HitCandidate<C> out;
    out.packet = in.packet;
    out.ray = in.ray;
    out.reset = in.reset;
    out.last = in.last;
    if constexpr (kWatertight<C>) {
      const TriangleHit<Real> found = intersect(in.unit);
      out.hit = !in.reset && found.hit();
      out.t = found.t;
      out.u = found.u;
      out.v = found.v;
      out.cosine = in.unit.cosine;
    } else {
      intersect_unit_object(in, out);
    }
    candidate.write(out);
  }

 private:
  static void intersect_unit_object(const UnitRay<C>& in, HitCandidate<C>& out) {
    const Vector<Real>& o = in.unit.origin;
    const Vector<Real>& d = in.unit.direction;
    const bool sphere = is_primitive<C>(Primitive::kSphere, in.primitive);
    Real height = o.z;
    Real denominator = d.z;
    if constexpr (C::kPrimitives.sphere) {
      if (sphere) {
        height = dot(o, d);
        denominator = dot(d, d);
      }
    }
    out.t = -height / denominator;
    out.u = out.t * d.x + o.x;
    out.v = out.t * d.y + o.y;
    out.cosine = d.z;
    bool met = true;  // of the sphere, not only of its diameter
    if constexpr (C::kPrimitives.sphere) {
      const Vector<Real> nearest{out.u, out.v, out.t * d.z + o.z};
      const Real within = Real::one() - dot(nearest, nearest);
      const Real root = sqrt(within * denominator);
      const Real half = root / denominator;
      const Real first = out.t - half;
      if (sphere) {
        met = !within.sign();
        out.cosine = first.sign() ? root : -root;
        out.t = first.sign() ? out.t + half : first;
      }
    }
    if constexpr (kScalesCosine<C>) out.cosine = out.cosine * in.cosine_factor.get();
    constexpr Real kLow = Real::from_double(-C::kEpsilon);
    constexpr Real kHigh = Real::from_double(1.0 + C::kEpsilon);
    const bool rectangle = is_primitive<C>(Primitive::kRectangle, in.primitive);
    out.hit = !in.reset && !out.t.sign() &&
              (sphere ? met
                      : !(out.u < kLow) && !(out.v < kLow) &&
                            (rectangle ? !(kHigh < out.u) && !(kHigh < out.v)
                                       : !(kHigh < out.u + out.v)));
  }
  static Real dot(const Vector<Real>& a, const Vector<Real>& b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
  }
};

}  // namespace dynrt
