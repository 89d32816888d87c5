// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/map.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "host/scene/camera.h"
#include "host/scene/load.h"
#include "host/scene/test_bsp.h"
#include "host/scene/test_files.h"
#include "host/scene/test_zip.h"

namespace dynrt::host {
namespace {

glm::dvec3 normal(const Mesh& mesh, std::size_t t) {
  const glm::uvec3& i = mesh.triangles[t];
  const glm::dvec3 &a = mesh.vertices[i.x], &b = mesh.vertices[i.y], &c = mesh.vertices[i.z];
  return glm::normalize(glm::cross(b - a, c - a));
}

TEST(Map, HasPolygonsPatchesAndMeshesButNeitherSkyNorHiddenFaces) {
  for (const int level : {1, 2, 6}) {
    const Scene scene = map_scene(small_map().bytes(), "m.bsp", {.tessellation = level});
    ASSERT_EQ(scene.objects.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 1u);
    const auto patch = static_cast<std::size_t>(2 * level * level);
    EXPECT_EQ(scene.objects[0].triangles.size(), 2 + patch + 1 + 1);
  }
}

TEST(Map, TurnsZUpIntoYUpWithFrontsCounterclockwise) {
  const Scene scene = map_scene(small_map().bytes(), "m.bsp");
  const Mesh& mesh = scene.objects[0];
  const Box box = bounds(scene);
  EXPECT_EQ(box.low, glm::dvec3(0, 0, -8));
  EXPECT_EQ(box.high, glm::dvec3(8, 64, 0));
  EXPECT_LT(glm::length(normal(mesh, 0) - glm::dvec3(0, 1, 0)), 1e-12);
  EXPECT_LT(glm::length(normal(mesh, 1) - glm::dvec3(0, 1, 0)), 1e-12);
}

// The patch is z = x (2 - x) over [0, 2] x [0, 2], its highest line at 1.
TEST(Map, PatchLiesOnItsSurface) {
  const Scene scene = map_scene(small_map().bytes(), "m.bsp", {.tessellation = 8});
  const Mesh& mesh = scene.objects[0];
  int seen = 0;
  for (std::size_t t = 2; t < 2 + 2 * 8 * 8; ++t) {
    for (int k = 0; k < 3; ++k, ++seen) {
      const glm::dvec3& v = mesh.vertices[mesh.triangles[t][k]];
      EXPECT_NEAR(v.y, v.x * (2 - v.x), 1e-12);
      EXPECT_TRUE(v.z >= -2 && v.z <= 0);
    }
    EXPECT_GT(normal(mesh, t).y, 0.1);
  }
  EXPECT_EQ(seen, 3 * 128);
}

TEST(Map, NeighbouringPatchesShareTheirBorder) {
  BspWriter map = small_map();
  const int first = 13;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 5; ++column) {
      map.vertex(0.1f * static_cast<float>(column), 0.3f * static_cast<float>(row),
                 0.7f * static_cast<float>(column % 2));
    }
  }
  map.face({.type = 2, .first_vertex = first, .vertices = 15, .width = 5, .height = 3});
  map.lumps[BspWriter::kModels].clear();
  map.model(7, 1);
  map.lumps[BspWriter::kEntities].clear();
  const Scene scene = map_scene(map.bytes(), "m.bsp", {.tessellation = 6});
  EXPECT_EQ(scene.objects[0].triangles.size(), 2u * 2 * 36);
  EXPECT_EQ(scene.objects[0].vertices.size(), 7u * 13);  // not 2 * 7 * 7
  EXPECT_FALSE(scene.camera);
}

TEST(Map, PlacesModelsWhereTheirEntityIs) {
  const Mesh mesh = map_scene(small_map().bytes(), "m.bsp", {.tessellation = 1}).objects[0];
  for (int k = 0; k < 3; ++k) EXPECT_EQ(mesh.vertices[mesh.triangles.back()[k]].y, 64.0);
  BspWriter map = small_map();
  map.lumps[BspWriter::kEntities] = R"({ "model" "*2" "origin" "0 0 1" })";
  EXPECT_EQ(user_error([&] { map_scene(map.bytes(), "m.bsp"); }),
            "m.bsp: an entity places the model '*2' at '0 0 1'; the model must be one of the map's "
            "2, written as '*' and its number, and the place must be three numbers");
}

TEST(Map, CameraIsAPlayersEye) {
  const auto camera = map_scene(small_map().bytes(), "m.bsp").camera;
  ASSERT_TRUE(camera);
  EXPECT_EQ(camera->position, glm::dvec3(1, 3 + 26, -2));
  EXPECT_LT(glm::length(camera->forward - glm::dvec3(0, 0, -1)), 1e-12);
}

TEST(Map, ColoursAreTheTexturesTimesTheBakedLight) {
  MapOptions options;
  options.tessellation = 1;
  options.colour = [](const std::string& texture) {
    return texture == "textures/stone" ? glm::dvec3(1, 0.5, 0) : glm::dvec3(0, 0.5, 1);
  };
  const auto colours = [&] {
    const Scene scene = map_scene(small_map().bytes(), "m.bsp", options);
    std::vector<glm::dvec3> of;
    for (const std::uint32_t m : scene.objects[0].material)
      of.push_back(scene.materials[m].diffuse);
    return of;
  };
  const auto eighth = [](int r, int g, int b) { return glm::dvec3(r, g, b) / 255.0; };
  // Lightmap 32, times 4: 128 of 255. Vertex colours 64 and 255, times 4: full light.
  std::vector<glm::dvec3> lit = colours();
  ASSERT_EQ(lit.size(), 6u);
  EXPECT_EQ(lit[0], eighth(128, 64, 0));
  EXPECT_EQ(lit[2], eighth(0, 128, 255));
  EXPECT_EQ(lit[4], eighth(0, 128, 255));
  options.baked_light = false;
  EXPECT_EQ(colours()[0], eighth(255, 128, 0));
}

TEST(Map, ComesFromABspFileOrAPackage) {
  const TestFolder folder;
  const std::string bytes = small_map().bytes();
  EXPECT_EQ(load_scene(folder.write("m.bsp", bytes)).name, "m");
  const std::string one = folder.path("one.pk3"), two = folder.path("two.pk3");
  write_zip(one, {{"maps/a.bsp", bytes}, {"textures/t.txt", "x"}});
  write_zip(two, {{"maps/a.bsp", bytes}, {"maps/b.bsp", bytes}});
  EXPECT_EQ(load_scene(one).name, "a");
  EXPECT_EQ(load_scene(two + ":b").name, "b");
  EXPECT_EQ(
      user_error([&] { load_scene(two); }),
      two + ": the file holds 2 maps; name one of them, such as " + two + ":a (the maps are a, b)");
  EXPECT_EQ(user_error([&] { load_scene(two + ":c"); }),
            two + ": the file has no map 'c'; its maps are a, b");
  const std::string none = folder.path("none.pk3");
  write_zip(none, {{"textures/t.txt", "x"}});
  EXPECT_EQ(user_error([&] { load_scene(none); }),
            none + ": the file holds no map (maps/NAME.bsp)");
  const std::string text = folder.write("text.pk3", "no zip");
  EXPECT_EQ(
      user_error([&] { load_scene(text); }),
      text + ": cannot read this zip library (Not a zip archive); a .pk3 file must be a zip file");
  write_zip(one, {{"maps/a.bsp", bytes.substr(0, 100)}});
  EXPECT_EQ(
      user_error([&] { load_scene(one); }),
      one +
          ":maps/a.bsp: the map has 100 bytes, fewer than the 144 of its header; it seems cut off");
}

TEST(Map, WithoutTrianglesIsRefused) {
  BspWriter map = small_map();
  map.lumps[BspWriter::kModels].clear();
  map.lumps[BspWriter::kEntities].clear();
  EXPECT_EQ(user_error([&] { map_scene(map.bytes(), "m.bsp"); }),
            "m.bsp: the scene has no triangles (0 of zero area, 0 points and lines left out)");
}

TEST(Map, NamesThePackageThatIsMissing) {
  EXPECT_EQ(user_error([] { load_package_map("oa_dm5", {}, "/nowhere/pak1-maps.pk3"); }),
            "the map of this scene comes from the Debian package openarena-081-maps, which is not "
            "installed (/nowhere/pak1-maps.pk3 is missing); install it with: apt-get install "
            "openarena-081-maps");
}

}  // namespace
}  // namespace dynrt::host
