// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A ray from inside a closed mesh crosses its surface once, and hits no triangle twice where
// triangles meet: rays that are tested with all triangles of a mesh by the units' code. The
// environment variable DYNRT_RAYS sets the number of rays of the slow test (default: a million),
// and DYNRT_SEED its seed. docs/explanation/watertight.md has the proof.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <vector>

#include "configs/fast_watertight.h"
#include "configs/watertight.h"
#include "core/closed_meshes.h"
#include "core/random_places.h"
#include "units/test_bench.h"
#include "units/transformation.h"

namespace dynrt::host {
namespace {

using Real = config::watertight::Real;
static_assert(std::is_same_v<Real, config::fast_watertight::Real>);

using Vec = Vector<Real>;
Vec rounded(const glm::dvec3& v) {
  return {Real::from_double(v.x), Real::from_double(v.y), Real::from_double(v.z)};
}
/// A mesh in the numbers of the core.
struct RoundedMesh {
  explicit RoundedMesh(const Mesh& mesh) : triangles(mesh.triangles) {
    for (const glm::dvec3& v : mesh.vertices) corners.push_back(rounded(v));
  }
  std::vector<glm::uvec3> triangles;
  std::vector<Vec> corners;
};

struct Crossings {
  int ahead = 0;   ///< triangles hit that turn one way, less those that turn the other
  int behind = 0;  ///< the same of the ray's line behind its origin
  unsigned hits = 0;

  template <class Hit>
  void count(const Hit& met) {
    const int turn = met.left - met.right;
    (met.t.sign() ? behind : ahead) += turn;
    hits += met.hit();
  }
};

/// One ray and all triangles of a mesh, by the code of the units.
class ByCorner {
 public:
  using C = config::watertight;
  Crossings cross(const RoundedMesh& mesh, const Ray<Real>& ray) {
    bench_.rows(bench_.unit.map)[0] = ray_map(ray);
    PacketVector<C> vector;
    vector.vector = ray.direction;
    vector.corner = Corner(0);
    std::vector<Vec> mapped;
    for (const Vec& corner : mesh.corners) {
      bench_.rows(bench_.unit.column[0])[0] = corner;
      bench_.feed(bench_.unit.vector, vector);
      bench_.run();
      mapped.push_back(bench_.take_one(bench_.unit.transformed).vector);
    }
    Crossings crossings;
    for (const glm::uvec3& t : mesh.triangles) {
      crossings.count(intersect(MappedTriangle<Real>{mapped[t.x], mapped[t.y], mapped[t.z], {}}));
    }
    return crossings;
  }

 private:
  test::UnitBench<Transformation<C>> bench_;
};

class ByTriangle {
 public:
  using C = config::fast_watertight;
  Crossings cross(const RoundedMesh& mesh, const Ray<Real>& ray) {
    const Vec& d = ray.direction;
    const PlaneMap<Real> map =
        plane_map(d, Vec{Real::one() / d.x, Real::one() / d.y, Real::one() / d.z});
    PacketVector<C> vector;
    vector.vector = d;
    vector.to_unit = true;
    std::vector<Vec> from_origin;
    for (const Vec& v : mesh.corners) {
      const Vec way{v.x - ray.origin.x, v.y - ray.origin.y, v.z - ray.origin.z};
      from_origin.push_back(as_column(block_vector(way)));
    }
    // A triangle for each packet.
    Crossings crossings;
    for (std::size_t first = 0; first < mesh.triangles.size(); first += C::kPackets) {
      const std::size_t count = std::min<std::size_t>(C::kPackets, mesh.triangles.size() - first);
      for (unsigned packet = 0; packet < count; ++packet) {
        const glm::uvec3& t = mesh.triangles[first + packet];
        for (int i = 0; i < 3; ++i) {
          bench_.rows(bench_.unit.column[i])[packet] = from_origin[t[i]];
        }
        vector.packet = PacketId<C>::from(packet);
        bench_.rows(bench_.unit.plane_map)[ray_row<C>(vector.packet, vector.ray).raw()] = map;
        bench_.feed(bench_.unit.vector, vector);
      }
      bench_.run();
      for (const UnitRay<C>& test : bench_.take(bench_.unit.in_plane)) {
        crossings.count(intersect(test.unit));
      }
    }
    return crossings;
  }

 private:
  test::UnitBench<Transformation<C>> bench_;
};

/// A direction: at a corner, an edge's middle, along an axis or plane, or anywhere.
Vec any_direction(const RoundedMesh& mesh, const glm::dvec3& origin, Random& random) {
  const auto at = [&](std::size_t corner) {
    const Vec& v = mesh.corners[corner];
    return glm::dvec3(v.x.to_double(), v.y.to_double(), v.z.to_double()) - origin;
  };
  const glm::uvec3 t = mesh.triangles[random.below(mesh.triangles.size())];
  glm::dvec3 d = in_ball(random);
  switch (random.below(6)) {
    case 0:
      d = at(t.x);
      break;
    case 1:
      d = 0.5 * (at(t.x) + at(t.y));
      break;
    case 2:
      d[static_cast<int>(random.below(3))] = 0;
      break;
    case 3:
      d = glm::dvec3(0.0);
      d[static_cast<int>(random.below(3))] = random.below(2) ? 1 : -1;
      break;
    case 4:  // nearly along an axis
      d = in_ball(random) * 1e-4;
      d[static_cast<int>(random.below(3))] = 1;
      break;
    default:
      break;
  }
  return rounded(std::exp2(20 * unit(random)) * d);
}

/// Rays from inside cross the surface once more outwards than inwards, ahead as behind; of a convex
/// mesh they hit one triangle.
template <class Mapping>
void count_crossings(std::uint64_t rays, std::uint64_t seed) {
  std::uint64_t traced = 0, none = 0, many = 0;
  Mapping mapping;
  for (std::uint64_t n = 0; traced < rays; ++n) {
    Random random(seed + n);
    const bool convex = n % 2 == 0;
    Mesh mesh = convex ? make_sphere(1, static_cast<int>(n / 2 % 3), 0) : make_crumpled(6);
    Place place = any_place(random);
    for (glm::dvec3& v : mesh.vertices) v = place.scale * (v + place.shift);
    const RoundedMesh all(mesh);
    for (unsigned i = 0; i < 200; ++i) {
      const double room = convex ? 0.5 : 0.3;
      const glm::dvec3 eye =
          place.scale * (std::max(0.0, room - blur(place)) * in_ball(random) + place.shift);
      const Vec origin = rounded(eye);
      const Vec direction = any_direction(all, eye, random);
      const Crossings crossings = mapping.cross(all, {origin, direction});
      ++traced;
      none += crossings.hits == 0;
      const bool once = std::abs(crossings.ahead) == 1 && crossings.ahead == -crossings.behind;
      // Where rounding has folded the surface, it is crossed there and back.
      const bool folded = !convex || glm::length(place.shift) > 100;
      many += !once || (!folded && crossings.hits != 1);
      ASSERT_TRUE(once) << "ahead " << crossings.ahead << ", behind " << crossings.behind
                        << ", seed " << seed + n << ", ray " << i;
      ASSERT_TRUE(folded || crossings.hits == 1)
          << crossings.hits << " hits, seed " << seed + n << ", ray " << i;
    }
  }
  fmt::print("{} rays against all triangles: {} without a hit, {} hit twice\n", traced, none, many);
}

template <class Mapping>
class WatertightUnits : public testing::Test {};
using Mappings = testing::Types<ByCorner, ByTriangle>;
TYPED_TEST_SUITE(WatertightUnits, Mappings);

TYPED_TEST(WatertightUnits, ARayCrossesASurfaceOnce) { count_crossings<TypeParam>(5'000, 1); }
TYPED_TEST(WatertightUnits, SlowARayCrossesASurfaceOnce) {
  count_crossings<TypeParam>(rays_wanted(1'000'000), slow_seed());
}

}  // namespace
}  // namespace dynrt::host
