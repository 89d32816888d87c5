// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Camera rays: makes the rays of a new packet beside the transformation, a component of a direction
// a clock with two multipliers and two adders. A pre-primary ray (x, y, 1) of thesis 6.2.1 has a
// component m0 x + m1 y + m2 in the world, rounded as the transformation rounds it; the origin is
// the matrix's translation. A light ray (6.2.2) begins at the light l, the translation of its
// matrix, and goes to the point o + t d that a ray has hit: a component is 1 o + t d - l.
#pragma once

#include "units/frame.h"
#include "units/packet_rays.h"
#include "units/repeated.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"

namespace dynrt {

template <class C>
struct CameraRays {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<Repeated<CameraJob<C>>> job;  ///< three times for each ray
  hls::OptionalPort<C::kUncompressed, hls::Config<FrameRegisters<C>>> frame;
  hls::Out<PacketVector<C>> vector;
  hls::RamRead<Vector<Real>, 1> column[3];  ///< of the camera's matrix
  hls::RamRead<Vector<Real>, kEyeRows<C>> eye;
  hls::RamRead<PixelPosition, kPackets> position;
  hls::OptionalPort<kLightsAtOnce<C>, hls::RamRead<Ray<Real>, kRayRows<C>>> arriving;
  hls::OptionalPort<kLightsAtOnce<C>, hls::RamRead<SurfacePoint<C>, kRayRows<C>>> surface;
  HLS_PORTS(job, frame, vector, column, eye, position, arriving, surface)

  void step() {
    const Repeated<CameraJob<C>> j = job.read();
    const PacketId<C> packet = j.job.packet;
    const RayIndex<C> ray = ray_of(j);
    const PixelPosition p = pixel_of<C>(position.read(packet), ray);
    const Real m0 = component(column[0].read({}));
    const Real m1 = component(column[1].read({}));
    const Real m2 = component(column[2].read({}));
    const Vector<Real> origin = eye.read(eye_row<C>(packet));
    Factors f{m0, Real::from_uint(p.x), m1, Real::from_uint(p.y), m2};
    if constexpr (kLightsAtOnce<C>) {
      const Ray<Real> r = arriving.read(ray_row<C>(packet, ray));
      const Real t = surface.read(ray_row<C>(packet, ray)).t;
      if (j.job.to_light.get()) {
        f = {component(r.origin), Real::one(), component(r.direction), t, -component(origin)};
      }
    }
    const Real made = sum(f);

    // The origin goes first, with the ray's first component, which is not sent.
    PacketVector<C> out{packet, axis_ == uint<2>(0), ray, {x_, y_, made}};
    if (out.point) out.vector = origin;
    out.last = j.last;
    const bool first = kLightsAtOnce<C> ? j.index == RepeatCount<C>{} : ray == RayIndex<C>{};
    const bool sends_origin = first || sends_pairs();
    if (out.point ? sends_origin : axis_ == uint<2>(2)) vector.write(out);

    if (axis_ == uint<2>(0)) x_ = made;
    if (axis_ == uint<2>(1)) y_ = made;
    if (axis_ == uint<2>(2)) end_ray(j);
    axis_ = axis_ == uint<2>(2) ? uint<2>(0) : hls::next(axis_);
  }

 private:
  /// Of a component m0 x + m1 y + m2.
  struct Factors {
    Real m0, x, m1, y, m2;
  };
  static Real sum(const Factors& f) { return Real::of_dot({f.m0, f.m1}, {f.x, f.y}, f.m2, true); }
  /// The ray whose components are being made.
  RayIndex<C> ray_of(const Repeated<CameraJob<C>>& j) const {
    if constexpr (kLightsAtOnce<C>) {
      return lowest_ray<C>(left(j));
    } else {
      return ray_.get();
    }
  }
  void end_ray(const Repeated<CameraJob<C>>& j) {
    if constexpr (kLightsAtOnce<C>) {
      left_ = without_lowest(left(j));
    } else {
      ray_ = hls::next(ray_.get());
    }
  }
  /// The packet's rays that are not yet made.
  RayMask<C> left(const Repeated<CameraJob<C>>& j) const {
    const bool begins = j.index < RepeatCount<C>(3);
    if (!begins) return left_.get();
    return j.job.to_light.get() ? j.job.lit.get() : RayMask<C>::ones();
  }
  Real component(const Vector<Real>& v) const {
    return axis_ == uint<2>(0) ? v.x : axis_ == uint<2>(1) ? v.y : v.z;
  }
  bool sends_pairs() const {
    if constexpr (C::kUncompressed) {
      return frame.get().uncompressed.get().template bit<0>();
    } else {
      return false;
    }
  }

  // Jobs come whole and one after the other, so that each begins where these begin.
  uint<2> axis_;
  hls::OptionalField<!kLightsAtOnce<C>, RayIndex<C>> ray_{};
  hls::OptionalField<kLightsAtOnce<C>, RayMask<C>> left_{};
  Real x_, y_;  ///< of the direction whose last component is to come
};

}  // namespace dynrt
