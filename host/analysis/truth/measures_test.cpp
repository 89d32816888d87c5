// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Frames made from the truth and spoilt by hand: every measure must count what was spoilt.
#include "host/analysis/truth/measures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "host/format/memory_format_of.h"
#include "host/layout/test_scene.h"
#include "host/memory/matrix_numbers.h"
#include "host/scene/camera.h"
#include "host/tree/scene_trees.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host {
namespace {

using ::testing::HasSubstr;

constexpr unsigned kWidth = 32;
constexpr unsigned kHeight = 24;

std::uint32_t bits(double x) { return kShippedFormat.bits(x); }

/// A ball on a floor of two triangles, lit from above, with a mirror upright behind it.
Scene ball_on_floor() {
  Scene scene;
  scene.materials = {{"grey", glm::dvec3(0.8)}, {"mirror", glm::dvec3(0.2), 0.75}};
  Mesh ball;
  testing::add_sphere(ball, {0, 1, 0}, 1, 8);
  Mesh room;
  testing::add_quad(room, {-9, 0, -9}, {0, 0, 18}, {18, 0, 0});
  testing::add_quad(room, {-5, 0, -4}, {10, 0, 0}, {0, 6, 0});
  room.material = {0, 0, 1, 1};
  scene.objects = {ball, room};
  scene.instances = {{"ball", 0}, {"room", 1}};
  scene.lights = {{"lamp", {0.5, 7, 2}, glm::dvec3(6.0)}, {"second", {-6, 5, 3}, glm::dvec3(4.0)}};
  return scene;
}

class MeasuresTest : public ::testing::Test {
 protected:
  explicit MeasuresTest(bool eye_light = false) {
    shading_.width = kWidth;
    shading_.height = kHeight;
    shading_.eye_light = eye_light;
    shading_.mirrors = true;
    shading_.lights = 2;
    shading_.reflections = 1;
    shading_.ambient = 64;
    shading_.background = 0x402010;
    expected_ = truth_of_frame(truth_, camera_, shading_);
    frame_.width = kWidth;
    frame_.height = kHeight;
    frame_.pixels = expected_.pixels;
    for (const auto& hit : expected_.hits) frame_.hits.push_back(hit ? record(*hit) : HitRecord{});
  }

  HitRecord record(const TruthHit& hit) const {
    return {.hit = true,
            .object = image_.first_instance + 2 * hit.id.instance,
            .triangle = number(hit.id),
            .t = bits(hit.t),
            .u = bits(hit.u),
            .v = bits(hit.v),
            .cosine = bits(hit.cosine)};
  }
  std::uint32_t number(PrimitiveId id) const {
    const std::uint32_t object = scene_.instances[id.instance].object;
    return matrix_numbers(scene_, scene_.objects[object], objects_.objects[object].first_matrix,
                          TriangleMatrix::kNormalConsistent)[id.primitive];
  }
  nlohmann::ordered_json measured() const {
    return measure(truth_, expected_, frame_, MatrixOwners(scene_, objects_, image_),
                   kShippedFormat.number);
  }
  /// The first pixel that hits this instance, the ray well within the triangle.
  std::size_t pixel_on(std::uint32_t instance) const {
    for (std::size_t i = 0; i < expected_.hits.size(); ++i) {
      const auto& hit = expected_.hits[i];
      if (hit && hit->id.instance == instance && hit->margin > 0.05) return i;
    }
    ADD_FAILURE() << "no pixel hits instance " << instance;
    return 0;
  }

  const Scene scene_ = ball_on_floor();
  const Camera camera_ =
      look_at({0, 3, 8}, {0, 1, 0}, {0, 1, 0}, 45, static_cast<double>(kWidth) / kHeight);
  const SceneTrees trees_ = build_scene_trees(scene_);
  const ObjectImage objects_{scene_, trees_.objects, testing::test_core()};
  const FrameImage image_{scene_, objects_, trees_.instances, camera_, kWidth, kHeight};
  const Truth truth_{scene_};
  TruthShading shading_;
  TruthFrame expected_;
  Frame frame_;
};

TEST_F(MeasuresTest, ATrueFrameHasOnlyTheRoundingOfItsNumbers) {
  const auto found = measured();
  const auto& primary = found["primary"];
  EXPECT_EQ(primary["rays"], kWidth * kHeight);
  EXPECT_GT(primary["hits"], 300);
  for (const char* name : {"missed", "false", "wrong_triangle", "neighbour", "ties"}) {
    EXPECT_EQ(primary[name], 0) << name;
  }
  EXPECT_GT(primary["t_median"], 0);
  EXPECT_LE(primary["t_max"], 0x1p-17);
  EXPECT_LE(primary["u_max"], 0x1p-17);
  EXPECT_TRUE(primary["double"].is_null());
  const auto& light = found["light"];
  EXPECT_GT(light["judged"], 100);
  EXPECT_GT(light["shadows"], 20);
  EXPECT_EQ(light["missed"], 0);
  EXPECT_EQ(light["false"], 0);
  EXPECT_EQ(light["unexplained"], 0);
  EXPECT_GT(found["reflection"]["judged"], 20);
  EXPECT_GT(found["reflection"]["hits"], 10);
  EXPECT_EQ(found["reflection"]["wrong"], 0);
  EXPECT_EQ(found["image"]["differ"], 0);
  EXPECT_EQ(found["image"]["rms"], 0);
  EXPECT_TRUE(found["image"]["psnr"].is_null());
}

TEST_F(MeasuresTest, CountsMissedFalseAndWrong) {
  const std::size_t ball = pixel_on(0);
  const std::size_t floor = pixel_on(1);
  frame_.hits[ball].hit = false;
  std::size_t sky = 0;
  while (expected_.hits[sky]) ++sky;
  frame_.hits[sky].hit = true;
  const HitRecord of_floor = frame_.hits[floor];
  frame_.hits[floor] = record(*expected_.hits[pixel_on(0)]);
  const auto primary = measured()["primary"];
  EXPECT_EQ(primary["missed"], 1);
  EXPECT_EQ(primary["false"], 1);
  EXPECT_EQ(primary["wrong_triangle"], 1);
  EXPECT_DOUBLE_EQ(primary["wrong_share"], 3.0 / (kWidth * kHeight));

  frame_.hits[floor] = of_floor;
  frame_.hits[floor].object = 99999;
  EXPECT_EQ(measured()["primary"]["wrong_triangle"], 1) << "a matrix that is no instance's";
}

TEST_F(MeasuresTest, ANeighbourIsCountedApart) {
  const std::size_t floor = pixel_on(1);
  const PrimitiveId id = expected_.hits[floor]->id;
  frame_.hits[floor].triangle = number({id.instance, id.primitive ^ 1});
  const auto primary = measured()["primary"];
  EXPECT_EQ(primary["wrong_triangle"], 0);
  EXPECT_EQ(primary["neighbour"], 1);
}

TEST_F(MeasuresTest, ErrorsAreRelativeInDistanceAndAbsoluteInTheWeights) {
  const std::size_t at = pixel_on(1);
  const TruthHit& hit = *expected_.hits[at];
  frame_.hits[at].t = bits(hit.t * 1.25);
  frame_.hits[at].u = bits(hit.u + 0.5);
  frame_.hits[at].v = bits(hit.v - 0.25);
  frame_.hits[at].cosine = bits(hit.cosine + glm::length(expected_.rays[at].direction) / 8);
  const auto primary = measured()["primary"];
  EXPECT_NEAR(primary["t_max"], 0.25, 1e-4);
  EXPECT_NEAR(primary["u_max"], 0.5, 1e-4);
  EXPECT_NEAR(primary["v_max"], 0.25, 1e-4);
  EXPECT_NEAR(primary["cosine_max"], 0.125, 1e-4);
  EXPECT_LT(primary["t_p99"], 1e-4);
  EXPECT_LT(primary["t_median"], 1e-5);
}

TEST_F(MeasuresTest, AShadowThatIsNotThereAndOneThatIsTooManyAreTold) {
  unsigned lost = 0, gained = 0;
  for (const LightRayTruth& ray : expected_.light_rays) {
    if (ray.bounce != 0 || ray.light != 0 || ray.adds[0] < 16 * 40) continue;
    if ((ray.shadow ? lost : gained) == 5) continue;
    ++(ray.shadow ? lost : gained);
    std::uint32_t pixel = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned was = expected_.unlimited[ray.pixel][k];
      const unsigned sum = ray.shadow ? was + ray.adds[k] : was - ray.adds[k];
      pixel |= std::min(sum / 16, 255u) << (8 * k);
    }
    frame_.pixels[ray.pixel] = pixel;
  }
  ASSERT_EQ(lost, 5u);
  ASSERT_EQ(gained, 5u);
  const auto light = measured()["light"];
  EXPECT_GE(light["missed"], 3) << "of five, some of them on the mirror, where none is judged";
  EXPECT_LE(light["missed"], 5);
  EXPECT_GE(light["false"], 3);
  EXPECT_LE(light["false"], 5);
  EXPECT_EQ(light["unexplained"], 0);
}

TEST_F(MeasuresTest, AWrongMirrorAndAnUnexplainedPixelAreTold) {
  std::size_t mirror = expected_.pixels.size();
  for (const ReflectionTruth& ray : expected_.reflections) {
    if (ray.hit) mirror = ray.pixel;
  }
  ASSERT_LT(mirror, expected_.pixels.size());
  frame_.pixels[mirror] = 0x0000ff;
  const std::size_t ball = pixel_on(0);
  frame_.pixels[ball] = 0xff0000;
  const auto found = measured();
  EXPECT_EQ(found["reflection"]["wrong"], 1);
  EXPECT_EQ(found["light"]["unexplained"], 1);
  EXPECT_EQ(found["image"]["differ"], 2);
  EXPECT_EQ(found["image"]["differ_by_10"], 2);
}

TEST_F(MeasuresTest, PicturesAreComparedInLevels) {
  frame_.pixels[7] ^= 0x000004;    // one bit of red
  frame_.pixels[9] |= 0xff000000;  // no part of the colour
  const auto image = measured()["image"];
  EXPECT_EQ(image["differ"], 1);
  EXPECT_EQ(image["differ_by_10"], 0);
  EXPECT_EQ(image["largest"], 4);
  const double rms = 4 / std::sqrt(3.0 * kWidth * kHeight);
  EXPECT_NEAR(image["rms"], rms, 1e-5);
  EXPECT_NEAR(image["psnr"], 20 * std::log10(255 / rms), 1e-3);
  EXPECT_NEAR(image["mean"], 4 / (3.0 * kWidth * kHeight), 1e-5);
  EXPECT_EQ(difference_picture(expected_.pixels, frame_.pixels)[7], 0x000040u);
}

class EyeLightTest : public MeasuresTest {
 protected:
  EyeLightTest() : MeasuresTest(true) {}
};

TEST_F(EyeLightTest, HasNoOtherRays) {
  const auto found = measured();
  EXPECT_FALSE(found.contains("light"));
  EXPECT_FALSE(found.contains("reflection"));
  // 204 of 255 times the cosine with the ball, in 256ths rounded down.
  const std::size_t ball = pixel_on(0);
  const auto bright = static_cast<unsigned>(256 * std::abs(expected_.hits[ball]->cosine));
  const std::uint32_t level = 204 * std::min(bright, 256u) / 256;
  EXPECT_EQ(expected_.pixels[ball], level * 0x010101u);
}

TEST(MeasuresTableTest, TheDocumentHasIt) {
  std::ifstream file(DYNRT_DOCS_FOLDER "/measures.md");
  ASSERT_TRUE(file);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr(measures_table()));
}

}  // namespace
}  // namespace dynrt::host
