// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/bsp.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "host/scene/test_bsp.h"
#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

TEST(Bsp, ReadsWhatWasWritten) {
  const BspMap map = read_bsp(small_map().bytes(), "m.bsp");
  ASSERT_EQ(map.entities.size(), 3u);
  EXPECT_EQ(map.entities[0].at("classname"), "worldspawn");
  EXPECT_EQ(map.entities[2].at("origin"), "1 2 3");
  ASSERT_EQ(map.textures.size(), 4u);
  EXPECT_EQ(map.textures[1].name, "textures/moss");
  EXPECT_TRUE(map.textures[1].is_drawn());
  EXPECT_FALSE(map.textures[2].is_drawn());
  EXPECT_FALSE(map.textures[3].is_drawn());
  ASSERT_EQ(map.vertices.size(), 13u);
  EXPECT_EQ(map.vertices[2].position, glm::dvec3(8, 8, 0));
  EXPECT_EQ(map.vertices[5].position, glm::dvec3(1, 0, 2));
  EXPECT_EQ(map.vertices[5].colour, glm::dvec3(64.0 / 255.0));
  ASSERT_EQ(map.faces.size(), 7u);
  EXPECT_EQ(map.faces[0].corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(map.faces[0].lightmap, 0);
  EXPECT_EQ(map.faces[1].type, BspFace::kPatch);
  EXPECT_EQ(map.faces[1].patch, glm::uvec2(3, 3));
  EXPECT_EQ(map.faces[1].lightmap, -1);
  ASSERT_EQ(map.models.size(), 2u);
  EXPECT_EQ(map.models[1].first_face, 6u);
  EXPECT_EQ(map.lightmaps.size(), 1u);
}

TEST(Bsp, LeavesOutLightmapCoordinatesThatAreNotNumbers) {
  BspWriter writer = small_map();
  writer.vertex(1, 2, 3, 255, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(read_bsp(writer.bytes(), "m.bsp").vertices.back().lightmap, glm::dvec2(0));
}

struct Mistake {
  const char* name;
  std::function<void(BspWriter&)> make;
  const char* sentence;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

class BspMistake : public testing::TestWithParam<Mistake> {};

TEST_P(BspMistake, IsNamed) {
  BspWriter map = small_map();
  GetParam().make(map);
  EXPECT_EQ(user_error([&] { read_bsp(map.bytes(), "m.bsp"); }),
            std::string("m.bsp: ") + GetParam().sentence);
}

constexpr float kInf = std::numeric_limits<float>::infinity();

INSTANTIATE_TEST_SUITE_P(
    All, BspMistake,
    testing::Values(
        Mistake{"version", [](BspWriter& m) { m.version = 47; },
                "the map has version 47; dynrt reads only version 46, that of Quake 3"},
        Mistake{"lump_size", [](BspWriter& m) { m.lumps[BspWriter::kModels] += "x"; },
                "the map's models take 81 bytes, which is not a multiple of 40; the file is "
                "damaged"},
        Mistake{"vertex", [](BspWriter& m) { m.vertex(0, kInf, 0); },
                "vertex 13 is not finite; the file is damaged"},
        Mistake{"texture", [](BspWriter& m) { m.face({.texture = 4}); },
                "face 7 uses texture 4 to 4, but there are 4; the file is damaged"},
        Mistake{"no_texture", [](BspWriter& m) { m.face({.texture = -1}); },
                "face 7 uses texture -1 to -1, but there are 4; the file is damaged"},
        Mistake{"vertices", [](BspWriter& m) { m.face({.first_vertex = 10, .vertices = 4}); },
                "face 7 uses vertices 10 to 13, but there are 13; the file is damaged"},
        Mistake{"vertices_overflow",
                [](BspWriter& m) { m.face({.first_vertex = 0x7fffffff, .vertices = 0x7fffffff}); },
                "face 7 uses vertices 2147483647 to 4294967293, but there are 13; the file is "
                "damaged"},
        Mistake{"mesh_vertices", [](BspWriter& m) { m.face({.first_mesh = 7, .meshes = 3}); },
                "face 7 uses mesh vertices 7 to 9, but there are 9; the file is damaged"},
        Mistake{"corner", [](BspWriter& m) { m.face({.vertices = 2, .meshes = 3}); },
                "face 7 uses corner 2 to 2, but there are 2; the file is damaged"},
        Mistake{"corners", [](BspWriter& m) { m.face({.vertices = 4, .meshes = 4}); },
                "face 7 has 4 corners, which is not a multiple of 3; the file is damaged"},
        Mistake{"lightmap", [](BspWriter& m) { m.face({.lightmap = 1}); },
                "face 7 uses lightmap 1 to 1, but there are 1; the file is damaged"},
        Mistake{"type", [](BspWriter& m) { m.face({.type = 5}); },
                "face 7 is of type 5; types are 1 (polygon), 2 (patch), 3 (mesh) and 4 "
                "(billboard)"},
        Mistake{"patch",
                [](BspWriter& m) { m.face({.type = 2, .vertices = 12, .width = 4, .height = 3}); },
                "face 7 is a patch of 4 by 3 control points and has 12; both sides must be odd and "
                "at least 3, and their product must be that number"},
        Mistake{"model", [](BspWriter& m) { m.model(5, 3); },
                "model 2 uses faces 5 to 7, but there are 7; the file is damaged"},
        Mistake{"entities", [](BspWriter& m) { m.lumps[BspWriter::kEntities] = "{ \"a\" \"b"; },
                "the list of entities ends inside an entity; the file is damaged"},
        Mistake{"open_entity", [](BspWriter& m) { m.lumps[BspWriter::kEntities] = "{ \"a\" "; },
                "the list of entities ends inside an entity; the file is damaged"}),
    [](const auto& info) { return info.param.name; });

TEST(Bsp, NamesWhereAFileIsCutOff) {
  const std::string whole = small_map().bytes();
  const auto error = [&](std::size_t size) {
    return user_error([&] { read_bsp(whole.substr(0, size), "m.bsp"); });
  };
  EXPECT_EQ(error(3),
            "m.bsp: not a Quake 3 map: the file must begin with 'IBSP' and the version 46");
  EXPECT_EQ(error(7),
            "m.bsp: the map has 7 bytes, fewer than the 144 of its header; it seems cut off");
  EXPECT_EQ(error(143),
            "m.bsp: the map has 143 bytes, fewer than the 144 of its header; it seems cut off");
  EXPECT_EQ(error(whole.size() - 1), "m.bsp: the map's lightmaps lie in bytes " +
                                         std::to_string(whole.size() - 128 * 128 * 3) + " to " +
                                         std::to_string(whole.size()) + ", but it has " +
                                         std::to_string(whole.size() - 1) +
                                         " bytes; it seems cut off");
  for (std::size_t size = 144; size < whole.size() - 1; size += 97) {
    EXPECT_NE(error(size).find("it seems cut off"), std::string::npos) << size;
  }
}

}  // namespace
}  // namespace dynrt::host
