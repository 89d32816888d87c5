// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "host/picture/srgb.h"
#include "host/picture/write_image.h"
#include "host/scene/load.h"
#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::StartsWith;

constexpr char kObj[] =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl wood\nf 1 2 3\nusemtl tile\n"
    "f 2 4 3\n";
constexpr char kMtl[] =
    "newmtl wood\nKd 1 1 1\nmap_Kd wood.png\nnewmtl tile\nKd 0.5 1 1\nmap_Kd tile.png\n";

class Textured : public testing::Test {
 protected:
  /// A picture of two pixels.
  void picture(const std::string& name, std::uint32_t left, std::uint32_t right) const {
    const std::vector<std::uint32_t> pixels = {left, right};
    write_image(folder_.path(name), PictureView(2, 1, pixels));
  }
  Scene load(const std::string& obj = kObj, const std::string& mtl = kMtl) const {
    folder_.write("a.mtl", mtl);
    return load_scene(folder_.write("a.obj", obj));
  }
  std::string path() const { return folder_.path("a.obj"); }

  static glm::dvec3 colour(const Scene& scene, const std::string& name) {
    for (const Material& material : scene.materials) {
      if (material.name == name) return material.diffuse;
    }
    ADD_FAILURE() << "no material " << name;
    return {};
  }

  const TestFolder folder_;
};

TEST_F(Textured, GivesAMaterialTheMeanColour) {
  picture("wood.png", 0x0000ff, 0x000000);
  picture("tile.png", 0xffffff, 0x808080);
  const Scene scene = load();
  EXPECT_LT(glm::length(colour(scene, "wood") - glm::dvec3(0.5, 0, 0)), 1e-6);
  const double grey = (1 + linear_of(128 / 255.0)) / 2;
  EXPECT_LT(glm::length(colour(scene, "tile") - glm::dvec3(0.5 * grey, grey, grey)), 1e-6);
  EXPECT_THAT(scene.notes, ElementsAre(path() + ": the file has 2 base colour textures; each "
                                                "material gets the mean colour of its texture"));
}

TEST_F(Textured, TakesTheColourOfATextureForBlack) {
  picture("wood.png", 0xff0000, 0xff0000);
  const Scene scene = load(kObj, "newmtl wood\nKd 0 0 0\nmap_Kd wood.png\nnewmtl tile\nKd 0 0 0\n");
  EXPECT_EQ(colour(scene, "wood"), glm::dvec3(0, 0, 1));
  EXPECT_EQ(colour(scene, "tile"), glm::dvec3(0));
}

TEST_F(Textured, FindsATextureOfAnotherMachine) {
  picture("my wood.png", 0x00ff00, 0x00ff00);
  const Scene scene = load(kObj, "newmtl wood\nKd 1 1 1\nmap_Kd C:\\\\work\\my wood.png\n");
  EXPECT_EQ(colour(scene, "wood"), glm::dvec3(0, 1, 0));
}

TEST_F(Textured, NotesTexturesThatCannotBeRead) {
  folder_.write("wood.png", "no picture");
  const Scene scene = load();
  EXPECT_EQ(colour(scene, "wood"), glm::dvec3(1));
  EXPECT_LT(glm::length(colour(scene, "tile") - glm::dvec3(0.5, 1, 1)), 1e-6);
  ASSERT_EQ(scene.notes.size(), 2u);
  EXPECT_THAT(scene.notes[1],
              AllOf(StartsWith(path() + ": 2 of its textures cannot be read, so their materials "
                                        "keep the colours of the file: 'wood.png' ("),
                    EndsWith("), 'tile.png' (does not exist)")));
  for (const std::string& note : scene.notes) EXPECT_EQ(note.find('\n'), note.npos) << note;
}

TEST_F(Textured, SurvivesEveryTruncationOfATexture) {
  picture("tile.png", 1, 2);
  picture("wood.png", 0x102030, 0xffffff);
  const std::string whole = read_file(folder_.path("wood.png"));
  for (std::size_t size = 0; size < whole.size(); size += 3) {
    folder_.write("wood.png", std::string_view(whole).substr(0, size));
    EXPECT_FALSE(load().instances.empty());
  }
}

constexpr char kGltf[] = R"({
  "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
  "materials": [{"name": "wood", "pbrMetallicRoughness": {
    "baseColorFactor": [1, 0.5, 1, 1], "baseColorTexture": {"index": 0}}}],
  "textures": [{"source": 0}], "images": [{"uri": "IMAGE"}],
  "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
  "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]})";

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

TEST_F(Textured, ReadsGltfTexturesInsideTheFileAndBesideIt) {
  picture("my wood.png", 0xffffff, 0x000000);
  const std::string inside =
      "data:image/png;base64," + base64(read_file(folder_.path("my wood.png")));
  for (const std::string& uri : {std::string("my%20wood.png"), inside}) {
    const Scene scene = load_scene(folder_.write("a.gltf", replaced(kGltf, "IMAGE", uri)));
    EXPECT_LT(glm::length(colour(scene, "wood") - glm::dvec3(0.5, 0.25, 0.5)), 1e-6) << uri;
    EXPECT_THAT(scene.notes, ElementsAre(folder_.path("a.gltf") +
                                         ": the file has 1 base colour texture; each material gets "
                                         "the mean colour of its texture"));
  }
}

TEST_F(Textured, SurvivesADamagedTextureInsideTheFile) {
  for (const char* uri : {"data:image/png;base64,AAAA", "data:image/png;base64,", "."}) {
    const std::string file = folder_.write("a.gltf", replaced(kGltf, "IMAGE", uri));
    try {
      EXPECT_EQ(load_scene(file).instances.size(), 1u);
    } catch (const UserError& error) {
      EXPECT_THAT(error.what(), StartsWith(file + ": "));
    }
  }
}

}  // namespace
}  // namespace dynrt::host
