// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The scenes of scenes/*.json.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "host/scene/animation.h"
#include "host/scene/camera.h"
#include "host/scene/description.h"
#include "host/scene/load.h"

namespace dynrt::host {
namespace {

TEST(BuiltInScenes, OfficeIsOneObjectOf34312Triangles) {
  const Scene office = load_scene("office");
  EXPECT_EQ(office.name, "office");
  ASSERT_EQ(office.objects.size(), 1u);
  ASSERT_EQ(office.instances.size(), 1u);
  EXPECT_EQ(office.instances[0].transform, glm::dmat4(1.0));
  EXPECT_EQ(office.objects[0].triangles.size() + office.dropped.zero_area_triangles, 34312u);
  EXPECT_EQ(office.dropped.zero_area_triangles, 110u);
  EXPECT_TRUE(office.notes.empty());
  ASSERT_TRUE(office.camera);
  EXPECT_GT(duration(office), 0) << "there is a way through it";
  const Box room = bounds(office);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GT(office.camera->position[axis], room.low[axis] + 0.1);
    EXPECT_LT(office.camera->position[axis], room.high[axis] - 0.1);
  }
}

TEST(BuiltInScenes, OfficeModelsStayInsideTheRoom) {
  const Scene office = load_scene("office");
  const Mesh& mesh = office.objects[0];
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::string& name = office.materials[mesh.material[t]].name;
    if (name.find('#') == std::string::npos) continue;  // a box
    const bool in_wall = name.find("#door/") != name.npos || name.find("#window") != name.npos;
    const double slack = in_wall ? 0.1 : 0.0;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3& v = mesh.vertices[mesh.triangles[t][k]];
      EXPECT_TRUE(std::abs(v.x) <= 2.6 && v.y >= -1e-9 && v.y <= 2.6 && v.z >= -2.1 - slack &&
                  v.z <= 2.1)
          << name << ": " << v.x << " " << v.y << " " << v.z;
    }
  }
}

TEST(BuiltInScenes, CisternIsOneObjectOf68438Triangles) {
  const Scene cistern = load_scene("cistern");
  ASSERT_EQ(cistern.objects.size(), 1u);
  ASSERT_EQ(cistern.instances.size(), 1u);
  EXPECT_EQ(cistern.objects[0].triangles.size() + cistern.dropped.zero_area_triangles, 68438u);
  EXPECT_TRUE(cistern.notes.empty());
  ASSERT_TRUE(cistern.camera);
  EXPECT_LT(glm::length(cistern.camera->position * 32.0 - glm::dvec3(1096, 216 + 26, 432)), 1e-9);
}

TEST(BuiltInScenes, ConferenceIs54InstancesOf282804Triangles) {
  const Scene conference = load_scene("conference");
  EXPECT_EQ(conference.objects.size(), 13u);
  ASSERT_EQ(conference.instances.size(), 54u);
  EXPECT_TRUE(conference.notes.empty());
  EXPECT_EQ(conference.dropped.zero_area_triangles,
            30u);  // of the white board, which is there once
  std::size_t triangles = conference.dropped.zero_area_triangles;
  std::map<std::string, int> instances;
  for (const Instance& instance : conference.instances) {
    const Mesh& object = conference.objects[instance.object];
    triangles += object.triangles.size();
    ++instances[object.name];
    if (object.name == "room") continue;
    for (const glm::dvec3& v : object.vertices) {
      const glm::dvec3 p(instance.transform * glm::dvec4(v, 1.0));
      EXPECT_TRUE(std::abs(p.x) < 5.8 && std::abs(p.z) < 3.8 && p.y > -1e-9 && p.y < 2.9)
          << instance.name << ": " << p.x << " " << p.y << " " << p.z;
    }
  }
  EXPECT_EQ(triangles, 282804u);
  EXPECT_EQ(instances["office chair"], 20);
  EXPECT_EQ(instances["table"], 6);
}

TEST(BuiltInScenes, Trees4000Is4000InstancesOf20MillionTriangles) {
  const Scene trees = load_scene("trees4000");
  EXPECT_EQ(trees.instances.size(), 4000u);
  std::size_t triangles = 0, matrices = trees.instances.size();
  for (const Instance& i : trees.instances) triangles += trees.objects[i.object].triangles.size();
  for (const Mesh& object : trees.objects) matrices += object.triangles.size();
  EXPECT_EQ(triangles, 20020328u);
  EXPECT_LT(matrices, 1u << 17);
  EXPECT_EQ(trees.instances.back().name, "shrub 3515");
}

TEST(BuiltInScenes, BuiltInWalksStayInTheirScenes) {
  for (const char* name : {"cistern", "conference", "trees4000"}) {
    Scene scene = load_scene(name);
    const Box box = bounds(scene);
    const glm::dvec3 start = scene.camera->position;
    EXPECT_GE(duration(scene), 9.0);
    for (double time = 0.0; time <= duration(scene); time += 0.25) {
      move_to(scene, time);
      const glm::dvec3& eye = scene.camera->position;
      for (int k = 0; k < 3; ++k) EXPECT_TRUE(eye[k] > box.low[k] && eye[k] < box.high[k]) << time;
    }
    EXPECT_GT(glm::length(scene.camera->position - start), 3.0) << name;
  }
  const Scene conference = load_scene("conference");
  const auto late = transforms_at(conference, 4.5);
  int moved = 0;
  for (std::size_t i = 0; i < late.size(); ++i)
    moved += late[i] != conference.instances[i].transform;
  EXPECT_EQ(moved, 4);
}

TEST(BuiltInScenes, BlocksHasTwoLevels) {
  const Scene blocks = load_scene("blocks");
  EXPECT_EQ(blocks.objects.size(), 3u);  // two and the ground
  EXPECT_EQ(blocks.instances.size(), 10u);
  int mirrored = 0;
  for (const Instance& instance : blocks.instances) {
    mirrored += glm::determinant(glm::dmat3(instance.transform)) < 0.0;
  }
  EXPECT_EQ(mirrored, 2);
  EXPECT_TRUE(blocks.camera);
}

TEST(BuiltInScenes, EveryBuiltInSceneLoads) {
  for (const std::string& name : built_in_scenes()) {
    const Scene scene = load_scene(name);
    EXPECT_FALSE(scene.instances.empty()) << name;
    EXPECT_TRUE(scene.camera) << name;
  }
  EXPECT_GE(built_in_scenes().size(), 2u);
}

}  // namespace
}  // namespace dynrt::host
