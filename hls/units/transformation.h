// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Transformation: applies the packet's stored 3x4 affine matrix to one vector a clock with nine
// multipliers and nine adders (thesis 6.1.3). A point is translated, a direction is not (4.4). Each
// component is (m0 x + m1 y) + (m2 z + n), every operation rounded once, or a fused dot product.
//
// Where triangles are tested watertight, columns 0 to 2 of a triangle are its corners and column 3
// is its normal. The ray's map takes one corner (units/watertight.h): three subtractions more, and
// the multipliers of column 2. Those of the other columns find the direction's scalar product with
// the normal meanwhile. A plane map takes all three in a clock (units/plane_map.h), and one row of
// the multipliers finds that product.
#pragma once

#include "units/intersection_tokens.h"
#include "units/plane_map.h"
#include "units/transformation_tokens.h"
#include "units/watertight.h"

namespace dynrt {

template <class C>
struct Transformation {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  static constexpr unsigned kRoom = kRoomForBursts<C>;
  static constexpr double kUncertaintyNs = kLongWiresNs<C>;

  hls::In<PacketVector<C>> vector;
  hls::Out<PacketVector<C>> transformed;
  hls::OptionalPort<kPairsUnitRays<C>, hls::Out<PacketVector<C>>> in_unit_space;
  hls::OptionalPort<kMapsBlocks<C>, hls::Out<UnitRay<C>>> in_plane;
  hls::RamRead<Vector<Real>, kPackets> column[4];
  hls::OptionalPort<kMapsCorners<C>, hls::RamRead<RayMap<Real>, kRayRows<C>>> map;
  hls::OptionalPort<kMapsBlocks<C>, hls::RamRead<PlaneMap<Real>, kRayRows<C>>> plane_map;
  HLS_PORTS(vector, transformed, in_unit_space, in_plane, column, map, plane_map)

  void step() {
    const PacketVector<C> in = vector.read();
    const Vector<Real> c0 = column[0].read(in.packet);
    const Vector<Real> c1 = column[1].read(in.packet);
    const Vector<Real> c2 = column[2].read(in.packet);
    const Vector<Real> n = column[3].read(in.packet);
    PacketVector<C> out = in;
    if constexpr (kMapsCorners<C>) {
      map_or_transform(in, c0, c1, c2, n, out);
    } else {
      out.vector.x = component(in, c0.x, c1.x, c2.x, n.x);
      out.vector.y = component(in, c0.y, c1.y, c2.y, n.y);
      // Of a triangle that a plane map takes, the scalar product with the normal.
      const bool corners = kMapsBlocks<C> && in.to_unit.get();
      out.vector.z =
          component(in, corners ? n.x : c0.z, corners ? n.y : c1.z, corners ? n.z : c2.z, n.z);
    }
    const bool to_unit = kFast<C> && in.to_unit.get();
    if constexpr (kPairsUnitRays<C>) {
      if (to_unit) in_unit_space.write(out);
    }
    if constexpr (kMapsBlocks<C>) {
      const PlaneMap<Real> m = plane_map.read(ray_row<C>(in.packet, in.ray));
      UnitRay<C> test;
      test.packet = in.packet;
      test.ray = in.ray;
      test.last = in.last;
      test.unit = plane_triangle(map_corner(m, block_of(c0)), map_corner(m, block_of(c1)),
                                 map_corner(m, block_of(c2)));
      test.unit.per_height = m.per_height;
      test.unit.cosine = out.vector.z;
      if (to_unit) in_plane.write(test);
    }
    if (!to_unit) transformed.write(out);
  }

 private:
  static Real component(const PacketVector<C>& in, Real m0, Real m1, Real m2, Real n) {
    if constexpr (kFast<C>) {
      return Real::of_dot({m0, m1, m2}, {in.vector.x, in.vector.y, in.vector.z}, n, in.point);
    } else {
      const Real last = m2 * in.vector.z;
      return (m0 * in.vector.x + m1 * in.vector.y) + (in.point ? last + n : last);
    }
  }

  /// The same multipliers for both: a corner has other operands.
  void map_or_transform(const PacketVector<C>& in, const Vector<Real>& c0, const Vector<Real>& c1,
                        const Vector<Real>& c2, const Vector<Real>& n, PacketVector<C>& out) {
    const Vector<Real>& v = in.vector;
    const Corner corner = in.corner.get();
    const bool is_corner = corner != Corner(kNoCorner);
    Row x{c0.x, v.x, c1.x, v.y, c2.x, v.z, n.x};
    Row y{c0.y, v.x, c1.y, v.y, c2.y, v.z, n.y};
    Row z{c0.z, v.x, c1.z, v.y, c2.z, v.z, n.z};
    const RayMap<Real> m = map.read(ray_row<C>(in.packet, in.ray));
    if (is_corner) {
      const Vector<Real> at = corner == Corner(0) ? c0 : corner == Corner(1) ? c1 : c2;
      const Vector<Real> e =
          along(m.axis, Vector<Real>{at.x - m.origin.x, at.y - m.origin.y, at.z - m.origin.z});
      x = Row{n.z, v.z, c1.x, v.y, m.shear.x, e.z, e.x};
      y = Row{c0.y, v.x, c1.y, v.y, m.shear.y, e.z, e.y};
      z = Row{n.x, v.x, n.y, v.y, m.shear.z, e.z, n.z};
    }
    const Parts px = parts(x, in.point || is_corner);
    const Parts py = parts(y, in.point || is_corner);
    const Parts pz = parts(z, in.point);
    const Real sum_z = (pz.first + pz.second) + (is_corner ? px.first : pz.last);
    out.vector.x = is_corner ? px.last : (px.first + px.second) + px.last;
    out.vector.y = is_corner ? py.last : (py.first + py.second) + py.last;
    out.vector.z = is_corner ? pz.last : sum_z;
    out.cosine = sum_z;
  }
  /// The operands of one component.
  struct Row {
    Real m0, x, m1, y, m2, z, n;
  };
  struct Parts {
    Real first, second, last;
  };
  static Parts parts(const Row& row, bool translated) {
    const Real last = row.m2 * row.z;
    return {row.m0 * row.x, row.m1 * row.y, translated ? last + row.n : last};
  }
};

}  // namespace dynrt
