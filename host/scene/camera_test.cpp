// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/scene/generate.h"
#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

constexpr double kNear = 1e-12;

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::length(a - b), kNear) << a.x << " " << a.y << " " << a.z;
}

Scene ball_at(const glm::dvec3& centre) {
  Scene scene;
  scene.objects.push_back(make_sphere(1.0, 1, 0));
  glm::dmat4 transform(1.0);
  transform[3] = glm::dvec4(centre, 1.0);
  scene.instances.push_back({"ball", 0, transform});
  return scene;
}

TEST(Camera, LooksAlongAnAxis) {
  const Camera camera = look_at({0, 0, 5}, {0, 0, 0}, {0, 2, 0}, 90.0, 2.0);
  expect_near(camera.position, {0, 0, 5});
  expect_near(camera.forward, {0, 0, -1});
  expect_near(camera.up, {0, 2, 0});
  expect_near(camera.right, {4, 0, 0});
}

TEST(Camera, FramesEveryCornerOfTheScene) {
  const Scene scene = ball_at({100, -20, 3});
  for (const auto [width, height] : {std::pair(512, 384), std::pair(100, 400)}) {
    const Camera camera = choose_camera(scene, {}, width, height);
    double widest = 0.0;
    for (const glm::dvec3& v : scene.objects[0].vertices) {
      const glm::dvec3 d = v + glm::dvec3(100, -20, 3) - camera.position;
      const double depth = glm::dot(d, camera.forward);
      EXPECT_GT(depth, 0.0);
      const double x = glm::dot(d, camera.right) / glm::dot(camera.right, camera.right) / depth;
      const double y = glm::dot(d, camera.up) / glm::dot(camera.up, camera.up) / depth;
      widest = std::max({widest, std::abs(x), std::abs(y)});
    }
    EXPECT_LE(widest, 0.5);
    EXPECT_GE(widest, 0.25);  // and does not stand far off
  }
}

TEST(Camera, FlagsWinOverTheScenesOwn) {
  Scene scene = ball_at({0, 0, 0});
  scene.camera = look_at({0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 40.0, 1.0);
  const Camera own = choose_camera(scene, {}, 300, 100);
  expect_near(own.position, {0, 0, 9});
  EXPECT_NEAR(glm::length(own.right), 3.0 * glm::length(own.up), kNear);
  EXPECT_NEAR(glm::length(own.up), 2.0 * std::tan(20.0 * 3.14159265358979 / 180.0), kNear);

  CameraOverrides flags;
  flags.position = glm::dvec3(4, 0, 9);
  const Camera moved = choose_camera(scene, flags, 100, 100);
  expect_near(moved.position, {4, 0, 9});
  expect_near(moved.forward, {0, 0, -1});
  EXPECT_NEAR(glm::length(moved.up), glm::length(own.up), kNear);

  flags.look_at = glm::dvec3(4, 1, 9);
  flags.up = glm::dvec3(0, 0, 1);
  flags.field_of_view = 90.0;
  const Camera turned = choose_camera(scene, flags, 100, 100);
  expect_near(turned.forward, {0, 1, 0});
  expect_near(turned.up, {0, 0, 2});
}

TEST(Camera, RefusesWhatSeesNothing) {
  const Scene scene = ball_at({0, 0, 0});
  const auto error = [&](CameraOverrides flags, int width = 4, int height = 3) {
    return user_error([&] { choose_camera(scene, flags, width, height); });
  };
  EXPECT_EQ(error({.position = {}, .look_at = {}, .up = {}, .field_of_view = 180.0}),
            "the camera's field of view is 180 degrees; it must lie between 0 and 180");
  EXPECT_EQ(error({.position = {}, .look_at = {}, .up = {}, .field_of_view = NAN}),
            "the camera's field of view is nan degrees; it must lie between 0 and 180");
  const glm::dvec3 p(1, 2, 3);
  EXPECT_EQ(error({.position = p, .look_at = p, .up = {}, .field_of_view = {}}),
            "the camera's position and the point that it looks at are the same (1, 2, 3); move one "
            "of the two");
  EXPECT_EQ(error({.position = p, .look_at = glm::dvec3(1, 9, 3), .up = {}, .field_of_view = {}}),
            "the camera's up direction (0, 1, 0) is parallel to its view; give another one");
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(
      error({.position = glm::dvec3(inf, 0, 0), .look_at = {}, .up = {}, .field_of_view = {}}),
      "the camera's position (inf, 0, 0) is not finite");
  EXPECT_EQ(error({}, 0, 3), "the image is 0x3 pixels; both sides must be at least 1");
}

}  // namespace
}  // namespace dynrt::host
