// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// No ray from inside a closed mesh gets out: whole frames of the watertight cores, many of whose
// pixels lie on corners and edges exactly. The environment variable DYNRT_RAYS sets the number of
// rays of the slow test (default: millions), and DYNRT_SEED its seed.
// docs/explanation/watertight.md has the proof.
#include "configs/watertight.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>
#include <vector>

#include "configs/fast_watertight.h"
#include "core/closed_meshes.h"
#include "core/random_places.h"
#include "host/board/configurations.h"
#include "host/layout/lay_out.h"
#include "host/render/render.h"

namespace dynrt::host {
namespace {

static_assert(config::watertight::Real::kMantissaBits ==
              config::fast_watertight::Real::kMantissaBits);

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
        expected.t += static_cast<std::uint32_t>(exponent)
                      << config::watertight::Real::kMantissaBits;
        ASSERT_TRUE(expected.hit);
        ASSERT_EQ(found[i], expected) << "by 2^" << exponent << ", pixel " << i;
      }
    }
  }
}

}  // namespace
}  // namespace dynrt::host
