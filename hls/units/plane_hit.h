// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Plane hit: where a ray meets a triangle in its plane (units/plane_map.h). The areas beyond the
// corners are the corners' weights in the hit point. Three areas, and three heights by their areas,
// are aligned to the largest, cut off kKept bits behind the numbers' own and added as integers.
#pragma once

#include "units/plane_map.h"

namespace dynrt {

template <class R>
struct PlaneSums {
  static constexpr unsigned kM = R::kMantissaBits;
  static constexpr unsigned kKept = 4;
  /// Scenes of any scale: an area has twice the exponent of a length.
  using Wide = hls::Float<R::kExponentBits + 2, kM, R::kRounding>;
  using Significand = uint<kM + 1>;
  /// A power of two by which a term is smaller than it could be.
  using Less = uint<R::kExponentBits + 2>;

  static Less least(Less a, Less b, Less c) {
    const Less ab = a < b ? a : b;
    return ab < c ? ab : c;
  }
  static Less less(Less of, Less least) {
    return (of - least).as_unsigned().template trunc<Less::kWidth>();
  }
  static Less sum(Less a, Less b) { return (a + b).template trunc<Less::kWidth>(); }
  static Wide number(Less exponent, uint<kM> mantissa) {
    return Wide::from_bits(hls::concat(hls::concat(uint<1>(0), exponent), mantissa));
  }
  static uint<kM + 1 + kKept> aligned(Significand area, Less by) {
    return hls::concat(area, uint<kKept>(0)) >> by;
  }
  /// The same as a number, not cut off.
  static Wide as_number(Significand area, Less by) {
    return number(less(Less::from(Wide::kBias + static_cast<int>(kM + kKept)), by),
                  area.template trunc<kM>());
  }

  static constexpr unsigned kProduct = 2 * kM + 3;
  static constexpr unsigned kDropped = kProduct - (kM + 2 + 2 * kKept);  // of the product's bits
  using Height = uint<kProduct - kDropped>;
  /// Rounded down.
  static auto aligned_height(const PlanePart<R>& part, Less by) {
    const auto product = (part.area.to_signed() * part.height).as_unsigned();
    const Height kept = product.template bits<kProduct - 1, kDropped>();
    const Height sign = part.height.negative() ? Height::ones() : Height(0);
    return (((kept ^ sign) >> by) ^ sign).as_signed();
  }
};

template <class R>
TriangleHit<R> intersect(const PlaneTriangle<R>& m) {
  using Sums = PlaneSums<R>;
  using Wide = typename Sums::Wide;
  using Less = typename Sums::Less;

  // An area lacks the exponent of the corner that has no part in it, so the others have it less.
  const auto exponent_of = [](const PlanePart<R>& part) {
    return Less(part.exponent + part.shift);
  };
  const Less exponent = Sums::least(exponent_of(m.a), exponent_of(m.b), exponent_of(m.c));
  const auto weight_less = [&](const PlanePart<R>& part) {
    return Sums::sum(Sums::less(exponent_of(part), exponent), part.zeros);
  };
  const Less weight = Sums::least(weight_less(m.a), weight_less(m.b), weight_less(m.c));
  const auto weight_of = [&](const PlanePart<R>& part) {
    return Sums::aligned(part.area, Sums::less(weight_less(part), weight));
  };
  const auto all = (weight_of(m.a) + weight_of(m.b)) + weight_of(m.c);
  const Wide per_all = Wide::one() / Wide::from_uint(all);
  const auto share_of = [&](const PlanePart<R>& part) {
    return R(Sums::as_number(part.area, Sums::less(weight_less(part), weight)) * per_all);
  };

  // The exponents of a height by its area are those of all three corners.
  const auto height_less = [](const PlanePart<R>& part) { return Less(part.zeros + part.shift); };
  const Less lost = Sums::least(height_less(m.a), height_less(m.b), height_less(m.c));
  const auto height_of = [&](const PlanePart<R>& part) {
    return Sums::aligned_height(part, Sums::less(height_less(part), lost));
  };
  const auto height = (height_of(m.a) + height_of(m.b)) + height_of(m.c);
  const bool below = height.negative();
  const auto size = below ? decltype(height)(0) - height : decltype(height - height)(height);
  const Wide height_size = Wide::from_uint(size.as_unsigned());

  constexpr auto kUnit =
      Less::from(Wide::kBias - R::kBias + static_cast<int>(Sums::kKept + Sums::kDropped) -
                 static_cast<int>(Sums::kM));
  const Less unit = Sums::sum(Sums::less(Sums::sum(weight, exponent), lost), kUnit);
  const Wide per_unit = Wide(m.per_height) * Sums::number(unit, uint<Sums::kM>(0));
  TriangleHit<R> out;
  out.left = m.left;
  out.right = m.right;
  out.t = R(((below ? -height_size : height_size) * per_all) * per_unit);
  out.u = share_of(m.a);
  out.v = share_of(m.b);
  return out;
}

}  // namespace dynrt
