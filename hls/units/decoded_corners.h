// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A part of the packet decoder: where rays and mapped corners go in a core that tests triangles
// watertight by each ray's shear (units/watertight.h). Rays that enter an object go to the unit
// that makes the shear; three corners in the plane of a ray make one test.
#pragma once

#include "units/decoded_rays.h"

namespace dynrt {

template <class C>
struct RaysToShear : OriginBefore<C> {
  using Real = typename C::Real;
  static constexpr bool kGetsTriangles = true;

  hls::Out<UnitRay<C>> unit_ray;
  hls::Out<ObjectRay<C>> object_ray;
  hls::RamWrite<SliceRay<C>, kLevelRows<C>> ray[kRays<C>];
  HLS_PORTS(unit_ray, object_ray, ray)

  void pass_on(const PacketVector<C>& in, const JobRecord<C>& job, const Ray<Real>& r,
               LevelRow<C> row, bool is_new) {
    const bool triangle = job.kind == TransformKind::kTriangle;
    for (unsigned i = 0; i < kRays<C>; ++i) {
      if (!triangle && in.ray == RayIndex<C>::from(i)) ray[i].write(row, slice_ray<C>(r));
    }
    UnitRay<C> test;
    test.packet = in.packet;
    test.ray = in.ray;
    test.reset = is_new;
    test.last = in.last;
    test.unit = {first_corner_, second_corner_, in.vector, in.cosine.get()};
    if (is_new || (triangle && in.corner.get() == Corner(2))) unit_ray.write(test);
    if (in.corner.get() == Corner(0)) first_corner_ = in.vector;
    if (in.corner.get() == Corner(1)) second_corner_ = in.vector;
    if (job.kind == TransformKind::kObject) object_ray.write(object_ray_of(in, job, r));
  }

 private:
  Vector<Real> first_corner_, second_corner_;  ///< of the triangle that is being mapped
};

}  // namespace dynrt
