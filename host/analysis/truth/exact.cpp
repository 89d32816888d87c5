// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/exact.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>

namespace dynrt::host {

namespace {

using Interval = CGAL::Interval_nt_advanced;  // needs the processor to round upwards
using Exact = CGAL::Exact_rational;
using RoundUpwards = CGAL::Protect_FPU_rounding<true>;

constexpr double kPrecision = 1e-13;

template <class N>
struct Triple {
  N x, y, z;
};

template <class N>
Triple<N> difference(const glm::dvec3& a, const glm::dvec3& b) {
  return {N(a.x) - N(b.x), N(a.y) - N(b.y), N(a.z) - N(b.z)};
}
template <class N>
Triple<N> product(const Triple<N>& a, const Triple<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
N dot(const Triple<N>& a, const Triple<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
Triple<N> as(const glm::dvec3& v) {
  return {N(v.x), N(v.y), N(v.z)};
}

/// The functions that are all positive or all negative for a hit: the edge functions of a triangle;
/// of a rectangle u, v, 1 - u and 1 - v times N . D.
template <class N>
struct Bounds {
  std::array<N, 4> values;
  std::size_t count;
};

template <class N>
N determinant_of(const Line& line, const FlatShape& shape) {
  const auto& [a, b, c] = shape.corners;
  return dot(as<N>(line.direction), product(difference<N>(a, c), difference<N>(b, c)));
}

template <class N>
Bounds<N> bounds_of(const Line& line, const FlatShape& shape) {
  const auto& [a, b, c] = shape.corners;
  const Triple<N> to_a = difference<N>(a, line.origin);
  const Triple<N> to_b = difference<N>(b, line.origin);
  const Triple<N> to_c = difference<N>(c, line.origin);
  const Triple<N> direction = as<N>(line.direction);
  const Triple<N> by_a = product(direction, to_a);
  const N of_a = dot(product(direction, to_b), to_c);
  const N of_b = -dot(by_a, to_c);
  if (!shape.rectangle) return {{of_a, of_b, dot(by_a, to_b), N(0)}, 3};
  const N determinant = determinant_of<N>(line, shape);
  return {{of_a, of_b, determinant - of_a, determinant - of_b}, 4};
}

template <class N>
struct Quotient {
  N numerator, denominator;  ///< of t
};

template <class N>
Quotient<N> t_of(const Line& line, const FlatShape& shape) {
  const auto& [a, b, c] = shape.corners;
  const Triple<N> normal = product(difference<N>(a, c), difference<N>(b, c));
  return {dot(normal, difference<N>(c, line.origin)), dot(normal, as<N>(line.direction))};
}

int sign_of(const Exact& x) { return static_cast<int>(CGAL::sign(x)); }

struct Signs {
  unsigned positive = 0, negative = 0, zero = 0;
  void add(int sign) { ++(sign > 0 ? positive : sign < 0 ? negative : zero); }
  bool mixed() const { return positive > 0 && negative > 0; }
};

bool is_narrow(const Interval& x, double scale) {
  return x.sup() - x.inf() <= kPrecision * std::max(scale, std::abs(x.sup()));
}
double middle(const Interval& x) { return 0.5 * (x.inf() + x.sup()); }

/// Nothing where intervals are too wide to tell.
std::optional<PlaneValues> quick_values(const Line& line, const FlatShape& shape) {
  const RoundUpwards rounding;
  const Quotient<Interval> quotient = t_of<Interval>(line, shape);
  if (quotient.denominator.do_overlap(Interval(0))) return std::nullopt;
  const Bounds<Interval> bounds = bounds_of<Interval>(line, shape);
  const Interval t = quotient.numerator / quotient.denominator;
  const Interval u = bounds.values[0] / quotient.denominator;
  const Interval v = bounds.values[1] / quotient.denominator;
  if (!is_narrow(t, 0) || !is_narrow(u, 1) || !is_narrow(v, 1)) return std::nullopt;
  return PlaneValues{middle(t), middle(u), middle(v)};
}

}  // namespace

Crossing cross(const Line& line, const FlatShape& shape, std::uint64_t& exact) {
  const RoundUpwards rounding;
  const Bounds<Interval> bounds = bounds_of<Interval>(line, shape);
  Signs signs;
  bool open = false;
  for (std::size_t i = 0; i < bounds.count; ++i) {
    const auto sign = CGAL::sign(bounds.values[i]);
    if (sign.is_certain()) {
      signs.add(static_cast<int>(sign.make_certain()));
    } else {
      open = true;
    }
    if (signs.mixed()) return {};
  }
  if (open) {
    ++exact;
    const Bounds<Exact> all = bounds_of<Exact>(line, shape);
    signs = {};
    for (std::size_t i = 0; i < all.count; ++i) signs.add(sign_of(all.values[i]));
    if (signs.mixed() || signs.zero == all.count) return {};
  }
  Crossing crossing;
  crossing.hit = true;
  crossing.place = signs.zero == 0   ? HitPlace::kInside
                   : signs.zero == 1 ? HitPlace::kEdge
                                     : HitPlace::kVertex;
  const Quotient<Interval> t = t_of<Interval>(line, shape);
  const Interval value = t.numerator / t.denominator;
  crossing.t_low = value.inf();
  crossing.t_high = value.sup();
  return crossing;
}

int compare_t(const Line& line, const FlatShape& shape, double value) {
  const Quotient<Exact> t = t_of<Exact>(line, shape);
  return sign_of(t.numerator - Exact(value) * t.denominator) * sign_of(t.denominator);
}

int compare_t(const Line& line, const FlatShape& a, const FlatShape& b) {
  const Quotient<Exact> first = t_of<Exact>(line, a);
  const Quotient<Exact> second = t_of<Exact>(line, b);
  return sign_of(first.numerator * second.denominator - second.numerator * first.denominator) *
         sign_of(first.denominator) * sign_of(second.denominator);
}

std::optional<PlaneValues> plane_values(const Line& line, const FlatShape& shape) {
  if (const auto values = quick_values(line, shape)) return values;
  const Quotient<Exact> t = t_of<Exact>(line, shape);
  if (sign_of(t.denominator) == 0) return std::nullopt;
  const Bounds<Exact> bounds = bounds_of<Exact>(line, shape);
  return PlaneValues{CGAL::to_double(Exact(t.numerator / t.denominator)),
                     CGAL::to_double(Exact(bounds.values[0] / t.denominator)),
                     CGAL::to_double(Exact(bounds.values[1] / t.denominator))};
}

}  // namespace dynrt::host
