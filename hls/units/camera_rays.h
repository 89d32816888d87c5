// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Camera rays: makes the rays of a new packet beside the transformation, a component of a direction
// a clock with two multipliers and two adders. A pre-primary ray (x, y, 1) of thesis 6.2.1 has a
// component m0 x + m1 y + m2 in the world, rounded as the transformation rounds it; the origin is
// the matrix's translation.
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
  hls::RamRead<Vector<Real>, kPackets> column[4];
  hls::RamRead<PixelPosition, kPackets> position;
  HLS_PORTS(job, frame, vector, column, position)

  void step() {
    const Repeated<CameraJob<C>> j = job.read();
    const PacketId<C> packet = j.job.packet;
    const PixelPosition p = pixel_of<C>(position.read(packet), ray_);
    const Real m0 = component(column[0].read(packet));
    const Real m1 = component(column[1].read(packet));
    const Real m2 = component(column[2].read(packet));
    const Vector<Real> origin = column[3].read(packet);
    const Real made = sum(m0, Real::from_uint(p.x), m1, Real::from_uint(p.y), m2);

    // The origin goes first, with the ray's first component, which is not sent.
    PacketVector<C> out{packet, axis_ == uint<2>(0), ray_, {x_, y_, made}};
    if (out.point) out.vector = origin;
    out.last = j.last;
    const bool sends_origin = ray_ == RayIndex<C>{} || sends_pairs();
    if (out.point ? sends_origin : axis_ == uint<2>(2)) vector.write(out);

    if (axis_ == uint<2>(0)) x_ = made;
    if (axis_ == uint<2>(1)) y_ = made;
    if (axis_ == uint<2>(2)) ray_ = hls::next(ray_);
    axis_ = axis_ == uint<2>(2) ? uint<2>(0) : hls::next(axis_);
  }

 private:
  static Real sum(Real m0, Real x, Real m1, Real y, Real m2) {
    if constexpr (kFusesSums<C>) {
      return Real::of_dot({m0, m1}, {x, y}, m2, true);
    } else {
      return (m0 * x + m1 * y) + m2;
    }
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
  RayIndex<C> ray_;
  Real x_, y_;  ///< of the direction whose last component is to come
};

}  // namespace dynrt
