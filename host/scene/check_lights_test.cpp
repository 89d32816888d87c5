// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/check_lights.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "host/scene/generate.h"
#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

constexpr glm::dvec3 kEye{0, 0, 20};

// A box with corners at +-1, turned and stretched to +-2 in x, around (5, 0, 0).
Scene one_box() {
  Scene scene;
  scene.name = "s";
  scene.materials.push_back({"grey"});
  scene.objects.push_back(make_box({-1, -1, -1}, {1, 1, 1}, 0));
  const glm::dmat4 m = glm::translate(glm::dmat4(1.0), {5, 0, 0});
  scene.instances.push_back({"case", 0, glm::scale(m, {-2, 1, 1})});
  return scene;
}

Scene with_light(Scene scene, const glm::dvec3& position) {
  scene.lights.push_back({"lamp", position});
  return scene;
}

TEST(CheckLights, TakesLightsOutside) {
  EXPECT_NO_THROW(check_lights(one_box(), kEye));
  for (const glm::dvec3 p : {glm::dvec3(0, 0, 0), glm::dvec3(5, 1.01, 0), glm::dvec3(7.001, 0, 0),
                             glm::dvec3(5, 5, 5)}) {
    EXPECT_NO_THROW(check_lights(with_light(one_box(), p), kEye)) << p.x << ", " << p.y;
  }
}

TEST(CheckLights, NamesALightInsideAClosedObject) {
  const auto sentence = [](const Scene& scene, const glm::dvec3& eye) {
    return user_error([&] { check_lights(scene, eye); });
  };
  EXPECT_EQ(sentence(with_light(one_box(), {6.5, 0.5, 0}), kEye),
            "scene 's': light 'lamp' at (6.5, 0.5, 0) lies inside 'case', a closed object that no "
            "light leaves; move the light");
  // Whoever is inside too sees its light.
  EXPECT_NO_THROW(check_lights(with_light(one_box(), {6.5, 0.5, 0}), {4, 0, 0}));
}

TEST(CheckLights, PartsThatOverlapAreClosedAsWell) {
  Scene scene = one_box();
  const Mesh other = make_box({-0.5, -0.5, -3}, {0.5, 0.5, 3}, 0);
  Mesh& mesh = scene.objects[0];
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const glm::uvec3& t : other.triangles) mesh.triangles.push_back(t + first);
  mesh.material.resize(mesh.triangles.size());
  for (const glm::dvec3 p : {glm::dvec3(5.2, 0.1, 0.3), {5.2, 0.7, 0.3}, {5.2, 0.1, 2.3}}) {
    EXPECT_TRUE(user_error([&] { check_lights(with_light(scene, p), kEye); }).find("lies inside") !=
                std::string::npos)
        << p.z;
  }
  EXPECT_NO_THROW(check_lights(with_light(scene, {5.2, 0.7, 2.3}), kEye));
}

TEST(CheckLights, AnOpenObjectLetsTheLightOut) {
  Scene scene = one_box();
  Mesh& box = scene.objects[0];
  for (std::size_t lid = 0; lid < box.triangles.size(); ++lid) {
    Scene open = with_light(scene, {5.3, 0.2, -0.4});
    // A hole in two of its sides, whichever these are.
    Mesh& mesh = open.objects[0];
    for (int k = 0; k < 4; ++k) mesh.triangles[(lid + k) % mesh.triangles.size()] = {0, 0, 0};
    EXPECT_NO_THROW(check_lights(open, kEye)) << lid;
  }
}

TEST(CheckLights, NamesALightOnASurface) {
  const auto sentence = [](const glm::dvec3& p) {
    const Scene scene = with_light(one_box(), p);
    return user_error([&] { check_lights(scene, kEye); });
  };
  const std::string text = sentence({5.5, 1, 0.25});
  EXPECT_TRUE(text.starts_with("scene 's': light 'lamp' at (5.5, 1, 0.25) lies on triangle "))
      << text;
  EXPECT_TRUE(
      text.ends_with(" of 'case': the core's numbers cannot tell the two apart; move the light "
                     "away from the surface"))
      << text;
  // One unit in the last place of 5.5 is 2^-14; half of one is too near, four are not.
  sentence({5.5, 1 + 0x1p-15, 0.25});
  EXPECT_NO_THROW(check_lights(with_light(one_box(), {5.5, 1 + 0x1p-12, 0.25}), kEye));
}

TEST(CheckLights, SpheresAndRectanglesAreSurfacesToo) {
  Scene scene = one_box();
  Mesh& mesh = scene.objects[0];
  mesh = Mesh();
  mesh.name = "round";
  mesh.ellipsoids.push_back({glm::scale(glm::dmat4(1.0), {1, 2, 1})});
  mesh.rectangles.push_back({{-1, 3, -1}, {2, 0, 0}, {0, 0, 2}});
  const auto sentence = [&](const glm::dvec3& p) {
    return user_error([&] { check_lights(with_light(scene, p), kEye); });
  };
  EXPECT_NE(sentence({6.5, 0.5, 0}).find("lies inside 'case'"), std::string::npos);
  EXPECT_NE(sentence({7, 0, 0}).find("lies on sphere 1 of 'case'"), std::string::npos);
  EXPECT_NE(sentence({6.5, 3, 0.7}).find("lies on rectangle 0 of 'case'"), std::string::npos);
  for (const glm::dvec3 p : {glm::dvec3(7.01, 0, 0), {6.5, 3.01, 0.7}, {7.1, 3, 0.7}}) {
    EXPECT_NO_THROW(check_lights(with_light(scene, p), kEye)) << p.x;
  }
}

TEST(CheckLights, NamesALightAtInfinity) {
  Scene scene = one_box();
  scene.distant_lights.push_back("sun");
  EXPECT_EQ(user_error([&] { check_lights(scene, kEye); }),
            "scene 's': light 'sun' is infinitely far away, and dynrt has only point lights; make "
            "it a point light that is far away, or remove it");
}

}  // namespace
}  // namespace dynrt::host
