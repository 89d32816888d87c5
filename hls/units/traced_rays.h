// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A part of the packet decoder of a fast core: every ray of the world or of an object goes to the
// unit that makes its reciprocals (units/ray_reciprocal.h). Rays in unit space do not come here
// (units/unit_decoder.h). A camera's rays come between those of another packet, and a light's may
// be among them, so two origins are kept.
#pragma once

#include "units/decoded_rays.h"
#include "units/lane_spacing.h"

namespace dynrt {

template <class C>
struct RaysToReciprocals {
  using Real = typename C::Real;
  static constexpr bool kGetsTriangles = false;

  hls::Out<TracedRay<C>> traced;
  HLS_PORTS(traced)

  Vector<Real> origin_of(const PacketVector<C>& in, const JobRecord<C>& job) {
    const bool camera = job.kind == TransformKind::kCamera ||
                        (kLightsAtOnce<C> && job.kind == TransformKind::kSecondary);
    if (in.point && camera) camera_origin_ = in.vector;
    if (in.point && !camera) origin_ = in.vector;
    return camera ? Vector<Real>(camera_origin_) : origin_;
  }
  void pass_on(const PacketVector<C>& in, const JobRecord<C>& job, const Ray<Real>& r,
               LevelRow<C> /*row*/, bool is_new) {
    TracedRay<C> trace;
    trace.is_new = is_new;
    trace.ray = object_ray_of(in, job, r);
    if (is_new || job.kind == TransformKind::kObject) {
      trace.repeat = RepeatCount<C>::from(spacing_.wait(in.ray).raw());
      traced.write(trace);
    }
  }

 private:
  Vector<Real> origin_;  ///< of the packet, whose vectors come one after the other
  Vector<Real> camera_origin_;
  LaneSpacing<C> spacing_;  ///< of traced rays
};

}  // namespace dynrt
