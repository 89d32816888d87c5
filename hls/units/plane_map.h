// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Plane map: the watertight triangle test of units/watertight.h where the rays of a packet start at
// one point. That point is subtracted from the triangle's corners once for the packet, and what is
// left of a corner gets one exponent for its three components. From there on it is integers: a
// ray's shear maps a corner by two products, and on which side of an edge the ray passes is the
// sign of a difference of two more, without a shift.
//
// The map belongs to the ray and the corner alone, so a corner that two triangles share goes to the
// same point of the plane for both. Scaling a point by its exponent does not change its direction
// from the axis, and the directions of a triangle's corners alone decide whether it winds round the
// axis (docs/explanation/watertight.md).
#pragma once

#include "units/watertight.h"

namespace dynrt {

/// A coordinate that a multiplier takes: the significand of a number and a sign.
template <class R>
using Coordinate = sint<R::kMantissaBits + 2>;

/// Bits that a corner has behind those, so that cutting them off costs little.
inline constexpr unsigned kGuardBits = 2;

/// Three numbers with the exponent of the largest, cut off towards zero: each is its integer times
/// 2^(exponent - bias - kMantissaBits - kGuardBits).
template <class R>
struct BlockVector {
  using Component = sint<R::kMantissaBits + 2 + kGuardBits>;
  Component x, y, z;
  uint<R::kExponentBits> exponent;
  HLS_FIELDS(x, y, z, exponent)
};

template <class R>
BlockVector<R> block_vector(const Vector<R>& v) {
  using Exponent = uint<R::kExponentBits>;
  const Exponent xy = v.x.exponent() < v.y.exponent() ? v.y.exponent() : v.x.exponent();
  const Exponent largest = xy < v.z.exponent() ? v.z.exponent() : xy;
  const auto component = [&](R of) {
    const auto significand = hls::concat(uint<1>(1), of.mantissa());
    const auto less = (largest - of.exponent()).as_unsigned().template trunc<R::kExponentBits>();
    const auto magnitude = hls::concat(significand, uint<kGuardBits>(0)) >> less;
    return of.sign() ? decltype(magnitude)(0) - magnitude : magnitude.to_signed();
  };
  return {component(v.x), component(v.y), component(v.z), largest};
}

/// The same bits in the place of a matrix's column.
template <class R>
Vector<R> as_column(const BlockVector<R>& block) {
  constexpr unsigned kFree = R::kLeafWidth - BlockVector<R>::Component::kWidth;
  static_assert(2 * kFree >= R::kExponentBits, "the exponent fills what components leave");
  const auto exponent = block.exponent.template zext<2 * kFree>();
  const auto word = [](auto high, auto component) {
    return R::from_bits(hls::concat(high, component.as_unsigned()));
  };
  return {word(exponent.template trunc<kFree>(), block.x),
          word(exponent.template bits<2 * kFree - 1, kFree>(), block.y),
          word(uint<kFree>(0), block.z)};
}
template <class R>
BlockVector<R> block_of(const Vector<R>& column) {
  constexpr unsigned kWidth = BlockVector<R>::Component::kWidth;
  const auto x = column.x.bits();
  const auto y = column.y.bits();
  const auto component = [](auto bits) { return bits.template trunc<kWidth>().as_signed(); };
  const auto exponent = hls::concat(y.template bits<R::kLeafWidth - 1, kWidth>(),
                                    x.template bits<R::kLeafWidth - 1, kWidth>());
  return {component(x), component(y), component(column.z.bits()),
          exponent.template trunc<R::kExponentBits>()};
}

/// A ray's map: e goes to (e_x + x e_z, e_y + y e_z, e_z), where z is the axis along which the
/// direction d is longest, x and y the two that follow. Slopes are -d_x / d_z and -d_y / d_z, in
/// units of 2^-(kMantissaBits + 1).
template <class R>
struct PlaneMap {
  Coordinate<R> x, y;
  uint<2> axis;
  R per_height;  ///< 1 / d_z
  HLS_FIELDS(x, y, axis, per_height)
};

/// -(a / d), where a is at most as long as d, whose reciprocal is given; cut off towards zero.
template <class R>
Coordinate<R> slope(R a, R reciprocal) {
  using Product = typename R::Product;
  constexpr unsigned kExponentBits = Product::kExponentBits;
  constexpr auto kBelowOne = uint<kExponentBits>::from(Product::kBias - 1);
  const Product quotient = exact_product(a, reciprocal);
  const auto kept =
      quotient.mantissa()
          .template bits<Product::kMantissaBits - 1, Product::kMantissaBits - R::kMantissaBits>();
  const auto significand = hls::concat(uint<1>(1), kept);
  const auto less = (kBelowOne - quotient.exponent()).as_unsigned().template trunc<kExponentBits>();
  const bool is_one = kBelowOne < quotient.exponent();
  const auto magnitude = is_one ? decltype(significand)::ones() : significand >> less;
  return quotient.sign() ? magnitude.to_signed() : decltype(magnitude)(0) - magnitude;
}

template <class R>
PlaneMap<R> plane_map(const Vector<R>& direction, const Vector<R>& reciprocals) {
  PlaneMap<R> map;
  map.axis = longest_axis(direction);
  const Vector<R> d = along(map.axis, direction);
  map.per_height = along(map.axis, reciprocals).z;
  map.x = slope(d.x, map.per_height);
  map.y = slope(d.y, map.per_height);
  return map;
}

/// A corner in the plane of a ray. x is odd, so that no corner lies on the axis. x and y have one
/// more guard bit cut off for each step of `shift`, z all of them.
template <class R>
struct PlaneCorner {
  using Shift = uint<hls::index_width(kGuardBits + 2)>;
  Coordinate<R> x, y, z;
  uint<R::kExponentBits> exponent;
  Shift shift;
  HLS_FIELDS(x, y, z, exponent, shift)
};

template <class R>
PlaneCorner<R> map_corner(const PlaneMap<R>& map, const BlockVector<R>& corner) {
  constexpr unsigned kWidth = Coordinate<R>::kWidth;
  constexpr unsigned kWide = kWidth + kGuardBits + 1;  // of a sum
  using Shift = typename PlaneCorner<R>::Shift;
  const BlockVector<R> e = along(map.axis, corner);
  const auto z = e.z.as_unsigned().template bits<kWidth + kGuardBits - 1, kGuardBits>().as_signed();
  const auto sheared = [&](auto component, Coordinate<R> by) {
    const auto product = (by * z).as_unsigned();
    const auto in_units = product.template bits<2 * kWidth - 1, kWidth - 1 - kGuardBits>();
    return (component + in_units.as_signed()).template trunc<kWide>().as_unsigned();
  };
  const uint<kWide> x = sheared(e.x, map.x);
  const uint<kWide> y = sheared(e.y, map.y);

  // The bits of both that are not yet copies of the signs.
  const auto beyond = [](uint<kWide> of) {
    const auto top = of.template bits<kWide - 2, kWidth - 1>();
    return of.template bit<kWide - 1>() ? ~top : top;
  };
  const auto used = beyond(x) | beyond(y);
  Shift shift;
  for (unsigned i = 0; i <= kGuardBits; ++i) {
    if (used.bit(i)) shift = Shift::from(i + 1);
  }
  PlaneCorner<R> out;
  out.x = ((x >> shift).template trunc<kWidth>() | uint<kWidth>(1)).as_signed();
  out.y = (y >> shift).template trunc<kWidth>().as_signed();
  out.z = z;
  out.exponent = e.exponent;
  out.shift = shift;
  return out;
}

/// On which side of a directed edge the axis passes, and twice the area between the two in units
/// that the corners' exponents and shifts give, to the right less one of them.
template <class R>
struct PlaneEdge {
  using Area = uint<2 * R::kMantissaBits + 4>;
  bool left = false;
  bool right = false;  ///< neither: the edge's ends lie in one direction from the axis
  Area area;
};

/// Where the axis meets the line of the edge between its ends, the end with the smaller x counts as
/// if it were a little higher.
template <class R>
PlaneEdge<R> edge_of(const PlaneCorner<R>& from, const PlaneCorner<R>& to) {
  const auto ahead = from.x * to.y;
  const auto back = from.y * to.x;
  const auto cross = ahead - back;
  const bool met = ahead == back;
  PlaneEdge<R> edge;
  edge.left = met ? !from.x.negative() && to.x.negative() : !cross.negative();
  edge.right = met ? from.x.negative() && !to.x.negative() : cross.negative();
  const auto size = cross.as_unsigned().template trunc<PlaneEdge<R>::Area::kWidth>();
  edge.area = cross.negative() ? ~size : size;
  return edge;
}

/// A corner's part in a hit: the area beyond it, without the zeros before its highest one, and the
/// corner's height above the ray's origin.
template <class R>
struct PlanePart {
  using Zeros =
      decltype(hls::count_leading_zeros(hls::concat(typename PlaneEdge<R>::Area{}, uint<1>(1))));
  uint<R::kMantissaBits + 1> area;
  Zeros zeros;
  Coordinate<R> height;
  uint<R::kExponentBits> exponent;  ///< of the corner
  typename PlaneCorner<R>::Shift shift;
  HLS_FIELDS(area, zeros, height, exponent, shift)
};

template <class R>
PlanePart<R> part_of(const PlaneCorner<R>& corner, typename PlaneEdge<R>::Area beyond) {
  constexpr unsigned kWidth = PlaneEdge<R>::Area::kWidth;
  PlanePart<R> part;
  part.zeros = hls::count_leading_zeros(hls::concat(beyond, uint<1>(1)));
  const auto shifted = hls::concat(beyond, uint<1>(0)) << part.zeros;
  part.area = shifted.template bits<kWidth, kWidth - R::kMantissaBits>();
  part.height = corner.z;
  part.exponent = corner.exponent;
  part.shift = corner.shift;
  return part;
}

/// A triangle in the plane of a ray: whether the ray's line passes on one side of all edges.
template <class R>
struct PlaneTriangle {
  PlanePart<R> a, b, c;
  bool left = false;
  bool right = false;
  R per_height;  ///< of the ray's map
  R cosine;      ///< the scalar product of the ray's direction and the unit normal
  HLS_FIELDS(a, b, c, left, right, per_height, cosine)
};

template <class R>
PlaneTriangle<R> plane_triangle(const PlaneCorner<R>& a, const PlaneCorner<R>& b,
                                const PlaneCorner<R>& c) {
  const PlaneEdge<R> beyond_a = edge_of(b, c);
  const PlaneEdge<R> beyond_b = edge_of(c, a);
  const PlaneEdge<R> beyond_c = edge_of(a, b);
  PlaneTriangle<R> triangle;
  triangle.a = part_of(a, beyond_a.area);
  triangle.b = part_of(b, beyond_b.area);
  triangle.c = part_of(c, beyond_c.area);
  triangle.left = beyond_a.left && beyond_b.left && beyond_c.left;
  triangle.right = beyond_a.right && beyond_b.right && beyond_c.right;
  return triangle;
}

}  // namespace dynrt
