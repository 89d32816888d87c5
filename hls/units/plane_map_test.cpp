// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The watertight test of rays with a common origin, function by function.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "units/plane_hit.h"
#include "units/test_bench.h"

namespace dynrt {
namespace {

using Vec = Vector<Real>;
using Block = BlockVector<Real>;
using Corner = PlaneCorner<Real>;

constexpr int kUnits = static_cast<int>(Real::kMantissaBits + kGuardBits);

Real real(double value) { return Real::from_double(value); }
Vec vec(double x, double y, double z) { return {real(x), real(y), real(z)}; }
std::array<double, 3> numbers(const Vec& v) {
  return {v.x.to_double(), v.y.to_double(), v.z.to_double()};
}
std::array<double, 3> numbers(const Block& b) {
  const int exponent = static_cast<int>(b.exponent.raw()) - Real::kBias - kUnits;
  const auto number = [exponent](auto component) {
    return std::ldexp(static_cast<double>(component.to_s64()), exponent);
  };
  return {number(b.x), number(b.y), number(b.z)};
}
/// Where a corner lies in the plane, in the world's units.
std::array<double, 2> place(const Corner& c) {
  const int exponent =
      static_cast<int>(c.exponent.raw()) + static_cast<int>(c.shift.raw()) - Real::kBias - kUnits;
  return {std::ldexp(static_cast<double>(c.x.to_s64()), exponent),
          std::ldexp(static_cast<double>(c.y.to_s64()), exponent)};
}
double largest(const std::array<double, 3>& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}
/// Within some powers of two of each other, so that all three matter.
Vec some_vector(test::Random& random) {
  const int scale = static_cast<int>(test::below(random, 40)) - 20;
  const auto part = [&] {
    const double of =
        (static_cast<double>(test::below(random, 1u << 18)) - (1 << 17) + 0.5) / (1 << 17);
    return std::ldexp(of, scale - static_cast<int>(test::below(random, 3)));
  };
  return vec(part(), part(), part());
}
PlaneMap<Real> map_of(const Vec& d) {
  return plane_map(d, Vec{Real::one() / d.x, Real::one() / d.y, Real::one() / d.z});
}

TEST(BlockVector, IsOffByLessThanItsUnit) {
  test::Random random(3);
  for (unsigned n = 0; n < 100'000; ++n) {
    const Vec v = test::chance(random, 50) ? test::random_token<Vec>(random) : some_vector(random);
    const auto exact = numbers(v);
    const auto block = numbers(block_vector(v));
    const double unit = std::ldexp(largest(exact), -kUnits);
    for (unsigned i = 0; i < 3; ++i) {
      ASSERT_LT(std::abs(exact[i] - block[i]), unit);
      ASSERT_LE(std::abs(block[i]), std::abs(exact[i])) << "cut off towards zero";
    }
  }
}

TEST(BlockVector, FitsAColumn) {
  test::Random random(4);
  for (unsigned n = 0; n < 10'000; ++n) {
    const Block block = block_vector(test::random_token<Vec>(random));
    ASSERT_TRUE(test::same(block_of(as_column(block)), block));
  }
}

TEST(PlaneMap, TheLongestComponentBecomesTheThirdAxis) {
  const auto x = map_of(vec(-8, 2, 4));
  EXPECT_EQ(x.axis, uint<2>(0));
  EXPECT_EQ(x.x.to_s64(), 1 << 15) << "a quarter";
  EXPECT_EQ(x.y.to_s64(), 1 << 16);
  EXPECT_EQ(x.per_height, real(-0.125));
  const auto y = map_of(vec(2, 4, -1));
  EXPECT_EQ(y.axis, uint<2>(1));
  EXPECT_EQ(y.x.to_s64(), 1 << 15);
  EXPECT_EQ(y.y.to_s64(), -(1 << 16));
  EXPECT_EQ(map_of(vec(2, -4, 8)).axis, uint<2>(2));
  EXPECT_EQ(map_of(vec(-4, 4, 4)).axis, uint<2>(0)) << "of equals the first";
  EXPECT_EQ(map_of(vec(1, 4, -4)).axis, uint<2>(1));
  EXPECT_EQ(map_of(vec(-4, 4, 4)).x.to_s64(), (1 << 17) - 1) << "a slope stays below one";
}

/// Roundings, half a step of the mantissa at its beginning, of the corner's largest component.
TEST(PlaneMap, ACornerIsOffByTwelveRoundingsAtMost) {
  test::Random random(5);
  double most = 0;
  for (unsigned n = 0; n < 300'000; ++n) {
    const Vec direction = some_vector(random);
    const auto map = map_of(direction);
    Vec corner = some_vector(random);
    if (test::chance(random, 30)) {  // near the ray
      const double t = std::ldexp(1.0, static_cast<int>(test::below(random, 9)) - 4);
      const auto d = numbers(direction);
      const double off = std::ldexp(largest(d), -static_cast<int>(test::below(random, 17)));
      corner = vec(t * (d[0] + off), t * d[1], t * (d[2] - 0.5 * off));
    }
    const auto e = numbers(along(map.axis, corner));
    const auto d = numbers(along(map.axis, direction));
    const auto at = place(map_corner(map, block_vector(corner)));
    const double rounding = std::ldexp(largest(e), -static_cast<int>(Real::kMantissaBits) - 1);
    for (unsigned i = 0; i < 2; ++i) {
      most = std::max(most, std::abs(e[i] - d[i] / d[2] * e[2] - at[i]) / rounding);
    }
  }
  EXPECT_LT(most, 12);
  EXPECT_GT(most, 4) << "the bound is not ten times too wide";
}

Coordinate<Real> coordinate(int value) {
  return Coordinate<Real>::of_raw(static_cast<Coordinate<Real>::Raw>(value));
}
Corner corner(int x, int y, int z = 4) {
  return {coordinate(x), coordinate(y), coordinate(z), uint<7>(63), {}};
}
int sign_of(const PlaneEdge<Real>& edge) {
  EXPECT_FALSE(edge.left && edge.right);
  return edge.left ? 1 : edge.right ? -1 : 0;
}

TEST(PlaneEdge, IsDecidedByTheExactProducts) {
  EXPECT_EQ(sign_of(edge_of(corner(1, 0), corner(1, 1))), 1);
  EXPECT_EQ(sign_of(edge_of(corner(1, 1), corner(1, 0))), -1);
  EXPECT_EQ(sign_of(edge_of(corner(65537, 65536), corner(65535, 65534))), -1);
  EXPECT_EQ(edge_of(corner(65535, 65534), corner(65537, 65536)).area.raw(), 2u);
  EXPECT_EQ(edge_of(corner(65537, 65536), corner(65535, 65534)).area.raw(), 1u) << "less one";
  const auto widest = edge_of(corner(-131071, -131072), corner(131071, -131072));
  EXPECT_EQ(sign_of(widest), 1);
  EXPECT_EQ(widest.area.to_u64(), 2ull * 131071 * 131072);
}

TEST(PlaneEdge, ThroughTheAxisIsMovedAside) {
  EXPECT_EQ(sign_of(edge_of(corner(1, -2), corner(-1, 2))), 1);
  EXPECT_EQ(sign_of(edge_of(corner(-1, 2), corner(1, -2))), -1);
  EXPECT_EQ(sign_of(edge_of(corner(3, 6), corner(1, 2))), 0) << "in one direction";
}

TEST(PlaneEdge, TheOtherWayRoundHasTheOtherSide) {
  test::Random random(17);
  const auto number = [&] { return static_cast<int>(test::below(random, 1u << 18)) - (1 << 17); };
  for (unsigned n = 0; n < 200'000; ++n) {
    Corner p = corner(number() | 1, number());
    Corner q = corner(number() | 1, number());
    if (test::chance(random, 20)) q.y = p.y;
    if (test::chance(random, 20) && p.x.to_s64() > -131072 && p.y.to_s64() > -131072) {
      q = corner(static_cast<int>(-p.x.to_s64()), static_cast<int>(-p.y.to_s64()));
    }
    const auto there = edge_of(p, q);
    const auto back = edge_of(q, p);
    ASSERT_EQ(sign_of(there), -sign_of(back));
    const auto cross = p.x.to_s64() * q.y.to_s64() - p.y.to_s64() * q.x.to_s64();
    ASSERT_EQ(there.area.to_u64(), static_cast<std::uint64_t>(cross < 0 ? -cross - 1 : cross));
    ASSERT_EQ(sign_of(there) == 0, cross == 0 && p.x.negative() == q.x.negative());
  }
}

/// A closed mesh of any shape is made of tetrahedra whose common faces cancel, so this is the claim
/// that no ray is lost or hit twice: all corners of a format of two mantissa bits.
TEST(PlaneEdge, EveryTetrahedronIsCrossedAsOftenInwardsAsOutwards) {
  using Tiny = hls::Float<4, 2>;
  std::vector<PlaneCorner<Tiny>> points;
  for (int x = -7; x <= 7; x += 2) {
    for (int y = -8; y <= 7; ++y) {
      PlaneCorner<Tiny> point;
      point.x = Coordinate<Tiny>::of_raw(static_cast<Coordinate<Tiny>::Raw>(x));
      point.y = Coordinate<Tiny>::of_raw(static_cast<Coordinate<Tiny>::Raw>(y));
      points.push_back(point);
    }
  }
  const std::size_t count = points.size();
  std::vector<signed char> sides(count * count);  // 1: left, -1: right
  for (std::size_t p = 0; p < count; ++p) {
    for (std::size_t q = 0; q < count; ++q) {
      const auto edge = edge_of(points[p], points[q]);
      sides[p * count + q] = static_cast<signed char>(edge.left - edge.right);
    }
  }
  // 1: all edges are passed on their left, -1: all on their right.
  std::vector<signed char> turns(count * count * count);
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) -> signed char& {
    return turns[(a * count + b) * count + c];
  };
  unsigned met = 0;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) {
      for (std::size_t c = 0; c < count; ++c) {
        const int sum = sides[a * count + b] + sides[b * count + c] + sides[c * count + a];
        turn(a, b, c) = static_cast<signed char>(sum / 3);
        met += sum == 3;
      }
    }
  }
  EXPECT_GT(met, 100'000u);
  std::uint64_t open = 0;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a; b < count; ++b) {
      for (std::size_t c = b; c < count; ++c) {
        for (std::size_t d = c; d < count; ++d) {
          open += turn(a, b, c) + turn(a, c, d) + turn(a, d, b) + turn(b, d, c) != 0;
        }
      }
    }
  }
  EXPECT_EQ(open, 0u);
}

TriangleHit<Real> met(const Corner& a, const Corner& b, const Corner& c, Real per_height) {
  PlaneTriangle<Real> triangle = plane_triangle(a, b, c);
  triangle.per_height = per_height;
  return intersect(triangle);
}

TEST(PlaneIntersect, ReportsThePartsOfTheFirstTwoCorners) {
  // Weights of 1/4, 1/4 and 1/2.
  const int one = 1 << 14;
  const Corner a = corner(3 * one - 1, -one, 4 << 13);
  const Corner b = corner(-one - 1, 3 * one, 8 << 13);
  const Corner c = corner(-one + 1, -one, 2 << 13);
  const auto hit = met(a, b, c, real(0.5));
  EXPECT_TRUE(hit.hit());
  EXPECT_TRUE(hit.left);
  EXPECT_NEAR(hit.u.to_double(), 0.25, 0x1p-13);
  EXPECT_NEAR(hit.v.to_double(), 0.25, 0x1p-13);
  EXPECT_NEAR(hit.t.to_double(), 0.5 * (0.125 + 0.25 + 0.125), 0x1p-12);
  const auto other = met(b, a, c, real(0.5));
  EXPECT_TRUE(other.right);
  EXPECT_NEAR(other.t.to_double(), hit.t.to_double(), 0x1p-15);
  EXPECT_NEAR(other.u.to_double(), hit.v.to_double(), 0x1p-15);
  EXPECT_FALSE(met(a, b, c, real(-0.5)).hit()) << "behind the ray's origin";
  EXPECT_FALSE(met(a, b, a, real(1)).hit()) << "an edge alone";
}

/// The distance and the weights, against doubles, of triangles in front of a ray.
TEST(PlaneIntersect, FindsTheHitOfDoubles) {
  test::Random random(23);
  double most_t = 0, most_u = 0;
  unsigned hits = 0;
  for (unsigned n = 0; n < 200'000; ++n) {
    const Vec direction = some_vector(random);
    const auto d = numbers(direction);
    const auto part = [&] {
      return (static_cast<double>(test::below(random, 4097)) - 2048) / 2048;
    };
    std::array<Vec, 3> corners;
    for (Vec& corner : corners) {
      const double t = 1 + 0.3 * part(), size = largest(d);
      corner = vec(t * d[0] + size * part(), t * d[1] + size * part(), t * d[2] + size * part());
    }
    const auto map = map_of(direction);
    const auto mapped = [&](unsigned i) { return map_corner(map, block_vector(corners[i])); };
    const auto hit = met(mapped(0), mapped(1), mapped(2), map.per_height);
    if (!hit.hit()) continue;
    ++hits;
    std::array<std::array<double, 3>, 3> e;
    const auto turned_d = numbers(along(map.axis, direction));
    for (unsigned i = 0; i < 3; ++i) {
      e[i] = numbers(along(map.axis, corners[i]));
      for (unsigned k = 0; k < 2; ++k) e[i][k] -= turned_d[k] / turned_d[2] * e[i][2];
      e[i][2] /= turned_d[2];
    }
    const auto cross = [](const auto& p, const auto& q) { return p[0] * q[1] - p[1] * q[0]; };
    const double a = cross(e[1], e[2]), b = cross(e[2], e[0]), c = cross(e[0], e[1]);
    const double all = a + b + c;
    if (std::abs(all) < 0.05 * largest(d) * largest(d)) continue;  // seen from its side
    most_t = std::max(
        most_t, std::abs((a * e[0][2] + b * e[1][2] + c * e[2][2]) / all - hit.t.to_double()));
    most_u = std::max(most_u, std::abs(a / all - hit.u.to_double()));
  }
  EXPECT_GT(hits, 5'000u);
  EXPECT_LT(most_t, 0x1p-9);
  EXPECT_LT(most_u, 0x1p-9);
}

/// A fan of triangles round a point at the axis, closed: exactly one of them is hit, wherever
/// the point may lie and however far away.
TEST(PlaneIntersect, OneTriangleOfAFanIsHit) {
  test::Random random(71);
  constexpr unsigned kAround = 7;
  for (unsigned n = 0; n < 100'000; ++n) {
    const auto part = [&] {
      return (static_cast<double>(test::below(random, 2049)) - 1024) / 1024;
    };
    const Vec direction = some_vector(random);
    const auto d = numbers(direction);
    const auto map = map_of(direction);
    const double scale = std::ldexp(largest(d), -static_cast<int>(test::below(random, 10)));
    const auto at = [&](double x, double y) {
      // Beside the ray, in the two directions that are not its longest.
      std::array<double, 3> v = d;
      v[(map.axis.raw() + 1) % 3] += x;
      v[(map.axis.raw() + 2) % 3] += y;
      return map_corner(map, block_vector(vec(v[0], v[1], v[2])));
    };
    std::array<Corner, kAround> rim;
    for (unsigned i = 0; i < kAround; ++i) {
      const double angle = (i + 0.3 * part()) * 2 * 3.14159265358979 / kAround;
      rim[i] = at(scale * std::cos(angle), scale * std::sin(angle));
    }
    const double off = test::chance(random, 50) ? 0 : test::chance(random, 50) ? 0.1 : 0x1p-12;
    const Corner middle = at(off * scale * part(), off * scale * part());
    unsigned hits = 0;
    for (unsigned i = 0; i < kAround; ++i) {
      hits += met(middle, rim[i], rim[(i + 1) % kAround], map.per_height).hit();
    }
    ASSERT_EQ(hits, 1u);
  }
}

}  // namespace
}  // namespace dynrt
