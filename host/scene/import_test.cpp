// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/import.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "host/scene/camera.h"
#include "host/scene/load.h"
#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

double area(const Scene& scene, std::uint32_t object) {
  const Mesh& mesh = scene.objects[object];
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3& a = mesh.vertices[t.x];
    sum += glm::length(glm::cross(mesh.vertices[t.y] - a, mesh.vertices[t.z] - a)) / 2.0;
  }
  return sum;
}

std::string load_error(const std::string& path) {
  return user_error([&] { load_scene(path); });
}

TEST(Import, ObjIsOneObjectWithColoursPerTriangle) {
  const Scene scene = load_scene(test_data("cube.obj"));
  EXPECT_EQ(scene.name, "cube");
  ASSERT_EQ(scene.objects.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.instances[0].transform, glm::dmat4(1.0));
  const Mesh& cube = scene.objects[0];
  EXPECT_EQ(cube.vertices.size(), 9u);
  EXPECT_EQ(cube.triangles.size(), 14u);
  EXPECT_NEAR(area(scene, 0), 6.0, 1e-6);  // the concave side is cut up without overlap
  EXPECT_EQ(scene.dropped.points_and_lines, 1u);
  EXPECT_EQ(scene.dropped.zero_area_triangles, 0u);
  EXPECT_FALSE(scene.camera);
  EXPECT_TRUE(scene.notes.empty());
  int red = 0, blue = 0;
  for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
    const glm::dvec3& colour = scene.materials[cube.material[t]].diffuse;
    red += glm::length(colour - glm::dvec3(0.8, 0.1, 0.1)) < 1e-6;
    blue += glm::length(colour - glm::dvec3(0.1, 0.2, 0.9)) < 1e-6;
  }
  EXPECT_EQ(red, 8);
  EXPECT_EQ(blue, 6);
}

TEST(Import, PlyIsOneObject) {
  const Scene scene = load_scene(test_data("tetrahedron.ply"));
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.objects[0].vertices.size(), 4u);
  EXPECT_EQ(scene.objects[0].triangles.size(), 4u);
  EXPECT_NEAR(area(scene, 0), 1.5 + std::sqrt(3.0) / 2.0, 1e-6);
}

TEST(Import, GltfKeepsInstancesAndCamera) {
  const Scene scene = load_scene(test_data("instances.gltf"));
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].name, "tetrahedron");
  EXPECT_EQ(scene.objects[0].triangles.size(), 4u);  // of both primitives
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[0].name, "first");
  EXPECT_EQ(scene.instances[1].name, "mirrored child");
  EXPECT_EQ(scene.instances[1].object, 0u);
  const glm::dvec4 corner = scene.instances[1].transform * glm::dvec4(1, 2, 3, 1);
  EXPECT_EQ(corner, glm::dvec4(8, 2, 3, 1));  // scaled by -2, then moved by the parent
  const Mesh& mesh = scene.objects[0];
  EXPECT_NEAR(scene.materials[mesh.material[0]].diffuse.r, 0.9, 1e-6);
  EXPECT_NEAR(scene.materials[mesh.material[3]].diffuse.r, 0.2, 1e-6);

  ASSERT_TRUE(scene.camera);
  EXPECT_EQ(scene.camera->position, glm::dvec3(0, 0, 5));
  EXPECT_NEAR(scene.camera->forward.z, -1.0, 1e-6);
  EXPECT_NEAR(scene.camera->up.y, 1.0, 1e-6);  // yfov = 2 atan(1/2)
  EXPECT_NEAR(choose_camera(scene, {}, 300, 200).right.x, 1.5, 1e-6);
}

TEST(Import, NotesAMissingMaterialFile) {
  const TestFolder folder;
  const std::string path = folder.write("lone.obj", read_file(test_data("cube.obj")));
  const Scene scene = load_scene(path);
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0],
            path + ": there is no material file 'cube.mtl', so its materials are grey");
}

TEST(Import, DropsAndCountsZeroArea) {
  const TestFolder folder;
  const std::string path =
      folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n");
  const Scene scene = load_scene(path);
  EXPECT_EQ(scene.objects[0].triangles.size(), 1u);
  EXPECT_EQ(scene.dropped.zero_area_triangles, 2u);
}

TEST(Import, RefusesAFileWithoutTriangles) {
  const TestFolder folder;
  const std::string flat =
      folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nl 1 2\np 1\np 2\n");
  EXPECT_EQ(load_error(flat),
            flat + ": the scene has no triangles (1 of zero area, 3 points and lines left out)");
  const std::string points = folder.write("points.obj", "# only points\nv 0 0 0\nv 1 1 1\n");
  EXPECT_EQ(load_error(points),
            points + ": the scene has no triangles (0 of zero area, 0 points and lines left out)");
}

TEST(Import, RefusesWhatIsNoSceneFile) {
  const TestFolder folder;
  EXPECT_EQ(load_error(folder.path("gone.obj")),
            "there is no scene '" + folder.path("gone.obj") +
                "': give a built-in name (blocks, cistern, conference, lamps, office, trees4000, "
                "unit_objects) or the path of a file");
  for (const char* name : {"e.obj", "e.ply", "e.gltf", "e.glb", "e.json"}) {
    const std::string path = folder.write(name, "");
    EXPECT_EQ(load_error(path), path + ": the file is empty");
  }
  const std::string letter = folder.write("a.doc", "Dear reader\n");
  EXPECT_EQ(load_error(letter).find(letter +
                                    ": dynrt does not read files with the extension '.doc'; it "
                                    "reads .json, .bsp and .pk3, and through Assimp .3d, .3ds, "),
            0u);
  std::filesystem::create_directory(folder.path("d.obj"));
  EXPECT_EQ(
      load_error(folder.path("d.obj")),
      folder.path("d.obj") +
          ": this is a folder, but a scene is a file; give the path of a file in it, such as " +
          folder.path("d.obj") + "/model.obj");
  const std::string short_obj = folder.write("s.obj", "v 1 2 3\n");
  EXPECT_EQ(load_error(short_obj), short_obj + ": not a valid OBJ file: OBJ-file is too small");
}

TEST(Import, RefusesAFaceWithoutVertices) {
  const TestFolder folder;
  const std::string path =
      folder.write("a.ply", replaced(read_file(test_data("tetrahedron.ply")), "3 0 1 3", "0"));
  EXPECT_EQ(load_error(path), path + ": mesh '', face 1: the face has no vertices; it needs three");
}

TEST(Import, RefusesAFaceWhoseVertexIsMissing) {
  const TestFolder folder;
  const std::string text = read_file(test_data("tetrahedron.ply"));
  for (const char* face : {"3 0 1 4", "3 0 1 -1"}) {
    const std::string path = folder.write("a.ply", replaced(text, "3 0 1 3", face));
    const std::string index = std::string(face).ends_with("4") ? "4" : "4294967295";
    EXPECT_EQ(load_error(path), path + ": mesh '', face 1: the face uses vertex " + index +
                                    ", but the mesh has 4 vertices");
  }
}

TEST(Import, RefusesAVertexThatIsNotFinite) {
  const TestFolder folder;
  const std::string path = folder.write("a.obj", "v 0 nan 1\nv 0 0 0\nv 1 0 0\nf 1 2 3\n");
  EXPECT_EQ(load_error(path),
            path + ": mesh 'defaultobject', vertex 0: the position (0, nan, 1) is not finite");
}

TEST(Import, SaysWhyAFileCannotBeRead) {
  EXPECT_EQ(user_error([] { read_file("/no/such/file"); }),
            "/no/such/file: cannot read this file (No such file or directory)");
}

// testdata/instances.gltf with something changed, its binary file beside it.
class GltfError : public testing::Test {
 protected:
  std::string error(std::string_view what, std::string_view with) {
    folder_.write("instances.bin", binary_);
    const std::string text = read_file(test_data("instances.gltf"));
    return load_error(folder_.write("a.gltf", replaced(text, what, with))).substr(path_.size());
  }

  const TestFolder folder_;
  const std::string path_ = folder_.path("a.gltf");
  std::string binary_ = read_file(test_data("instances.bin"));
};

TEST_F(GltfError, NamesTheVertexThatIsNotFinite) {
  const std::array<float, 2> bad = {NAN, INFINITY};
  binary_.replace(2 * 12 + 4, 8, reinterpret_cast<const char*>(bad.data()), 8);
  EXPECT_EQ(error("\"first\"", "\"first\""),
            ": mesh 'tetrahedron-0', vertex 2: the position (0, nan, inf) is not finite");
}

TEST_F(GltfError, RefusesFacesWhoseVertexIsMissing) {
  binary_[48 + 2 * 4] = 77;
  EXPECT_EQ(error("\"first\"", "\"first\""),
            ": some faces use vertices that their mesh does not have");
}

TEST_F(GltfError, NamesTheNodeWithoutInverse) {
  const std::string tail =
      "its transform has no inverse; its three axes must not be zero and must not lie in one plane";
  EXPECT_EQ(error("[-2, 1, 1]", "[1, 0, 1]"), ": node 'mirrored child': " + tail);
  EXPECT_EQ(error("\"scale\": [-2, 1, 1]",
                  "\"matrix\": [1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1]"),
            ": node 'mirrored child': " + tail);
  EXPECT_EQ(error("\"scale\": [-2, 1, 1]",
                  "\"matrix\": [1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]"),
            ": node 'mirrored child': its transform is not affine; the last row must be 0 0 0 1, "
            "and all numbers must be finite");
}

TEST_F(GltfError, NamesTheCameraThatCannotLook) {
  EXPECT_EQ(error("\"camera\": 0,", "\"camera\": 0, \"scale\": [1, 0, 1],"),
            ": node 'eye': the camera's up direction (0, 0, 0) is parallel to its view; give "
            "another one");
}

TEST_F(GltfError, PassesOnWhatAssimpRejects) {
  EXPECT_EQ(error("instances.bin", "elsewhere.bin"),
            ": not a valid glTF file: GLTF: could not open referenced file \"elsewhere.bin\"");
  EXPECT_EQ(error("\"scene\": 0", "\"scene\": 0,,"),
            ":5: not valid JSON: syntax error while parsing object key - unexpected ','; expected "
            "string literal");
}

TEST_F(GltfError, NotesAnOrthographicCamera) {
  folder_.write("instances.bin", binary_);
  std::string text = read_file(test_data("instances.gltf"));
  text = replaced(text, "\"type\": \"perspective\"", "\"type\": \"orthographic\"");
  text = replaced(text, "\"perspective\": {",
                  "\"orthographic\": {\"xmag\": 1, \"ymag\": 1, \"zfar\": 9, ");
  const Scene scene = load_scene(folder_.write("a.gltf", text));
  EXPECT_FALSE(scene.camera);
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0],
            path_ + ": camera 'eye' is not a perspective camera, so dynrt leaves it out");
}

// Wherever a file is cut off (300 places of a longer one), it loads or is refused with a sentence:
// nothing else.
TEST(Import, SurvivesEveryTruncation) {
  const TestFolder folder;
  folder.write("instances.bin", read_file(test_data("instances.bin")));
  for (const char* name : {"cube.obj", "tetrahedron.ply", "instances.gltf", "instances.bin"}) {
    const std::string whole = read_file(test_data(name));
    const bool is_data = std::string(name) == "instances.bin";
    const std::string scene = is_data
                                  ? folder.write("a.gltf", read_file(test_data("instances.gltf")))
                                  : folder.path(name);
    const std::size_t stride = 1 + whole.size() / 300;
    std::size_t refused = 0;
    for (std::size_t size = 0; size < whole.size(); size += stride) {
      folder.write(name, std::string_view(whole).substr(0, size));
      try {
        const Scene loaded = load_scene(scene);
        EXPECT_FALSE(loaded.instances.empty());
      } catch (const UserError& error) {
        EXPECT_GT(std::string(error.what()).size(), 10u);
        ++refused;
      }
    }
    folder.write(name, whole);
    EXPECT_NO_THROW(load_scene(scene));
    EXPECT_GT(refused, whole.size() / stride / 2) << name;
  }
}

}  // namespace
}  // namespace dynrt::host
