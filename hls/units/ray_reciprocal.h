// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Ray reciprocal: on the way of every ray into a level of the traversal, the reciprocals of its
// direction's components, by three dividers, so that the slices multiply where they would divide.
// The slices read a ray's origin and these reciprocals; the ray is saved before its packet can come
// to them, as a new ray's reset and an object's entry are sent on from here. A ray whose lane is
// not yet free is repeated, and the last is sent.
//
// A reciprocal has its component's sign, and a power of two's is exact. The range of the numbers is
// not symmetric: of magnitudes from 2^-bias to 2^bias the reciprocal lies within, that of a larger
// one, less than 2^(bias + 2), becomes the smallest number, so planes seem up to four times farther
// along such a component.
#pragma once

#include "units/intersection_tokens.h"
#include "units/packet_rays.h"
#include "units/plane_map.h"
#include "units/repeated.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct RayReciprocal {
  using Real = typename C::Real;

  hls::In<Repeated<TracedRay<C>>> traced;
  hls::Out<UnitRay<C>> reset;
  hls::OptionalPort<kTwoLevels<C>, hls::Out<TraversalEvent<C>>> enter_object;
  hls::RamWrite<SliceRay<C>, kLevelRows<C>> ray[kRays<C>];
  hls::OptionalPort<kCommonOrigin<C>, hls::RamWrite<Vector<Real>, kLevelRows<C>>> origin;
  /// Of every ray in the world, whichever it is.
  hls::OptionalPort<kTestsWorldBox<C>, hls::RamWrite<Vector<Real>, kRayRows<C>>> in_world;
  /// Of every ray in the object that it entered last.
  hls::OptionalPort<kMapsBlocks<C>, hls::RamWrite<PlaneMap<Real>, kRayRows<C>>> map;
  HLS_PORTS(traced, reset, enter_object, ray, origin, in_world, map)

  void step() {
    const Repeated<TracedRay<C>> j = traced.read();
    const Ray<Real>& r = j.job.ray.in_object;
    const Vector<Real>& d = r.direction;
    const Vector<Real> inverse{Real::one() / d.x, Real::one() / d.y, Real::one() / d.z};
    if (j.last) pass_on(j.job, {r.origin, inverse});
  }

 private:
  void pass_on(const TracedRay<C>& traced_ray, const Ray<Real>& saved) {
    const ObjectRay<C>& in = traced_ray.ray;
    const bool is_new = starts(traced_ray);
    const Level level = uint<1>(!is_new);
    const LevelRow<C> row = level_row<C>(level, in.packet);
    write_of_ray(ray, in.ray, row, slice_ray<C>(saved));
    if constexpr (kCommonOrigin<C>) origin.write(row, saved.origin);
    if constexpr (kTestsWorldBox<C>) {
      if (is_new) in_world.write(ray_row<C>(in.packet, in.ray), saved.direction);
    }
    if constexpr (kMapsBlocks<C>) {
      if (!is_new) {
        map.write(ray_row<C>(in.packet, in.ray),
                  plane_map(in.in_object.direction, saved.direction));
      }
    }
    if (is_new) {
      UnitRay<C> first;
      first.packet = in.packet;
      first.ray = in.ray;
      first.reset = true;
      first.last = in.last;
      reset.write(first);
    } else {
      enter(in);
    }
  }
  static bool starts(const TracedRay<C>& ray) {
    if constexpr (kTwoLevels<C>) {
      return ray.is_new;
    } else {
      return true;
    }
  }
  void enter(const ObjectRay<C>& in) {
    if constexpr (kTwoLevels<C>) {
      if (is_last_ray<C>(in.ray, in.last)) enter_object.write(enter_tree(in, in.active));
    }
  }
};

}  // namespace dynrt
