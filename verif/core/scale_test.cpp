// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// There is no absolute epsilon anywhere: a scene scaled by a power of two that stays in the range
// of the core's numbers gives the same hits bit for bit, distances scaled.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "host/app/board_frame.h"

namespace dynrt::host {
namespace {

constexpr unsigned kWidth = 48, kHeight = 36;

Prepared prepared(const std::string& name) {
  SceneArguments arguments;
  arguments.scene = name;
  return prepare(arguments, kWidth, kHeight);
}

/// Everything that is a length, times a factor; trees and memory made anew.
void scale(Prepared& p, double factor) {
  for (Mesh& mesh : p.scene.objects) {
    for (glm::dvec3& vertex : mesh.vertices) vertex *= factor;
  }
  for (Instance& instance : p.scene.instances) {
    for (int axis = 0; axis < 3; ++axis) instance.transform[3][axis] *= factor;
  }
  p.camera.position *= factor;
  p.trees = build_scene_trees(p.scene);
  p.objects = ObjectImage(p.scene, p.trees.objects);
  p.frame = FrameImage(p.scene, p.objects, p.trees.instances, p.camera, kWidth, kHeight);
}

std::vector<HitRecord> hits(const Prepared& p) {
  const auto board = make_board(configurations(), {"model", "thesis", ""});
  FrameOptions options;
  options.width = kWidth;
  options.height = kHeight;
  return render_on(*board, options, p).hits;
}

class Scale : public testing::TestWithParam<std::tuple<std::string, int>> {};

TEST_P(Scale, TheHitsAreTheSame) {
  const auto& [name, exponent] = GetParam();
  Prepared p = prepared(name);
  const std::vector<HitRecord> plain = hits(p);
  scale(p, std::exp2(exponent));
  const std::vector<HitRecord> scaled = hits(p);
  ASSERT_EQ(plain.size(), scaled.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    HitRecord expected = plain[i];
    if (expected.hit) {
      ++count;
      expected.t += static_cast<std::uint32_t>(exponent) << Real::kMantissaBits;
    }
    ASSERT_EQ(scaled[i], expected) << "pixel " << i % kWidth << ", " << i / kWidth;
  }
  EXPECT_GT(count, plain.size() / 3);
}

std::string name_of(const testing::TestParamInfo<std::tuple<std::string, int>>& info) {
  const auto& [name, exponent] = info.param;
  return name + (exponent < 0 ? "_down_" : "_up_") + std::to_string(std::abs(exponent));
}

INSTANTIATE_TEST_SUITE_P(TwoLevels, Scale,
                         testing::Combine(testing::Values("blocks"),
                                          testing::Values(-20, -7, 1, 10, 20)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(ManyTriangles, Scale,
                         testing::Combine(testing::Values("office"), testing::Values(-20, 20)),
                         name_of);

}  // namespace
}  // namespace dynrt::host
