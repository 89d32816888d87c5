// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Ray reciprocal: on the way of every ray into a level of the traversal, the reciprocals of its
// direction's components, one a clock by one divider or a ray a clock by three, so that the slices
// multiply where they would divide. The slices read a ray's origin and these reciprocals; the ray
// is saved before its packet can come to them, as a new ray's reset and an object's entry are sent
// on from here. Three dividers repeat a ray whose lane is not yet free, and send the last.
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
  hls::OptionalPort<kTwoLevels<C> && !kClipsToBox<C>, hls::Out<TraversalEvent<C>>> enter_object;
  hls::OptionalPort<kClipsToBox<C>, hls::Out<ObjectRay<C>>> object_ray;  ///< with the reciprocals
  hls::RamWrite<SliceRay<C>, kLevelRows<C>> ray[kRays<C>];
  hls::OptionalPort<kCommonOrigin<C>, hls::RamWrite<Vector<Real>, kLevelRows<C>>> origin;
  /// Of every ray in the world, whichever it is.
  hls::OptionalPort<kTestsWorldBox<C>, hls::RamWrite<Vector<Real>, kRayRows<C>>> in_world;
  /// Of every ray in the object that it entered last.
  hls::OptionalPort<kMapsBlocks<C>, hls::RamWrite<PlaneMap<Real>, kRayRows<C>>> map;
  HLS_PORTS(traced, reset, enter_object, object_ray, ray, origin, in_world, map)

  void step() {
    const Repeated<TracedRay<C>> j = traced.read();
    if constexpr (kInvertsAtOnce<C>) {
      const Ray<Real>& r = j.job.ray.in_object;
      const Vector<Real>& d = r.direction;
      const Vector<Real> inverse{Real::one() / d.x, Real::one() / d.y, Real::one() / d.z};
      if (j.last) pass_on(j.job, {r.origin, inverse});
    } else {
      step_of_axis(j);
    }
  }

 private:
  void step_of_axis(const Repeated<TracedRay<C>>& j) {
    const ObjectRay<C>& in = j.job.ray;
    const Vector<Real>& d = in.in_object.direction;
    const Real component = j.index == RepeatCount<C>(0)   ? d.x
                           : j.index == RepeatCount<C>(1) ? d.y
                                                          : d.z;
    const Real reciprocal = Real::one() / component;
    const Ray<Real> saved{in.in_object.origin, {x_, y_, reciprocal}};
    if (j.index == RepeatCount<C>(0)) x_ = reciprocal;
    if (j.index == RepeatCount<C>(1)) y_ = reciprocal;

    if (j.last) pass_on(j.job, saved);
  }
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
      enter(in, saved);
    }
  }
  static bool starts(const TracedRay<C>& ray) {
    if constexpr (kTwoLevels<C>) {
      return ray.is_new;
    } else {
      return true;
    }
  }
  void enter(const ObjectRay<C>& in, const Ray<Real>& saved) {
    if constexpr (!kTwoLevels<C>) {
      return;
    } else if constexpr (kClipsToBox<C>) {
      ObjectRay<C> out = in;
      out.in_object = saved;
      object_ray.write(out);
    } else if (is_last_ray<C>(in.ray, in.last)) {
      enter_object.write(enter_tree(in, in.active));
    }
  }

  Real x_, y_;  ///< of the ray whose last axis is to come
};

}  // namespace dynrt
