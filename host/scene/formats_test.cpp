// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One file of each of several formats; import_test.cpp tests OBJ, PLY and glTF. All hold the
// tetrahedron of the origin and the three unit vectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <initializer_list>
#include <span>
#include <vector>

#include "host/scene/import.h"
#include "host/scene/load.h"
#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

constexpr float kCorners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr std::uint16_t kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

/// The bytes of a number, the lowest first.
template <typename Number>
std::string bytes(Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  return {raw.begin(), raw.end()};
}

std::string bytes(std::span<const float> numbers) {
  std::string all;
  for (const float number : numbers) all += bytes(number);
  return all;
}

void expect_tetrahedron(const Scene& scene) {
  ASSERT_EQ(scene.objects.size(), 1u);
  const Mesh& mesh = scene.objects[0];
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  for (const auto& corner : kCorners) {
    const glm::dvec3 wanted(corner[0], corner[1], corner[2]);
    const bool there = std::ranges::any_of(
        mesh.vertices, [&](const glm::dvec3& v) { return glm::length(v - wanted) < 1e-6; });
    EXPECT_TRUE(there) << wanted.x << ' ' << wanted.y << ' ' << wanted.z;
  }
}

void expect_one_mesh(const std::string& path) {
  SCOPED_TRACE(path);
  const Scene scene = load_scene(path);
  expect_tetrahedron(scene);
  ASSERT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.instances[0].transform, glm::dmat4(1.0));
  EXPECT_TRUE(scene.notes.empty());
}

/// One at the origin, one twice as large at x = 5, both red.
void expect_two_instances(const Scene& scene) {
  expect_tetrahedron(scene);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[0].name, "first");
  EXPECT_EQ(scene.instances[1].name, "second");
  const auto top = [&](std::size_t i) {
    return glm::dvec3(scene.instances[i].transform * glm::dvec4(0, 0, 1, 1));
  };
  EXPECT_LT(glm::length(top(0) - glm::dvec3(0, 0, 1)), 1e-6);
  EXPECT_LT(glm::length(top(1) - glm::dvec3(5, 0, 2)), 1e-6);
  const Material& material = scene.materials.at(scene.objects[0].material[0]);
  EXPECT_LT(glm::length(material.diffuse - glm::dvec3(0.9, 0.2, 0.1)), 1e-6);
}

TEST(Formats, Off) { expect_one_mesh(test_data("tetrahedron.off")); }

TEST(Formats, StlInText) { expect_one_mesh(test_data("tetrahedron.stl")); }

TEST(Formats, StlInBytes) {
  std::string text(80, ' ');
  text += bytes(std::uint32_t{4});
  for (const auto& face : kFaces) {
    text += std::string(12, '\0');  // the normal, which we do not use
    for (const std::uint16_t corner : face) text += bytes(std::span<const float>(kCorners[corner]));
    text += std::string(2, '\0');
  }
  const TestFolder folder;
  expect_one_mesh(folder.write("a.stl", text));
  const std::string cut = folder.write("b.stl", text.substr(0, 150));
  EXPECT_EQ(
      user_error([&] { load_scene(cut); }),
      cut + ": not a valid STL file: Failed to determine STL storage representation for " + cut);
}

TEST(Formats, Collada) {
  const Scene scene = load_scene(test_data("instances.dae"));
  expect_two_instances(scene);
  ASSERT_TRUE(scene.camera);
  EXPECT_LT(glm::length(scene.camera->position - glm::dvec3(1, 2, 9)), 1e-6);
  EXPECT_LT(glm::length(scene.camera->forward - glm::dvec3(0, 0, -1)), 1e-6);
  const double up = 2 * std::tan(glm::radians(20.0));  // yfov is 40 degrees
  EXPECT_LT(glm::length(scene.camera->up - glm::dvec3(0, up, 0)), 1e-6);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_LT(glm::length(scene.lights[0].position - glm::dvec3(3, 4, 5)), 1e-6);
  EXPECT_LT(glm::length(scene.lights[0].colour - glm::dvec3(1, 0.5, 0.25)), 1e-6);
}

TEST(Formats, ColladaCameraWithoutAName) {
  const TestFolder folder;
  const std::string text =
      replaced(read_file(test_data("instances.dae")), "id=\"eye\" name=\"eye\"", "id=\"eye\"");
  const Scene scene = load_scene(folder.write("a.dae", text));
  EXPECT_NEAR(glm::length(scene.camera.value().up), 2 * std::tan(glm::radians(22.5)), 1e-6);
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(
      scene.notes[0],
      folder.path("a.dae") +
          ": camera 'eye-node' has no name, so dynrt cannot read its angle and takes 45 degrees");
}

TEST(Formats, ColladaWithZUp) {
  const TestFolder folder;
  const std::string text = replaced(read_file(test_data("instances.dae")), "Y_UP", "Z_UP");
  const Scene scene = load_scene(folder.write("a.dae", text));
  const glm::dvec3 top(scene.instances.at(0).transform * glm::dvec4(0, 0, 1, 1));
  EXPECT_LT(glm::length(top - glm::dvec3(0, 1, 0)), 1e-6);
}

TEST(Formats, Fbx) { expect_two_instances(load_scene(test_data("instances.fbx"))); }

/// A chunk of a 3DS file: its kind, its length with these six bytes, its content.
std::string chunk(std::uint16_t kind, std::initializer_list<std::string> parts) {
  std::string content;
  for (const std::string& part : parts) content += part;
  return bytes(kind) + bytes(static_cast<std::uint32_t>(content.size() + 6)) + content;
}

TEST(Formats, ThreeDs) {
  const std::string zero(1, '\0');
  std::string vertices = bytes(std::uint16_t{4}), faces = bytes(std::uint16_t{4});
  std::string red = "red" + zero + bytes(std::uint16_t{4});
  for (const auto& corner : kCorners) vertices += bytes(std::span<const float>(corner));
  for (std::uint16_t f = 0; f < 4; ++f) {
    for (const std::uint16_t corner : kFaces[f]) faces += bytes(corner);
    faces += bytes(std::uint16_t{7});  // all edges are seen
    red += bytes(f);
  }
  const float colour[] = {0.9f, 0.2f, 0.1f};
  const std::string material =
      chunk(0xAFFF, {chunk(0xA000, {"red" + zero}),
                     chunk(0xA020, {chunk(0x0010, {bytes(std::span<const float>(colour))})})});
  const std::string mesh =
      chunk(0x4000, {"body" + zero, chunk(0x4100, {chunk(0x4110, {vertices}),
                                                   chunk(0x4120, {faces, chunk(0x4130, {red})})})});
  const TestFolder folder;
  const std::string path = folder.write("a.3ds", chunk(0x4D4D, {chunk(0x3D3D, {material, mesh})}));
  const Scene scene = load_scene(path);
  expect_tetrahedron(scene);
  ASSERT_EQ(scene.instances.size(), 1u);
  const Material& painted = scene.materials.at(scene.objects[0].material[0]);
  EXPECT_LT(glm::length(painted.diffuse - glm::dvec3(0.9, 0.2, 0.1)), 1e-6);
}

TEST(Formats, ObjInUtf16) {
  const std::string ascii = read_file(test_data("cube.obj"));
  for (const bool big_endian : {false, true}) {
    std::string text = big_endian ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : ascii) text += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
    const TestFolder folder;
    folder.write("cube.mtl", read_file(test_data("cube.mtl")));
    const Scene scene = load_scene(folder.write("cube.obj", text));
    const Scene plain = load_scene(test_data("cube.obj"));
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].vertices, plain.objects[0].vertices);
    EXPECT_EQ(scene.objects[0].material, plain.objects[0].material);
    EXPECT_TRUE(scene.notes.empty());
  }
}

/// Assimp skips a newline that it finds there.
TEST(Formats, PlyWhoseDataBeginWithAnyByte) {
  const TestFolder folder;
  for (const std::string line : {"\n", "\r\n"}) {
    for (int first = 0; first < 256; ++first) {
      std::string text;
      for (const char* header :
           {"ply", "format binary_little_endian 1.0", "element vertex 3", "property float x",
            "property float y", "property float z", "element face 1",
            "property list uchar int vertex_indices", "end_header"}) {
        text += header + line;
      }
      const float x = std::bit_cast<float>(0x3F800000u + 0x101u * static_cast<unsigned>(first));
      const float numbers[] = {x, 0, 0, 2, 0, 0, 0, 2, 0};
      text += bytes(std::span<const float>(numbers)) + '\3';
      for (std::uint32_t corner = 0; corner < 3; ++corner) text += bytes(corner);
      const Scene scene = load_scene(folder.write("a.ply", text));
      ASSERT_EQ(scene.objects[0].vertices.size(), 3u) << first;
      EXPECT_EQ(scene.objects[0].vertices[0], glm::dvec3(double{x}, 0, 0)) << first;
      EXPECT_EQ(scene.objects[0].vertices[2], glm::dvec3(0, 2, 0)) << first;
    }
  }
}

TEST(Formats, AreThoseOfAssimp) {
  const std::vector<std::string> extensions = assimp_extensions();
  EXPECT_GT(extensions.size(), 40u);
  for (const char* expected :
       {".3ds", ".blend", ".dae", ".fbx", ".glb", ".gltf", ".obj", ".off", ".ply", ".stl", ".x"}) {
    EXPECT_TRUE(std::ranges::binary_search(extensions, expected)) << expected;
  }
  // Its importer does not end on a file that is cut off.
  EXPECT_FALSE(std::ranges::binary_search(extensions, std::string(".ogex")));
}

TEST(Formats, TakeExtensionsInCapitals) {
  const TestFolder folder;
  expect_one_mesh(folder.write("A.OFF", read_file(test_data("tetrahedron.off"))));
  expect_one_mesh(folder.write("A.PLY", read_file(test_data("tetrahedron.ply"))));
}

/// A file of each format that holds another: a sentence, whatever Assimp makes of it.
TEST(Formats, RefuseOtherContent) {
  const TestFolder folder;
  for (const std::string& extension : assimp_extensions()) {
    if (extension == ".bsp" || extension == ".pk3") continue;  // ours
    const std::string path = folder.write("a" + extension, "This is a letter, not a scene.\n");
    try {
      EXPECT_FALSE(load_scene(path).instances.empty()) << extension;
    } catch (const UserError& error) {
      EXPECT_EQ(std::string(error.what()).find(path), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace dynrt::host
