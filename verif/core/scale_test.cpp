// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// There is no absolute epsilon anywhere: a scene scaled by a power of two that stays in the range
// of the core's numbers gives the same hits bit for bit, distances scaled. That holds for the core
// with scaled data in its memory, and for the program, which gives every scene the same place and
// scale: so a scene may be scaled and moved freely.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/scenes.h"
#include "host/board/configurations.h"
#include "host/render/render.h"
#include "host/scene/load.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host {
namespace {

using testing::add_sphere;
using testing::camera_at;
using testing::scene_of;

constexpr unsigned kWidth = 48, kHeight = 36;

std::unique_ptr<Board> model(const char* configuration) {
  return make_board(configurations(), {"model", configuration, ""});
}

MemoryImage prepare(Scene scene, const Camera& camera, const Board& board) {
  return lay_out(std::move(scene), {camera, kWidth, kHeight}, board.core());
}

/// The scene in the core's space with everything that is a length times a factor.
MemoryImage scaled_image(const MemoryImage& plain, double factor) {
  Scene scene = plain.scene;
  for (Mesh& mesh : scene.objects) {
    for (glm::dvec3& vertex : mesh.vertices) vertex *= factor;
  }
  for (Instance& instance : scene.instances) {
    for (int axis = 0; axis < 3; ++axis) instance.transform[3][axis] *= factor;
  }
  View view = plain.view;
  view.camera.position *= factor;
  return lay_out(std::move(scene), view, plain.core(), {.fit = false});
}

Frame frame(Board& board, const MemoryImage& p) {
  FrameOptions options;
  options.width = kWidth;
  options.height = kHeight;
  return render(board, options, p);
}

class Scale : public ::testing::TestWithParam<std::tuple<std::string, int>> {};

TEST_P(Scale, TheHitsAreTheSame) {
  const auto& [name, exponent] = GetParam();
  const auto board = model("thesis");
  const MemoryImage image = laid_out(name, kWidth, kHeight, board->core());
  const std::vector<HitRecord> plain = frame(*board, image).hits;
  const std::vector<HitRecord> scaled =
      frame(*board, scaled_image(image, std::exp2(exponent))).hits;
  ASSERT_EQ(plain.size(), scaled.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    HitRecord expected = plain[i];
    if (expected.hit) {
      ++count;
      expected.t += static_cast<std::uint32_t>(exponent) << kShippedFormat.mantissa_bits;
    }
    ASSERT_EQ(scaled[i], expected) << "pixel " << i % kWidth << ", " << i / kWidth;
  }
  EXPECT_GT(count, plain.size() / 3);
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<std::string, int>>& info) {
  const auto& [name, exponent] = info.param;
  return name + (exponent < 0 ? "_down_" : "_up_") + std::to_string(std::abs(exponent));
}

INSTANTIATE_TEST_SUITE_P(TwoLevels, Scale,
                         ::testing::Combine(::testing::Values("blocks"),
                                            ::testing::Values(-20, -7, 1, 10, 20)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(ManyTriangles, Scale,
                         ::testing::Combine(::testing::Values("office"),
                                            ::testing::Values(-20, 20)),
                         name_of);

/// As a file has it that is written in another unit of length, about another place.
Scene elsewhere(Scene scene, double factor, const glm::dvec3& to) {
  for (Mesh& mesh : scene.objects) {
    for (glm::dvec3& vertex : mesh.vertices) vertex *= factor;
  }
  for (Instance& instance : scene.instances) {
    const glm::dvec3 place = factor * glm::dvec3(instance.transform[3]) + to;
    instance.transform[3] = glm::dvec4(place, 1.0);
  }
  for (PointLight& light : scene.lights) {
    light.position = factor * light.position + to;
    light.colour *= factor;
  }
  if (scene.camera) scene.camera->position = factor * scene.camera->position + to;
  return scene;
}
Camera elsewhere(Camera camera, double factor, const glm::dvec3& to) {
  camera.position = factor * camera.position + to;
  return camera;
}

/// Renders both and expects every bit to be the same.
void expect_same_frame(Board& board, const MemoryImage& one, const MemoryImage& other) {
  const Frame left = frame(board, one);
  const Frame right = frame(board, other);
  EXPECT_GT(left.hit_count(), left.hits.size() / 20);
  EXPECT_EQ(left.hits, right.hits);
  EXPECT_EQ(left.pixels, right.pixels);
}

class Program : public ::testing::TestWithParam<int> {};

TEST_P(Program, AFileInOtherUnitsIsTheSamePicture) {
  const double factor = std::exp2(GetParam());
  for (const auto& [name, configuration] :
       {std::pair{"blocks", "thesis"}, std::pair{"lamps", "whitted"}}) {
    const Scene scene = load_scene(name);
    const Camera camera = choose_camera(scene, {}, kWidth, kHeight);
    const auto board = model(configuration);
    const MemoryImage plain = prepare(scene, camera, *board);
    const MemoryImage scaled =
        prepare(elsewhere(scene, factor, {}), elsewhere(camera, factor, {}), *board);
    EXPECT_EQ(scaled.space.unit, factor * plain.space.unit);
    EXPECT_EQ(scaled.headroom.up, plain.headroom.up);
    EXPECT_EQ(scaled.headroom.down, plain.headroom.down);
    SCOPED_TRACE(name);
    expect_same_frame(*board, plain, scaled);
  }
}
INSTANTIATE_TEST_SUITE_P(Units, Program, ::testing::Values(-60, -20, -7, 1, 20, 60));

/// A ball of vertices with few digits, so that its move is exact.
Scene ball_at(const glm::dvec3& centre) {
  Mesh mesh{.name = "ball", .vertices = {}, .triangles = {}, .material = {}};
  add_sphere(mesh, {0, 0, 0}, 1, 12);
  for (glm::dvec3& v : mesh.vertices) v = glm::round(v * 0x1p20) / 0x1p20 + centre;
  return scene_of(std::move(mesh));
}

TEST(Place, ASceneFarAwayIsThePictureOfTheOneAtTheOrigin) {
  const glm::dvec3 far(148376, 1234, -223423);
  const Camera camera = camera_at({0.25, 0.5, 4}, {0, 0, -1});
  const auto board = model("thesis");
  const MemoryImage at_origin = prepare(ball_at({}), camera, *board);
  const Camera there = elsewhere(camera, 1, far);
  expect_same_frame(*board, at_origin, prepare(ball_at(far), there, *board));
  expect_same_frame(*board, at_origin, prepare(elsewhere(ball_at({}), 1, far), there, *board));
}

}  // namespace
}  // namespace dynrt::host
