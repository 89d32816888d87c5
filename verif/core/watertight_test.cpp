// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// No ray from inside a closed mesh gets out, and none is hit twice where triangles meet: whole
// frames of the watertight cores, many of whose pixels lie on corners and edges exactly, and rays
// that are tested with all triangles of a mesh by the units' code. The environment variable
// DYNRT_RAYS sets the number of rays of the slow tests (default: millions), and DYNRT_SEED their
// seed. docs/explanation/watertight.md has the proof.
#include "configs/watertight.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>
#include <vector>

#include "configs/fast_watertight.h"
#include "core/closed_meshes.h"
#include "hls/random.h"
#include "host/board/configurations.h"
#include "host/layout/lay_out.h"
#include "host/render/render.h"
#include "units/test_bench.h"
#include "units/transformation.h"

namespace dynrt::host {
namespace {

using hls::testing::Random;
using Real = config::watertight::Real;
static_assert(std::is_same_v<Real, config::fast_watertight::Real>);

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* wanted = std::getenv(name);
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : otherwise;
}
std::uint64_t rays_wanted(std::uint64_t otherwise) {
  return from_environment("DYNRT_RAYS", otherwise);
}
/// Of the slow tests, which several processes may share.
std::uint64_t slow_seed() { return from_environment("DYNRT_SEED", 100'000); }

double unit(Random& random) { return static_cast<double>(random.below(1u << 30)) * 0x1p-29 - 1; }
glm::dvec3 in_ball(Random& random) {
  for (;;) {
    const glm::dvec3 v(unit(random), unit(random), unit(random));
    if (glm::dot(v, v) < 1) return v;
  }
}

struct ClosedMesh {
  Mesh mesh;
  double
      inside;  ///< radius of a ball about the origin that lies within, well away from the surface
  int cells = 0;  ///< of a lattice: directions of whole coordinates up to half of them are aimed at
};

std::vector<ClosedMesh> closed_meshes() {
  return {{make_sphere(1, 0, 0), 0.5}, {make_sphere(1, 2, 0), 0.9}, {make_sphere(1, 4, 0), 0.95},
          {make_cube(2), 0.9, 2},      {make_cube(16), 0.95, 16},   {make_crumpled(8), 0.3, 8},
          {make_crumpled(32), 0.3, 32}};
}

/// Where a mesh lies in its object, and the object in the world.
struct Place {
  glm::dvec3 shift{0.0};  ///< of the mesh's corners, in radii
  double scale = 1;       ///< of the corners, shift and all: a power of two
  glm::dmat4 instance{1.0};
  std::vector<glm::dvec3> others{};  ///< further instances: where their middles are, in radii
};

/// Shifts by none to 4096 radii and scales of 2^-20 to 2^20; every second one in an instance that
/// is turned, scaled unevenly and mirrored, and every second one among twenty others, which may
/// reach into it.
Place any_place(Random& random) {
  static constexpr double kShifts[] = {0, 0, 16, 256, 4096};
  Place place;
  place.shift = kShifts[random.below(std::size(kShifts))] * in_ball(random);
  place.scale = std::exp2(static_cast<int>(random.below(41)) - 20);
  if (random.below(2) == 0) {
    const double size = std::exp2(3 * unit(random));
    glm::dmat4 m(1.0);
    m = glm::rotate(m, 3.2 * unit(random), in_ball(random));
    m = glm::scale(m, size * glm::dvec3(1, -0.5 - 0.25 * unit(random), 1.5));
    place.instance = glm::rotate(m, 3.2 * unit(random), in_ball(random));
  }
  if (random.below(2) == 0) {
    for (unsigned i = 0; i < 20; ++i) place.others.push_back(6.0 * in_ball(random));
  }
  return place;
}

/// How far rounding moves the corners and the eye, in radii.
double blur(const Place& place) { return 2 * glm::length(place.shift) * 0x1p-16; }

class Laid {
 public:
  Laid(const ClosedMesh& closed, const Place& place, const CoreInfo& core)
      : place_(place),
        p_(lay_out(scene_of(closed, place), {.camera = {.position = world(glm::dvec3(0.0))}}, core,
                   {.fit = false})) {}

  glm::dvec3 world(const glm::dvec3& in_mesh) const {
    return place_.instance * glm::dvec4(place_.scale * (in_mesh + place_.shift), 1.0);
  }
  glm::dvec3 world_direction(const glm::dvec3& in_mesh) const {
    return place_.instance * glm::dvec4(place_.scale * in_mesh, 0.0);
  }

  std::vector<HitRecord> hits(Board& board, const Camera& camera, unsigned width, unsigned height) {
    p_.view = {camera, width, height};
    p_.frame = frame_of(p_, p_.trees.instances, camera);
    FrameOptions options;
    options.width = width;
    options.height = height;
    return render(board, options, p_).hits;
  }
  /// Rays without a hit, of a frame that the camera sees.
  std::uint64_t missed(Board& board, const Camera& camera, unsigned width, unsigned height,
                       std::string& first) {
    const std::vector<HitRecord> found = hits(board, camera, width, height);
    std::uint64_t missed = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].hit) continue;
      if (missed++ == 0) first = fmt::format("pixel {}, {}", i % width, i / width);
    }
    return missed;
  }

 private:
  static Scene scene_of(const ClosedMesh& closed, const Place& place) {
    Mesh mesh = closed.mesh;
    for (glm::dvec3& v : mesh.vertices) v = place.scale * (v + place.shift);
    Scene scene;
    scene.name = "closed";
    scene.materials = {{"grey"}};
    scene.objects = {std::move(mesh)};
    scene.instances = {{"closed", 0, place.instance}};
    for (const glm::dvec3& middle : place.others) {
      scene.instances.push_back(
          {"other", 0, place.instance * glm::translate(glm::dmat4(1.0), place.scale * middle)});
    }
    return scene;
  }

  Place place_;
  MemoryImage p_;
};

/// Sees a random way from a place in the mesh.
Camera any_camera(const Laid& laid, const glm::dvec3& eye, Random& random) {
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 3.2 * unit(random), in_ball(random));
  const double wide = std::exp2(2 * unit(random));
  const auto direction = [&](double x, double y, double z) {
    return laid.world_direction(glm::dvec3(turn * glm::dvec4(x, y, z, 0.0)));
  };
  return {laid.world(eye), direction(wide, 0, 0), direction(0, wide, 0), direction(0, 0, -1)};
}

/// From the middle of a lattice to one of its faces, such that pixel (x, y) sees along whole
/// coordinates, half a cell apart: at corners, at edges and at the middles of both.
Camera aimed_camera(const Laid& laid, int cells, unsigned face) {
  const double step = 0.5, half = cells / 2.0;
  const double side = face % 2 == 0 ? half : -half;
  const auto direction = [&](double a, double b, double c) {
    glm::dvec3 d;
    d[face / 2] = c;
    d[(face / 2 + 1) % 3] = a;
    d[(face / 2 + 2) % 3] = b;
    return laid.world_direction(d);
  };
  const double width = 2 * cells + 1;
  return {laid.world(glm::dvec3(0.0)), direction(width * step, 0, 0), direction(0, width * step, 0),
          direction(0, 0, side)};
}

/// Renders frames until this many rays are traced; returns the number of rays that get out.
class Frames {
 public:
  explicit Frames(const std::string& configuration)
      : board_(make_board(configurations(), {"model", configuration, ""})) {}

  void run(std::uint64_t rays, unsigned width, unsigned height, std::uint64_t seed) {
    const std::vector<ClosedMesh> meshes = closed_meshes();
    for (std::uint64_t n = 0; traced_ < rays; ++n) {
      Random random(seed + n);
      const ClosedMesh& closed = meshes[n % meshes.size()];
      const Place place = any_place(random);
      SCOPED_TRACE(fmt::format(
          "mesh {}, shift {:.3g} {:.3g} {:.3g}, scale {:g}, {} others, seed {}", n % meshes.size(),
          place.shift.x, place.shift.y, place.shift.z, place.scale, place.others.size(), seed + n));
      Laid laid(closed, place, board_->core());
      const double room = std::max(0.0, closed.inside - blur(place));
      for (unsigned i = 0; i < 4; ++i) {
        const glm::dvec3 eye = i == 0 ? glm::dvec3(0.0) : room * in_ball(random);
        trace(laid, any_camera(laid, eye, random), width, height);
      }
      if (closed.cells == 0) continue;
      for (unsigned face = 0; face < 6; ++face) {
        const auto side = static_cast<unsigned>(2 * closed.cells + 1);
        trace(laid, aimed_camera(laid, closed.cells, face), side, side);
      }
    }
    fmt::print("{} rays from inside closed meshes, {} missed\n", traced_, missed_);
  }

 private:
  void trace(Laid& laid, const Camera& camera, unsigned width, unsigned height) {
    std::string first;
    const std::uint64_t missed = laid.missed(*board_, camera, width, height, first);
    EXPECT_EQ(missed, 0u) << first;
    missed_ += missed;
    traced_ += std::uint64_t{width} * height;
  }

  std::unique_ptr<Board> board_;
  std::uint64_t traced_ = 0, missed_ = 0;
};

class Watertight : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (std::ranges::find(configurations(), GetParam(), &Configuration::name) ==
        configurations().end()) {
      GTEST_SKIP() << "this build has no configuration " << GetParam();
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Configurations, Watertight,
                         testing::Values("watertight", "fast_watertight"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(Watertight, NoRayGetsOutOfAClosedMesh) { Frames(GetParam()).run(60'000, 32, 24, 1); }
TEST_P(Watertight, SlowNoRayGetsOutOfAClosedMesh) {
  Frames(GetParam()).run(rays_wanted(20'000'000), 1024, 341, slow_seed());
}

/// There is no absolute epsilon: a mesh scaled by a power of two has the same hits bit for bit.
TEST_P(Watertight, AScaledMeshHasTheSameHits) {
  constexpr unsigned kWidth = 48, kHeight = 32;
  const auto board = make_board(configurations(), {"model", GetParam(), ""});
  for (const ClosedMesh& closed : {closed_meshes()[1], closed_meshes()[5]}) {
    const Camera camera{
        glm::dvec3(0.125, -0.0625, 0.25), {1.5, 0.1, 0.2}, {0, 1.5, 0.3}, {0.3, 0.2, -1}};
    const auto plain = Laid(closed, {}, board->core()).hits(*board, camera, kWidth, kHeight);
    for (const int exponent : {-20, -9, 1, 20}) {
      Camera scaled = camera;
      scaled.position *= std::exp2(exponent);
      Laid laid(closed, {.scale = std::exp2(exponent)}, board->core());
      const auto found = laid.hits(*board, scaled, kWidth, kHeight);
      ASSERT_EQ(found.size(), plain.size());
      for (std::size_t i = 0; i < plain.size(); ++i) {
        HitRecord expected = plain[i];
        expected.t += static_cast<std::uint32_t>(exponent) << Real::kMantissaBits;
        ASSERT_TRUE(expected.hit);
        ASSERT_EQ(found[i], expected) << "by 2^" << exponent << ", pixel " << i;
      }
    }
  }
}

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
