// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Decisions about a line and flat primitives, without rounding. With A, B, C the corners less the
// line's origin and D its direction, the edge functions are
//   e_a = D . (B x C),  e_b = D . (C x A),  e_c = D . (A x B),  e_a + e_b + e_c = D . N,
// N being the normal (a - c) x (b - c), and the plane is met at t = N . C / (N . D), where
// u = e_a / (N . D) and v = e_b / (N . D). Each is a polynomial of degree three or less in the
// doubles given, so its sign is decided by CGAL's interval arithmetic or, where an interval holds
// zero, by CGAL's exact numbers. Nothing here rounds but the values that are asked for.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "host/analysis/truth/truth.h"

namespace dynrt::host {

struct Line {
  glm::dvec3 origin, direction;
};

/// The corners a, b, c. A rectangle goes from c along a - c and b - c.
struct FlatShape {
  std::array<glm::dvec3, 3> corners;
  bool rectangle = false;
};

/// The meeting of a line and a closed flat primitive. Without a hit only `hit` has a meaning.
struct Crossing {
  bool hit = false;
  HitPlace place = HitPlace::kInside;
  double t_low = 0, t_high = 0;  ///< t lies between
};

/// t to 1e-12 of itself, u and v to 1e-12, each rounded from the exact value where need be.
struct PlaneValues {
  double t, u, v;
};

/// `exact` counts the decisions for which intervals did not suffice.
Crossing cross(const Line& line, const FlatShape& shape, std::uint64_t& exact);

/// The sign of (t of the shape's plane - value), of planes that the line crosses.
int compare_t(const Line& line, const FlatShape& shape, double value);
/// The sign of (t of a's plane - t of b's).
int compare_t(const Line& line, const FlatShape& a, const FlatShape& b);

/// Nothing where the line is parallel to the plane.
std::optional<PlaneValues> plane_values(const Line& line, const FlatShape& shape);

}  // namespace dynrt::host
