// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/description.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "host/scene/animation.h"
#include "host/scene/camera.h"
#include "host/scene/load.h"
#include "host/scene/test_bsp.h"
#include "host/scene/test_files.h"
#include "host/scene/test_zip.h"

namespace dynrt::host {
namespace {

constexpr char kScattered[] = R"({"objects": [
    {"name": "o", "parts": [{"generate": "box", "from": [-1, 0, -1], "to": [1, 2, 1], "colour": [1, 1, 1]}]},
    {"name": "g", "parts": [{"generate": "hills", "side": 100, "height": 0, "cells": 2, "colour": [1, 1, 1], "position": [0, 3, 0]}]}],
    "instances": [{"object": "g"}],
    "scatter": [{"object": "o", "count": 30, "seed": 1, "from": [-40, -40], "to": [40, 40], "apart": 3, "scale": [1, 2], "clear": [[0, 0, 10]], "ground": "g"}]})";

TEST(Description, Scatters) {
  const TestFolder folder;
  const Scene scene = load_scene(folder.write("s.json", kScattered));
  ASSERT_EQ(scene.instances.size(), 31u);
  EXPECT_EQ(scene.instances[1].name, "o 1");
  for (std::size_t i = 1; i < 31; ++i) {
    const glm::dvec3 at(scene.instances[i].transform[3]);
    EXPECT_EQ(at.y, 3.0);
    EXPECT_GE(glm::length(at - glm::dvec3(0, 3, 0)), 10.0);
  }
}

TEST(Description, NamesMistakesInAScatter) {
  const TestFolder folder;
  const auto error = [&](const char* what, const char* with) {
    const std::string path = folder.write("s.json", replaced(kScattered, what, with));
    return user_error([&] { load_scene(path); }).substr(path.size());
  };
  EXPECT_EQ(error("\"apart\": 3", "\"apart\": 50"),
            ": scatter[0]: there is room for only 3 of 30 instances of 'o'; scatter fewer, closer "
            "together or over a larger area");
  EXPECT_EQ(error("\"to\": [40, 40]", "\"to\": [40, -40]"),
            ": scatter[0]: 'from' must be below 'to' on both axes");
  EXPECT_EQ(error("[1, 2], \"clear\"", "[0, 2], \"clear\""),
            ": scatter[0]: 'scale' must be two numbers above zero, the lower one first");
  EXPECT_EQ(error("[[0, 0, 10]]", "[[0, 0]]"),
            ": scatter[0]: 'clear' must be a list of lists of 3 numbers");
  EXPECT_EQ(error("\"ground\": \"g\"", "\"ground\": \"h\""),
            ": scatter[0]: there is no object 'h'");
  EXPECT_EQ(error("\"count\": 30", "\"count\": 0"),
            ": scatter[0]: 'count' must be a whole number from 1 to 131072");
  EXPECT_EQ(error("\"cells\": 2", "\"cells\": 251"),
            ": objects[1].parts[0]: 'cells' must be a whole number from 1 to 250");
}

TEST(Description, NamesMapsAndTexturesThatAreNotThere) {
  const TestFolder folder;
  const std::string pk3 = folder.path("own.pk3");
  write_zip(pk3, {{"maps/a.bsp", small_map().bytes()}});
  const auto load = [&](const std::string& part) {
    const std::string path =
        folder.write("m.json", R"({"objects": [{"name": "o", "parts": [{)" + part + R"(}]}]})");
    return load_description(path, {.maps = pk3});
  };
  const auto error = [&](const std::string& part) {
    return user_error([&] { load(part); }).substr(folder.path("m.json").size());
  };
  const Scene scene = load(
      R"("map": "a", "scale": 0.5, "baked_light": false, "tessellation": 2, "position": [0, 1, 0],
         "colours": {"textures/moss": [0, 0.8, 0]})");
  EXPECT_EQ(bounds(scene).low, glm::dvec3(0, 1, -4));
  EXPECT_EQ(scene.objects[0].triangles.size(), 2u + 8 + 1 + 1);
  EXPECT_EQ(scene.materials.back().name, "a/textures/moss");
  EXPECT_EQ(scene.materials.back().diffuse, glm::dvec3(0, 0.8, 0));
  EXPECT_EQ(user_error([&] { load(R"("map": "b")"); }),
            pk3 + ": the file has no map 'b'; its maps are a");
  EXPECT_EQ(error(R"("map": "a", "colours": {"textures/mos": [0, 1, 0]})"),
            ": objects[0].parts[0].colours: the map has no texture 'textures/mos'; its textures "
            "are textures/moss, textures/stone");
  EXPECT_EQ(error(R"("map": "a", "baked_light": 1)"),
            ": objects[0].parts[0]: 'baked_light' must be true or false");
  EXPECT_EQ(error(R"("map": "a", "tessellation": 33)"),
            ": objects[0].parts[0]: 'tessellation' must be a whole number from 1 to 32");
}

constexpr char kSmall[] = R"({
  "colours": {"green": [0, 1, 0]},
  "objects": [
    {"name": "b", "parts": [{"generate": "box", "from": [0, 0, 0], "to": [1, 1, 1], "colour": "green", "position": [5, 0, 0], "turn": 90}]}
  ],
  "instances": [
    {"object": "b", "position": [0, 10, 0], "rotate": {"axis": [0, 0, 2], "degrees": 90}, "scale": [2, 1, 1]},
    {"object": "b", "name": "turned", "position": [0, 1, 0], "turn": 90},
    {"object": "b", "name": "given", "matrix": [1, 0.5, 0, 7, 0, 1, 0, 8, 0, 0, 1, 9]}
  ],
  "camera": {"position": [0, 0, 9], "look_at": [0, 0, 0]}
})";

TEST(Description, PlacesPartsAndInstances) {
  const TestFolder folder;
  const Scene scene = load_scene(folder.write("small.json", kSmall));
  EXPECT_EQ(scene.name, "small");
  EXPECT_EQ(scene.materials[0].name, "box");
  EXPECT_EQ(scene.materials[0].diffuse, glm::dvec3(0, 1, 0));
  // A quarter turn brings +z to +x and +x to -z.
  glm::dvec3 low(9), high(-9);
  for (const glm::dvec3& v : scene.objects[0].vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  EXPECT_LT(glm::length(low - glm::dvec3(5, 0, -1)), 1e-12);
  EXPECT_LT(glm::length(high - glm::dvec3(6, 1, 0)), 1e-12);
  EXPECT_EQ(scene.instances[0].name, "b#0");
  const glm::dvec3 p(scene.instances[0].transform * glm::dvec4(1, 1, 1, 1));
  EXPECT_LT(glm::length(p - glm::dvec3(-1, 12, 1)), 1e-12);
  const glm::dvec3 q(scene.instances[1].transform * glm::dvec4(0, 0, 1, 1));
  EXPECT_LT(glm::length(q - glm::dvec3(1, 1, 0)), 1e-12);
  EXPECT_EQ(scene.instances[2].name, "given");
  EXPECT_EQ(scene.instances[2].transform * glm::dvec4(0, 2, 0, 1), glm::dvec4(8, 10, 9, 1));
}

TEST(Description, PlacesPrimitives) {
  const TestFolder folder;
  const Scene scene = load_scene(folder.write("p.json", R"({"objects": [{"name": "o", "parts": [
    {"primitive": "sphere", "radii": [1, 2, 3], "colour": [1, 0, 0], "position": [5, 0, 0],
     "turn": 90},
    {"generate": "box", "from": [0, 0, 0], "to": [1, 1, 1], "colour": [0, 1, 0]},
    {"primitive": "rectangle", "corner": [1, 0, 0], "across": [0, 0, 2], "along": [0, 3, 0],
     "colour": [0, 0, 1], "mirror": true, "position": [0, 10, 0], "turn": 90}]}],
    "instances": [{"object": "o", "position": [0, 0, -20]}]})"));
  const Mesh& mesh = scene.objects.at(0);
  ASSERT_EQ(mesh.triangles.size(), 12u);
  ASSERT_EQ(mesh.primitives(), 14u) << "triangles come first, then rectangles, then ellipsoids";
  const auto expect_near = [](const glm::dvec3& got, const glm::dvec3& expected) {
    EXPECT_LT(glm::length(got - expected), 1e-12) << got.x << ' ' << got.y << ' ' << got.z;
  };
  ASSERT_TRUE(mesh.is_rectangle(12));
  EXPECT_EQ(scene.materials[mesh.material_of(12)].diffuse, glm::dvec3(0, 0, 1));
  EXPECT_TRUE(scene.materials[mesh.material_of(12)].mirror);
  // A quarter turn takes z to x and x to -z.
  const std::array<glm::dvec3, 4> corners = mesh.rectangle(12).corners();
  expect_near(corners[0], {0, 10, -1});
  expect_near(corners[1], {2, 10, -1});
  expect_near(corners[2], {2, 13, -1});
  expect_near(corners[3], {0, 13, -1});
  expect_near(mesh.corners(12)[2], corners[0]);
  ASSERT_TRUE(mesh.is_ellipsoid(13));
  EXPECT_EQ(scene.materials[mesh.material_of(13)].diffuse, glm::dvec3(1, 0, 0));
  const Ellipsoid& ellipsoid = mesh.ellipsoid(13);
  expect_near(ellipsoid.extent(), {3, 2, 1});
  expect_near(ellipsoid.from_unit * glm::dvec4(0, 0, 1, 1), {8, 0, 0});
  const Box box = bounds(scene);
  expect_near(box.low, {0, -2, -21});
  expect_near(box.high, {8, 13, -19});
}

TEST(Description, NamesMistakesInPrimitives) {
  const TestFolder folder;
  const auto expect_error = [&](const std::string& part, const std::string& sentence) {
    const std::string path =
        folder.write("p.json", R"({"objects": [{"name": "o", "parts": [{"colour": [1, 0, 0], )" +
                                   part + "}]}]}");
    try {
      load_scene(path);
      ADD_FAILURE() << "no error: " << part;
    } catch (const UserError& error) {
      EXPECT_EQ(error.what(), path + ": objects[0].parts[0]: " + sentence);
    }
  };
  expect_error(R"("primitive": "cone")",
               "'cone' is not a primitive; the primitives are sphere and rectangle");
  expect_error(R"("primitive": "sphere")", "a sphere has either a 'radius' or three 'radii'");
  expect_error(R"("primitive": "sphere", "radius": 1, "radii": [1, 1, 1])",
               "a sphere has either a 'radius' or three 'radii'");
  expect_error(R"("primitive": "sphere", "radii": [1, 0, 1])",
               "'radii' must be three numbers above zero");
  expect_error(R"("primitive": "sphere", "radius": 1, "mirror": true)",
               "a sphere that is a primitive cannot be a 'mirror', as each of its points would "
               "reflect in another direction; generate a sphere of triangles");
  expect_error(
      R"("primitive": "rectangle", "corner": [0, 0, 0], "across": [1, 1, 0], "along": [2, 2, 0])",
      "'across' and 'along' must not be zero and must not lie on one line");
}

TEST(Description, OneInstanceOfEachObjectUnlessSaidOtherwise) {
  const TestFolder folder;
  const Scene scene = load_scene(folder.write("a.json", R"({"objects": [
    {"name": "s", "parts": [{"generate": "sphere", "radius": 1, "subdivisions": 1, "colour": [1, 1, 1]}]},
    {"name": "t", "parts": [{"generate": "torus", "major_radius": 2, "minor_radius": 1,
                             "segments": 8, "sides": 4, "colour": [1, 1, 1]}]}]})"));
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.objects[scene.instances[0].object].triangles.size(), 80u);
  EXPECT_EQ(scene.objects[scene.instances[1].object].triangles.size(), 64u);
}

struct Mistake {
  const char* what;
  const char* with;
  const char* sentence;  // behind the path
};

class DescriptionMistake : public testing::TestWithParam<Mistake> {};

TEST_P(DescriptionMistake, IsNamed) {
  const TestFolder folder;
  const Mistake& mistake = GetParam();
  const std::string path = folder.write("m.json", replaced(kSmall, mistake.what, mistake.with));
  EXPECT_EQ(user_error([&] { load_scene(path); }), path + mistake.sentence);
}

INSTANTIATE_TEST_SUITE_P(
    All, DescriptionMistake,
    testing::Values(
        Mistake{"[0, 1, 0]}", "[0, 1, 0]},,",
                ":2: not valid JSON: syntax error while parsing object key - unexpected ','; "
                "expected string literal"},
        Mistake{"\"camera\"", "\"kamera\"",
                ": the file: there is no key 'kamera' here; the keys are about, colours, objects, "
                "instances, scatter, camera, path, lights"},
        Mistake{"\"objects\"", "\"about\"", ": the file: the key 'objects' is missing"},
        Mistake{"\"name\": \"b\"", "\"name\": 5", ": objects[0]: 'name' must be a text"},
        Mistake{"[{\"generate\"", "[5, {\"generate\"",
                ": objects[0]: 'parts' must be a list of objects, [{...}, ...]"},
        Mistake{"\"position\": [5, 0, 0]", "\"position\": [5, 0]",
                ": objects[0].parts[0]: 'position' must be a list of 3 numbers"},
        Mistake{"\"turn\": 90", "\"turn\": \"left\"",
                ": objects[0].parts[0]: 'turn' must be a number"},
        Mistake{"\"generate\": \"box\"", "\"form\": \"box\"",
                ": objects[0].parts[0]: a part needs one of the keys 'model', 'map', 'generate' "
                "and 'primitive'"},
        Mistake{"\"generate\": \"box\"", "\"primitive\": \"box\"",
                ": objects[0].parts[0]: 'box' is not a primitive; the primitives are sphere and "
                "rectangle"},
        Mistake{"\"generate\": \"box\"", "\"generate\": \"cone\"",
                ": objects[0].parts[0]: dynrt cannot generate 'cone'; it generates sphere, box, "
                "torus and hills"},
        Mistake{"\"generate\": \"box\"",
                "\"generate\": \"sphere\", \"radius\": 1, \"subdivisions\": 99",
                ": objects[0].parts[0]: there is no key 'from' here; the keys are generate, name, "
                "colour, mirror, radius, subdivisions, position, turn"},
        Mistake{"\"to\": [1, 1, 1]", "\"to\": [1, 0, 1]",
                ": objects[0].parts[0]: 'from' must be below 'to' on every axis"},
        Mistake{"\"colour\": \"green\"", "\"colour\": \"grene\"",
                ": objects[0].parts[0]: 'grene' is not a colour of this file"},
        Mistake{"\"colour\": \"green\"", "\"colour\": [0, 2, 0]",
                ": objects[0].parts[0]: 'colour' must be three numbers from 0 to 1"},
        Mistake{"{\"object\": \"b\", \"name\": \"turned\"", "{\"object\": \"c\"",
                ": instances[1]: there is no object 'c'"},
        Mistake{"\"look_at\": [0, 0, 0]", "\"look_at\": [0, 0, 9]",
                ": camera: the camera's position and the point that it looks at are the same (0, "
                "0, 9); move one of the two"},
        Mistake{"\"look_at\": [0, 0, 0]", "\"up\": [0, 1, 0]",
                ": camera: the key 'look_at' is missing"},
        Mistake{"\"axis\": [0, 0, 2]", "\"axis\": [0, 0, 0]",
                ": instances[0].rotate: 'axis' must not be zero"},
        Mistake{"\"scale\": [2, 1, 1]", "\"scale\": [2, 0, 1]",
                ": node 'b#0': its transform has no inverse; its three axes must not be zero and "
                "must not lie in one plane"},
        Mistake{"[1, 0.5, 0, 7,", "[0, 0, 1, 7,",
                ": node 'given': its transform has no inverse; its three axes must not be zero and "
                "must not lie in one plane"},
        Mistake{"\"parts\": [{", "\"parts\": []}, {\"name\": \"c\", \"parts\": [{",
                ": objects[0]: the object 'b' has no parts"},
        Mistake{"  \"instances\"", "  \"instances\": [], \"about\"",
                ": the scene has no triangles (0 of zero area, 0 points and lines left out)"}));

TEST(Description, NamesModelsAndMaterialsThatAreNotThere) {
  const TestFolder folder;
  const auto error = [&](const std::string& part) {
    const std::string path =
        folder.write("m.json", R"({"objects": [{"name": "o", "parts": [{)" + part + R"(}]}]})");
    return user_error([&] { load_scene(path); }).substr(path.size());
  };
  EXPECT_EQ(error(R"("model": "Scopia#officechair")"),
            ": objects[0].parts[0]: the package sweethome3d-furniture has no model with the "
            "catalogue id 'Scopia#officechair'");
  EXPECT_EQ(error(R"("model": "Scopia#bandeja", "colours": {"glass": [1, 1, 1]})"),
            ": objects[0].parts[0].colours: the model has no material 'glass'; its materials are "
            "DefaultMaterial, transparent");
  EXPECT_EQ(error(R"("model": "Scopia#bandeja", "size": [1, 0, 1])"),
            ": objects[0].parts[0]: 'size' must be three numbers above zero");
}

TEST(Description, NamesWhatIsWrongWithAShape) {
  const TestFolder folder;
  const auto error = [&](const std::string& part) {
    const std::string path =
        folder.write("m.json", R"({"objects": [{"name": "o", "parts": [{"colour": [1, 1, 1], )" +
                                   part + R"(}]}]})");
    return user_error([&] { load_scene(path); }).substr(path.size());
  };
  EXPECT_EQ(error(R"("generate": "sphere", "radius": 0, "subdivisions": 1)"),
            ": objects[0].parts[0]: 'radius' must be a number above zero");
  EXPECT_EQ(error(R"("generate": "sphere", "radius": 1, "subdivisions": 7)"),
            ": objects[0].parts[0]: 'subdivisions' must be a whole number from 0 to 6");
  EXPECT_EQ(error(R"("generate": "torus", "major_radius": 1, "minor_radius": 1, "segments": 3.5)"),
            ": objects[0].parts[0]: 'segments' must be a whole number from 3 to 512");
}

constexpr char kLit[] = R"({
  "colours": {"warm": [1, 0.8, 0.5]},
  "objects": [{"name": "o", "parts": [
    {"model": "Scopia#bandeja", "mirror": ["transparent"]},
    {"generate": "box", "name": "plate", "from": [0, 0, 0], "to": [1, 1, 1], "colour": [1, 1, 1], "mirror": true},
    {"generate": "box", "name": "dull", "from": [0, 2, 0], "to": [1, 3, 1], "colour": [1, 1, 1]}]}],
  "lights": [{"name": "lamp", "position": [1, 2, 3], "colour": "warm", "intensity": 10},
             {"position": [4, 5, 6]}]
})";

TEST(Description, KeepsLightsAndMirrors) {
  const TestFolder folder;
  const Scene scene = load_scene(folder.write("l.json", kLit));
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].name, "lamp");
  EXPECT_EQ(scene.lights[0].position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.lights[0].colour, glm::dvec3(10, 8, 5));
  EXPECT_EQ(scene.lights[1].name, "light#1");
  EXPECT_EQ(scene.lights[1].colour, glm::dvec3(1));
  int mirrors = 0;
  for (const Material& material : scene.materials) {
    const bool expected = material.name == "Scopia#bandeja/transparent" || material.name == "plate";
    EXPECT_EQ(material.mirror, expected ? kMirrorShare : 0.0) << material.name;
    mirrors += material.mirror > 0.0;
  }
  EXPECT_EQ(mirrors, 2);
}

TEST(Description, NamesMistakesInLightsAndMirrors) {
  const TestFolder folder;
  const auto error = [&](const char* what, const char* with) {
    const std::string path = folder.write("l.json", replaced(kLit, what, with));
    return user_error([&] { load_scene(path); }).substr(path.size());
  };
  EXPECT_EQ(error("[\"transparent\"]", "[\"glass\"]"),
            ": objects[0].parts[0]: the model has no material 'glass'; its materials are "
            "DefaultMaterial, transparent");
  EXPECT_EQ(error("[\"transparent\"]", "true"),
            ": objects[0].parts[0]: 'mirror' must be a list of texts");
  EXPECT_EQ(error("\"mirror\": true", "\"mirror\": [\"plate\"]"),
            ": objects[0].parts[1]: 'mirror' must be true or false");
  EXPECT_EQ(error("\"warm\",", "\"cold\","), ": lights[0]: 'cold' is not a colour of this file");
  EXPECT_EQ(error("\"intensity\": 10", "\"intensity\": 0"),
            ": lights[0]: 'intensity' must be a number above zero");
  EXPECT_EQ(
      error("{\"position\": [4, 5, 6]}", "{\"at\": [4, 5, 6]}"),
      ": lights[1]: there is no key 'at' here; the keys are name, position, colour, intensity");
}

TEST(Description, NamesObjectsThatAreDoubledOrUnused) {
  const TestFolder folder;
  const std::string box =
      R"(, "parts": [{"generate": "box", "from": [0, 0, 0], "to": [1, 1, 1], "colour": [1, 1, 1]}]})";
  const auto error = [&](const std::string& text) {
    const std::string path = folder.write("m.json", text);
    return user_error([&] { load_scene(path); }).substr(path.size());
  };
  EXPECT_EQ(error(R"({"objects": [{"name": "o")" + box + R"(, {"name": "o")" + box + "]}"),
            ": objects[1]: there are two objects named 'o'");
  EXPECT_EQ(error(R"({"objects": [{"name": "o")" + box + R"(, {"name": "p")" + box +
                  R"(], "instances": [{"object": "p"}]})"),
            ": the file: no instance uses the object 'o'");
}

TEST(Description, NamesThePackageThatIsMissing) {
  const TestFolder folder;
  const std::string error = user_error([&] {
    load_description(DYNRT_SCENES_FOLDER "/office.json", {.furniture = folder.path("nowhere")});
  });
  EXPECT_EQ(error,
            "the models of this scene come from the Debian package sweethome3d-furniture, which is "
            "not installed (" +
                folder.path("nowhere") +
                " has no .sh3f file); install it with: apt-get install sweethome3d-furniture");
}

}  // namespace
}  // namespace dynrt::host
