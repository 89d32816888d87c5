// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The watertight triangle test: the ray's origin is subtracted from the triangle's corners and a
// shear takes its direction to the third axis (Woop, Benthin, Wald, "Watertight Ray/Triangle
// Intersection", 2013). The map belongs to the ray alone, so that a corner that two triangles share
// is mapped to the same point for both; whether the axis passes inside an edge is then decided by
// exact products. Hence no ray passes between two triangles, or hits both, at the edge that they
// share, however the map is rounded (docs/explanation/watertight.md).
#pragma once

#include "units/packet.h"

namespace dynrt {

/// A ray's map: a corner v goes to (e_x + s_x e_z, e_y + s_y e_z, s_z e_z), where e = v - origin
/// and z is the axis along which the direction is longest, x and y the two that follow.
template <class R>
struct RayMap {
  Vector<R> origin;
  Vector<R> shear;
  uint<2> axis;
  HLS_FIELDS(origin, shear, axis)
};

/// x, y and z in the order that makes the axis the third.
template <class V>
V along(uint<2> axis, const V& v) {
  V out = v;
  out.x = axis == uint<2>(2) ? v.x : axis == uint<2>(1) ? v.z : v.y;
  out.y = axis == uint<2>(2) ? v.y : axis == uint<2>(1) ? v.x : v.z;
  out.z = axis == uint<2>(2) ? v.z : axis == uint<2>(1) ? v.y : v.x;
  return out;
}

/// The axis of the longest component; of equals the first.
template <class R>
uint<2> longest_axis(const Vector<R>& d) {
  const bool y_leads = abs(d.x) < abs(d.y);
  const bool z_leads = (y_leads ? abs(d.y) : abs(d.x)) < abs(d.z);
  return z_leads ? uint<2>(2) : uint<2>(uint<1>(y_leads));
}

template <class R>
RayMap<R> ray_map(const Ray<R>& ray) {
  const Vector<R>& d = ray.direction;
  RayMap<R> map;
  map.origin = ray.origin;
  map.axis = longest_axis(d);
  const Vector<R> turned = along(map.axis, d);
  map.shear.z = R::one() / turned.z;
  map.shear.x = -(turned.x * map.shear.z);
  map.shear.y = -(turned.y * map.shear.z);
  return map;
}

/// A triangle whose corners are mapped, and the scalar product of the ray's direction and its
/// normal.
template <class R>
struct MappedTriangle {
  Vector<R> a, b, c;
  R cosine;
  HLS_FIELDS(a, b, c, cosine)
};

/// On which side of a directed edge of mapped corners the axis passes, and twice the area between
/// the two.
template <class R>
struct EdgeSide {
  /// Scenes of any scale: an area has twice the exponent of a length.
  using Area = hls::Float<R::kExponentBits + 2, R::kMantissaBits, R::kRounding>;
  bool left = false;
  bool right = false;  ///< neither: the edge's ends are one point
  Area area;           ///< positive
};

/// Where both products are equal the axis meets the line of the edge and is moved a little towards
/// -x. As no coordinate is zero, ends at the same height are then the same point.
template <class R>
EdgeSide<R> side_of(const Vector<R>& from, const Vector<R>& to) {
  const auto ahead = exact_product(from.x, to.y);
  const auto back = exact_product(from.y, to.x);
  const bool met = ahead == back;
  EdgeSide<R> side;
  side.left = met ? from.y < to.y : back < ahead;
  side.right = met ? to.y < from.y : ahead < back;
  side.area = abs(EdgeSide<R>::Area::of_difference(ahead, back));
  return side;
}

/// The result of the test: the side of all edges on which the ray's line passes, if it is the same;
/// the parameter there, and the weights of the corners a and b in the hit point, as for the unit
/// triangle.
template <class R>
struct TriangleHit {
  bool left, right;
  R t, u, v;
  bool hit() const { return (left || right) && !t.sign(); }
};

template <class R>
TriangleHit<R> intersect(const MappedTriangle<R>& m) {
  using Area = typename EdgeSide<R>::Area;
  const EdgeSide<R> a = side_of(m.b, m.c);
  const EdgeSide<R> b = side_of(m.c, m.a);
  const EdgeSide<R> c = side_of(m.a, m.b);
  // The areas of a hit have one sign, so that it cancels in all quotients.
  const Area all = (a.area + b.area) + c.area;
  const Area height = (a.area * Area(m.a.z) + b.area * Area(m.b.z)) + c.area * Area(m.c.z);
  TriangleHit<R> out;
  out.left = a.left && b.left && c.left;
  out.right = a.right && b.right && c.right;
  out.t = R(height / all);
  out.u = R(a.area / all);
  out.v = R(b.area / all);
  return out;
}

}  // namespace dynrt
