// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A part of the packet decoder: where whole rays go in a core whose slices divide (thesis 6.1.3). A
// ray of the world or of an object is saved for its slice; the last one of an object sends the
// packet to the traversal. Rays in unit space, and a reset for each new ray, go to the
// intersection.
#pragma once

#include "units/intersection_tokens.h"
#include "units/packet_rays.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

/// A transformed ray with its packet and the root of the object's tree that it enters.
template <class C>
ObjectRay<C> object_ray_of(const PacketVector<C>& in, const JobRecord<C>& job,
                           const Ray<typename C::Real>& r) {
  OfInstance<C, NodeAddress<C>> root;
  if constexpr (kTwoLevels<C>) root = job.extra.template trunc<C::kAddressBits>();
  return {in.packet, in.ray, job.active, root, in.last, job.distinct_origins, r};
}

/// The origin of the rays whose directions follow it.
template <class C>
struct OriginBefore {
  Vector<typename C::Real> origin_of(const PacketVector<C>& in, const JobRecord<C>& /*job*/) {
    if (in.point) origin_ = in.vector;
    return origin_;
  }
  Vector<typename C::Real> origin_;  ///< of the packet, whose vectors come one after the other
};

template <class C>
struct RaysToSlices : OriginBefore<C> {
  using Real = typename C::Real;
  static constexpr bool kGetsTriangles = true;

  hls::Out<UnitRay<C>> unit_ray;
  hls::OptionalPort<kTwoLevels<C>, hls::Out<TraversalEvent<C>>> enter_object;
  hls::RamWrite<SliceRay<C>, kLevelRows<C>> ray[kRays<C>];
  HLS_PORTS(unit_ray, enter_object, ray)

  void pass_on(const PacketVector<C>& in, const JobRecord<C>& job, const Ray<Real>& r,
               LevelRow<C> row, bool is_new) {
    const bool triangle = job.kind == TransformKind::kTriangle;
    for (unsigned i = 0; i < kRays<C>; ++i) {
      if (!triangle && in.ray == RayIndex<C>::from(i)) ray[i].write(row, slice_ray<C>(r));
    }
    if (triangle || is_new) unit_ray.write(unit_ray_of(in, job, is_new, r));
    if constexpr (kTwoLevels<C>) {
      const bool object = job.kind == TransformKind::kObject;
      if (object && is_last_ray<C>(in.ray, in.last)) {
        enter_object.write(enter_tree(object_ray_of(in, job, r), job.active));
      }
    }
  }
};

}  // namespace dynrt
