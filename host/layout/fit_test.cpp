// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "host/error.h"
#include "host/format/memory_format_of.h"
#include "host/layout/test_scene.h"
#include "host/scene/animation.h"

namespace dynrt::host {
namespace {

using ::testing::ThrowsMessage;
using testing::two_objects;

const Camera kCamera = testing::camera_at({0.1, 0.2, 20}, {0, 0, -1});

glm::dvec3 at(const glm::dmat4& m, const glm::dvec3& p) { return {m * glm::dvec4(p, 1.0)}; }

void expect_close(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-12 * (1 + glm::length(b))) << a.x << " " << a.y << " " << a.z;
}

/// The same scene as a file may have it: `by` times larger, elsewhere.
Scene scaled(Scene scene, double by, const glm::dvec3& to) {
  for (Mesh& mesh : scene.objects) {
    for (glm::dvec3& vertex : mesh.vertices) vertex *= by;
  }
  for (Instance& instance : scene.instances) {
    instance.transform[3] = glm::dvec4(by * glm::dvec3(instance.transform[3]) + to, 1.0);
  }
  for (PointLight& light : scene.lights) light.position = by * light.position + to;
  return scene;
}
Camera scaled(Camera camera, double by, const glm::dvec3& to) {
  camera.position = by * camera.position + to;
  return camera;
}

TEST(Fit, EverythingIsWhereItWasInTheCoresSpace) {
  Scene scene = two_objects();
  scene.lights.push_back({"lamp", {3, 4, 5}, {1, 2, 3}});
  const Fit fitted = fit(scene, kCamera, kShippedFormat);
  Scene moved = scene;
  move_into(fitted, moved);
  double largest = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& was = scene.instances[i];
    const Instance& is = moved.instances[i];
    for (std::size_t v = 0; v < scene.objects[was.object].vertices.size(); v += 7) {
      const glm::dvec3 p = at(was.transform, scene.objects[was.object].vertices[v]);
      const glm::dvec3 q = at(is.transform, moved.objects[is.object].vertices[v]);
      expect_close(fitted.world.outside(q), p);
      largest = std::max({largest, std::abs(q.x), std::abs(q.y), std::abs(q.z)});
    }
  }
  EXPECT_LT(largest, 1);
  EXPECT_GT(largest, 0.25);
  expect_close(fitted.world.outside(moved.lights[0].position), {3, 4, 5});
  // As bright: |n . d| / (d . d) falls with the distance.
  expect_close(moved.lights[0].colour * fitted.world.unit, {1, 2, 3});
  expect_close(fitted.world.outside(moved_into(fitted.world, kCamera).position), kCamera.position);
  EXPECT_EQ(moved_into(fitted.world, kCamera).forward, kCamera.forward);
  for (const Mesh& mesh : moved.objects) {
    for (const glm::dvec3& v : mesh.vertices) {
      EXPECT_LT(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}), 1);
    }
  }
}

TEST(Fit, WhatLiesAboutTheOriginInAFewDigitsKeepsThem) {
  Scene scene = two_objects();
  scene.instances.resize(1);
  scene.instances[0].transform = glm::dmat4(1);
  scene.objects[0].vertices[0] = {-4, -4, -4};
  scene.objects[0].vertices[1] = {4.25, 4, 4.125};
  const Fit fitted = fit(scene, kCamera, kShippedFormat);
  EXPECT_EQ(fitted.world.centre, glm::dvec3(0));
  EXPECT_EQ(fitted.objects[0].centre, glm::dvec3(0));
  EXPECT_EQ(fitted.world.unit, 8);
}

TEST(Fit, AScaledSceneHasTheSameBits) {
  const Scene scene = two_objects();
  Scene expected = scene;
  move_into(fit(scene, kCamera, kShippedFormat), expected);
  for (const int exponent : {-300, -20, -7, 1, 20, 300}) {
    const double by = std::ldexp(1.0, exponent);
    Scene other = scaled(scene, by, {});
    move_into(fit(other, scaled(kCamera, by, {}), kShippedFormat), other);
    for (std::size_t k = 0; k < other.objects.size(); ++k) {
      ASSERT_EQ(other.objects[k].vertices, expected.objects[k].vertices) << exponent;
    }
    for (std::size_t i = 0; i < other.instances.size(); ++i) {
      ASSERT_EQ(other.instances[i].transform, expected.instances[i].transform) << exponent;
    }
  }
}

TEST(Fit, WhatIsFarAwayComesToTheOrigin) {
  const glm::dvec3 far(1 << 18, -(1 << 12), -3);
  const Scene scene = scaled(two_objects(), 1, far);
  const Fit fitted = fit(scene, scaled(kCamera, 1, far), kShippedFormat);
  EXPECT_LT(glm::length(fitted.world.centre - far), 8);
  EXPECT_EQ(fitted.world.centre.z, 0) << "the origin lies within";
  EXPECT_EQ(fitted.objects[0].centre, glm::dvec3(0)) << "the object lies where it did";
  EXPECT_GE(fitted.world.unit, 8);
  EXPECT_LE(fitted.world.unit, 32);
}

TEST(Fit, ObjectsInOtherUnitsGetTheirOwnScale) {
  Scene scene = two_objects();
  Mesh& ball = scene.objects[1];
  for (glm::dvec3& v : ball.vertices) v = 1000.0 * v + glm::dvec3(5e4, 0, 0);
  for (Instance& instance : scene.instances) {
    if (instance.object != 1) continue;
    instance.transform = glm::scale(instance.transform, glm::dvec3(1e-3));
    instance.transform = glm::translate(instance.transform, glm::dvec3(-5e4, 0, 0));
  }
  const Fit fitted = fit(scene, kCamera, kMemoryFormatOf<hls::Float<5, 8>>);
  Scene moved = scene;
  move_into(fitted, moved);
  EXPECT_EQ(fitted.objects[0].unit, fitted.world.unit);
  EXPECT_EQ(fitted.objects[1].unit, 256 * fitted.world.unit);
  for (const Mesh& mesh : moved.objects) {
    for (const glm::dvec3& v : mesh.vertices) EXPECT_LT(glm::length(v), 8);
  }
  EXPECT_NO_THROW(
      testing::Laid(moved, moved_into(fitted.world, kCamera), kMemoryFormatOf<hls::Float<5, 8>>));
}

TEST(Fit, TheHeadroomIsWhatMayBeScaledAway) {
  const Scene scene = two_objects();
  for (const MemoryFormat* format :
       {&kShippedFormat, &kMemoryFormatOf<hls::Float<5, 8>>, &kMemoryFormatOf<hls::Float<8, 23>>}) {
    const Fit fitted = fit(scene, kCamera, *format);
    Scene moved = scene;
    move_into(fitted, moved);
    const Camera camera = moved_into(fitted.world, kCamera);
    const auto lay = [&](int exponent) {
      const double by = std::ldexp(1.0, exponent);
      return [=, &moved, &camera] {
        testing::Laid(scaled(moved, by, {}), scaled(camera, by, {}), *format);
      };
    };
    // The trees' planes have no more exponents than those of the shipped format.
    const int up = std::min(fitted.headroom.up, 60);
    EXPECT_NO_THROW(lay(up)()) << format->exponent_bits;
    EXPECT_THROW(lay(up + 5)(), UserError) << format->exponent_bits;
    EXPECT_NO_THROW(lay(-fitted.headroom.down)()) << format->exponent_bits;
    EXPECT_THROW(lay(-fitted.headroom.down - 1)(), UserError) << format->exponent_bits;
  }
}

TEST(Fit, WhatMovesMovesInTheCoresSpace) {
  Scene scene = two_objects();
  scene.motion.push_back({.name = "slide",
                          .parent = std::nullopt,
                          .position = {{0, {0, 0, 0}}, {1, {40, 0, 0}}},
                          .rotation = {},
                          .scale = {}});
  scene.motion.push_back({.name = "arm",
                          .parent = 0,
                          .transform = scene.instances[1].transform,
                          .position = {},
                          .rotation = {},
                          .scale = {}});
  scene.instances[1].motion = 1;
  scene.camera = kCamera;
  scene.camera_motion = 0;
  const Fit fitted = fit(scene, kCamera, kShippedFormat);
  Scene moved = scene;
  move_into(fitted, moved);
  for (const double time : {0.0, 0.3, 1.0}) {
    move_to(scene, time);
    move_to(moved, time);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const std::uint32_t object = scene.instances[i].object;
      const glm::dvec3 p = at(scene.instances[i].transform, scene.objects[object].vertices[3]);
      const glm::dvec3 q = at(moved.instances[i].transform, moved.objects[object].vertices[3]);
      expect_close(fitted.world.outside(q), p);
      EXPECT_LT(glm::length(q), 2) << "chosen for all moments";
    }
    expect_close(fitted.world.outside(moved.camera->position), scene.camera->position);
    expect_close(moved.camera->forward, scene.camera->forward);
  }
}

TEST(Fit, WhatFitsAtNoScaleIsNamed) {
  Scene scene = two_objects();
  scene.name = "stiff";
  Mesh& soup = scene.objects[0];
  soup.vertices[3] = {1e10, 0, 0};
  EXPECT_THAT([&] { fit(scene, kCamera, kMemoryFormatOf<hls::Float<5, 8>>); },
              ThrowsMessage<UserError>(::testing::HasSubstr(
                  "no scale fits scene 'stiff' into the 5 exponent bits of the core's numbers: ")));
  EXPECT_NO_THROW(fit(scene, kCamera, kShippedFormat));
  scene = two_objects();
  EXPECT_THAT([&] { fit(scene, testing::camera_at({0, 0, 1e38}, {0, 0, -1}), kShippedFormat); },
              ThrowsMessage<UserError>(
                  ::testing::HasSubstr("the camera stands at z = 1e+38, and triangle")));
}

}  // namespace
}  // namespace dynrt::host
