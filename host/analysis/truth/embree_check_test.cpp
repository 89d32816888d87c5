// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/embree_check.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "host/analysis/truth/rays.h"
#include "host/scene/camera.h"
#include "host/scene/load.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host {
namespace {

EmbreeComparison compared(const Truth& truth, const std::vector<TruthRay>& rays) {
  const EmbreeComparison found = compare_with_embree(truth, rays, truth.nearest(rays));
  EXPECT_EQ(found.unexplained, 0u) << found.text();
  EXPECT_EQ(found.rays, rays.size());
  EXPECT_EQ(found.same + found.ties + found.near_in_distance + found.near_an_edge, rays.size());
  std::cout << found.text() << '\n';
  return found;
}

std::vector<TruthRay> primary_rays(const Scene& scene, unsigned width, unsigned height) {
  const Camera camera = choose_camera(scene, {}, static_cast<int>(width), static_cast<int>(height));
  std::vector<TruthRay> rays;
  for (unsigned y = 0; y < height; ++y) {
    for (unsigned x = 0; x < width; ++x) rays.push_back(primary_ray(camera, width, height, x, y));
  }
  return rays;
}

TEST(EmbreeCheckTest, OfOfficeNearlyAllIsTheSame) {
  const Scene scene = load_scene("office");
  const Truth truth(scene);
  const auto rays = primary_rays(scene, 192, 144);
  const EmbreeComparison found = compared(truth, rays);
  EXPECT_GT(found.same, rays.size() * 9 / 10);
  EXPECT_GT(found.hits, rays.size() / 2);
}

TEST(EmbreeCheckTest, AtVerticesItNamesOneOfTheTied) {
  Mesh ball;
  testing::add_sphere(ball, {0, 0, 0}, 1, 16);
  const Scene scene = testing::scene_of(ball);
  const Truth truth(scene);
  std::vector<TruthRay> rays;
  for (const glm::dvec3& vertex : scene.objects[0].vertices) {
    rays.push_back({glm::dvec3(0.0), vertex});
    rays.push_back({glm::dvec3(0.125, -0.25, 0.5), vertex - glm::dvec3(0.125, -0.25, 0.5)});
  }
  const EmbreeComparison found = compared(truth, rays);
  EXPECT_GT(found.ties, rays.size() / 4);
}

TEST(EmbreeCheckTest, CoincidentAndNearlyCoincidentTrianglesCannotBeTold) {
  Mesh mesh = testing::soup(3, 40, 1.0);
  Scene scene = testing::scene_of(mesh);
  scene.instances.push_back(scene.instances.front());
  glm::dmat4 beside(1.0);
  beside[3] = glm::dvec4(0x1p-40, 0x1p-40, 0x1p-40, 1);
  scene.instances.push_back({"beside", 0, beside});
  const Truth truth(scene);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(-1, 1);
  std::vector<TruthRay> rays;
  for (int i = 0; i < 3000; ++i) {
    rays.push_back({{at(random), at(random), 4}, {0.3 * at(random), 0.3 * at(random), -1}});
  }
  const EmbreeComparison found = compared(truth, rays);
  EXPECT_GT(found.ties, 0u);
  EXPECT_GT(found.near_in_distance, 100u);
}

TEST(EmbreeCheckTest, FarAwayItsFloatsLoseEdges) {
  Mesh ball;
  testing::add_sphere(ball, {0, 0, 0}, 1, 12);
  Scene scene = testing::scene_of(ball);
  const glm::dvec3 far(148376, 1234, -223423);
  scene.instances[0].transform[3] = glm::dvec4(far, 1);
  const Truth truth(scene);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> at(-1, 1);
  std::vector<TruthRay> rays;
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 target = far + 0.9 * glm::dvec3(at(random), at(random), at(random));
    const glm::dvec3 origin = far + glm::dvec3(at(random), at(random), 5);
    rays.push_back({origin, target - origin});
  }
  EXPECT_GT(compared(truth, rays).near_an_edge, 30u);
}

TEST(EmbreeCheckTest, WhatNothingExplainsIsTold) {
  const Scene scene = testing::scene_of(testing::soup(3, 40, 1.0));
  const Truth truth(scene);
  const TruthRay ray{{0, 0, 9},
                     scene.objects[0].vertices[0] / 3.0 + scene.objects[0].vertices[1] / 3.0 +
                         scene.objects[0].vertices[2] / 3.0 - glm::dvec3(0, 0, 9)};
  std::vector<TruthRay> rays{ray};
  std::vector<std::optional<TruthHit>> hits(1);
  const EmbreeComparison found = compare_with_embree(truth, rays, hits);
  EXPECT_EQ(found.unexplained, 1u);
  EXPECT_EQ(found.first_unexplained, 0u);
}

}  // namespace
}  // namespace dynrt::host
