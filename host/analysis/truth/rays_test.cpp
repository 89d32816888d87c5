// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/rays.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "host/scene/camera.h"

namespace dynrt::host {
namespace {

void expect_near(const glm::dvec3& got, const glm::dvec3& expected) {
  EXPECT_LT(glm::length(got - expected), 1e-12)
      << got.x << ' ' << got.y << ' ' << got.z << " instead of " << expected.x << ' ' << expected.y
      << ' ' << expected.z;
}

/// A triangle in the object's plane z = 0.
Scene mirror(const glm::dmat4& transform) {
  Scene scene;
  scene.materials = {{"mirror", glm::dvec3(0.5), 0.5}};
  scene.objects.push_back({.name = "mirror",
                           .vertices = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}},
                           .triangles = {{0, 1, 2}},
                           .material = {0}});
  scene.instances.push_back({"mirror", 0, transform});
  return scene;
}

TEST(RaysTest, PrimaryRaysGoThroughTheCentresOfPixels) {
  Camera camera;
  camera.position = {1, 2, 3};
  camera.right = {4, 0, 0};
  camera.up = {0, 2, 0};
  camera.forward = {0, 0, -1};
  const TruthRay corner = primary_ray(camera, 4, 2, 0, 0);
  expect_near(corner.origin, {1, 2, 3});
  expect_near(corner.direction, {-1.5, 0.5, -1});
  expect_near(primary_ray(camera, 4, 2, 3, 1).direction, {1.5, -0.5, -1});
  EXPECT_EQ(corner.from, 0);
}

TEST(RaysTest, ALightRayReachesTheSurfaceAtOneAndDoesNotSeeIt) {
  const Scene scene = mirror(glm::dmat4(1.0));
  const Truth truth(scene);
  const TruthRay ray{{0, 0, 4}, {0, 0, -2}};
  const TruthHit hit = truth.nearest(ray).value();
  const TruthRay light = light_ray(scene, {"lamp", {3, 0, 5}, glm::dvec3(1)}, ray, hit);
  expect_near(light.origin + light.direction, {0, 0, 0});
  EXPECT_EQ(light.own, hit.id);
  EXPECT_EQ(light.to, 1 - kSurfaceMargin);
  EXPECT_FALSE(truth.any(light));
}

TEST(RaysTest, AReflectedRayKeepsItsParameter) {
  const Scene scene = mirror(glm::dmat4(1.0));
  const Truth truth(scene);
  const TruthRay ray{{1, 0, 4}, {0.5, 0, -2}};
  const TruthHit hit = truth.nearest(ray).value();
  EXPECT_EQ(hit.t, 2);
  const TruthRay reflected = reflection_ray(scene, ray, hit).value();
  expect_near(reflected.origin, {1, 0, -4});
  expect_near(reflected.direction, {0.5, 0, 2});
  EXPECT_EQ(reflected.from, 2 + 2 * kSurfaceMargin);
  EXPECT_EQ(reflected.own, hit.id);
}

TEST(RaysTest, AnInstanceIsMirroredInItsOwnSpace) {
  glm::dmat4 turned = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -3));
  turned = glm::rotate(turned, glm::radians(45.0), glm::dvec3(0, 1, 0));
  const Scene scene = mirror(glm::scale(turned, glm::dvec3(2, 2, -0.5)));
  const Truth truth(scene);
  const TruthRay ray{{0, 0, 0}, {0, 0, -1}};
  const TruthHit hit = truth.nearest(ray).value();
  EXPECT_DOUBLE_EQ(hit.t, 3);
  const TruthRay reflected = reflection_ray(scene, ray, hit).value();
  expect_near(reflected.origin + hit.t * reflected.direction, {0, 0, -3});
  expect_near(reflected.direction, {1, 0, 0});
}

TEST(RaysTest, TheMarginIsOfAStepsLength) {
  const Scene scene = mirror(glm::dmat4(1.0));
  const Truth truth(scene);
  const TruthRay ray{{0, 0, 4 - 0x1p-9}, {0, 0, -1}};
  const TruthHit hit = truth.nearest(ray).value();
  // From 2^-9 below 4 half of the margin of 2^-8 leads up to 4; the rest counts twice.
  EXPECT_EQ(reflection_ray(scene, ray, hit)->from, 4 + 2 * (0x1p-8 - 0x1p-9));
}

}  // namespace
}  // namespace dynrt::host
