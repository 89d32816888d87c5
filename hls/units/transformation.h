// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Transformation: applies the packet's stored 3x4 affine matrix to one vector a clock with nine
// multipliers and nine adders (thesis 6.1.3). A point is translated, a direction is not (4.4). Each
// component is (m0 x + m1 y) + (m2 z + n), every operation rounded once.
#pragma once

#include "units/tokens.h"

namespace dynrt {

template <class C>
struct Transformation {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<PacketVector<C>> vector;
  hls::Out<PacketVector<C>> transformed;
  hls::RamRead<Vector<Real>, kPackets> column[4];
  HLS_PORTS(vector, transformed, column[0], column[1], column[2], column[3])

  void step() {
    const PacketVector<C> in = vector.read();
    const Vector<Real> c0 = column[0].read(in.packet);
    const Vector<Real> c1 = column[1].read(in.packet);
    const Vector<Real> c2 = column[2].read(in.packet);
    const Vector<Real> n = column[3].read(in.packet);
    PacketVector<C> out = in;
    out.vector.x = component(in, c0.x, c1.x, c2.x, n.x);
    out.vector.y = component(in, c0.y, c1.y, c2.y, n.y);
    out.vector.z = component(in, c0.z, c1.z, c2.z, n.z);
    transformed.write(out);
  }

 private:
  static Real component(const PacketVector<C>& in, Real m0, Real m1, Real m2, Real n) {
    const Real last = m2 * in.vector.z;
    return (m0 * in.vector.x + m1 * in.vector.y) + (in.point ? last + n : last);
  }
};

}  // namespace dynrt
