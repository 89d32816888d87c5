// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/check_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

std::string obj(std::string_view text) {
  return user_error([&] { check_obj(text, "a.obj"); });
}

std::string ply(const std::string& text) {
  return user_error([&] { mended_ply(text, "a.ply"); });
}

std::string gltf(std::string_view text) {
  return user_error([&] { mended_gltf(std::string(text), "a.gltf"); });
}

TEST(CheckObj, TakesWhatIsRight) {
  const std::string text =
      "# comment\r\nmtllib a b.mtl\n\nv -1.5e-3 +2 .5 1 0 0\nv 1 2 3\nv 1e-400 0 0\n"
      "f 1/1 2//3 \\\n -1/2/3 # tail\ncstype bezier\nmtllib c.mtl\n";
  EXPECT_EQ(check_obj(text, "a.obj"), (std::vector<std::string>{"a b.mtl", "c.mtl"}));
}

TEST(CheckObj, LeavesToAssimpWhatItIgnoresOrRefuses) {
  EXPECT_NO_THROW(check_obj("vertex 1 2 3\n\x89PNG\nf 1 x 9\nv 0 nan 1e39\n", "a.obj"));
}

TEST(CheckObj, NamesTheLine) {
  EXPECT_EQ(obj("v 0 0 0\n\nv 1 0.\x01 2\n"),
            "a.obj:3: a vertex needs three numbers, not '1 0.? 2'");
  EXPECT_EQ(obj("v 0 0 0\nv 1 0"), "a.obj:2: a vertex needs three numbers, not '1 0'");
  EXPECT_EQ(obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"),
            "a.obj:4: a face needs at least three vertices, but this one has 2");
}

constexpr char kHeader[] =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(CheckPly, JudgesTheHeader) {
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement vertex 3\n"),
            "a.ply: the PLY header has no 'end_header'; the file seems cut off");
  EXPECT_EQ(ply("ply\nformat binary_middle_endian 1.0\n"),
            "a.ply:2: 'format binary_middle_endian 1.0' is not a line of a PLY header");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement vertex many\n"),
            "a.ply:3: 'element vertex many' is not a line of a PLY header");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nproperty float x\n"),
            "a.ply:3: 'property float x' is not a line of a PLY header");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement vertex 2\nproperty real x\n"),
            "a.ply:4: 'property real x' is not a line of a PLY header");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement face 2\nproperty list float int i\n"),
            "a.ply:4: 'property list float int i' is not a line of a PLY header");
  EXPECT_NO_THROW(mended_ply(
      "ply\nformat binary_little_endian 1.0\nelement dust 9000000000000\nend_header\n", "a.ply"));
  EXPECT_NO_THROW(mended_ply("ply\nformat ascii 1.0\nend_header", "a.ply"));
}

TEST(CheckPly, JudgesAnAsciiBody) {
  const std::string header = kHeader;
  const std::string whole = header + "0 0 0\n1 0 0\n\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(mended_ply(whole, "a.ply"), whole);
  EXPECT_EQ(ply(header + "0 0 0\n1 0 0\n"),
            "a.ply: the PLY header announces 3 of element 'vertex', but the file ends after 2; it "
            "seems cut off");
  EXPECT_EQ(ply(header + "0 0 0\n1 0 0\n0 1 0\n"),
            "a.ply: the PLY header announces 1 of element 'face', but the file ends after 0; it "
            "seems cut off");
  EXPECT_EQ(ply(header + "0 0 0\n1 0\n"),
            "a.ply:11: the line has fewer numbers than element 'vertex' has properties");
  EXPECT_EQ(ply(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n"),
            "a.ply:13: the line has fewer numbers than element 'face' has properties");
  EXPECT_EQ(ply(header + "0 0 0\n1 0 0\n0 1 0\nx 0 1\n"),
            "a.ply:13: the line has fewer numbers than element 'face' has properties");
}

TEST(CheckPly, JudgesABinaryBody) {
  for (const bool big : {false, true}) {
    const std::string header =
        replaced(kHeader, "ascii", big ? "binary_big_endian" : "binary_little_endian");
    const auto face = [&](char last) {
      std::string bytes(3 * 12, '\0');  // three vertices
      bytes += '\3';
      for (const char index : {char{0}, char{1}, last}) {
        const std::string zeros(3, '\0');
        bytes += big ? zeros + index : index + zeros;
      }
      return bytes;
    };
    EXPECT_EQ(mended_ply(header + face(2), "a.ply"),
              header.substr(0, header.size() - 1) + "\r\n" + face(2));
    std::string cut = header + face(2);
    cut.pop_back();
    EXPECT_EQ(ply(cut),
              "a.ply: the PLY header announces 1 of element 'face', but the file ends after 0; it "
              "seems cut off");
    EXPECT_EQ(ply(header + std::string(30, '\0')),
              "a.ply: the PLY header announces 3 of element 'vertex', but the file ends after 2; "
              "it seems cut off");
  }
}

TEST(CheckGltf, JudgesTheJson) {
  EXPECT_EQ(gltf("{\n\"asset\": {\n"),
            "a.gltf:3: not valid JSON: syntax error while parsing object key - unexpected end of "
            "input; expected string literal");
  EXPECT_EQ(gltf("[1, 2]"), "a.gltf:1: not valid JSON: it must be an object, {...}");
  EXPECT_EQ(gltf("{\"a\":" + std::string(100000, '[')),
            "a.gltf: not a valid file: its JSON is nested deeper than 64 levels");
}

TEST(CheckGltf, JudgesTheNodeGraph) {
  EXPECT_EQ(gltf(R"({"nodes": [{"children": [1]}, {"name": "b", "children": [0]}]})"),
            "a.gltf: node '0' lies more than 256 levels deep or inside itself; flatten the node "
            "graph");
  std::string chain = R"({"nodes": [)";
  for (int n = 0; n < 256; ++n) chain += "{\"children\": [" + std::to_string(n + 1) + "]},";
  EXPECT_NO_THROW(mended_gltf(replaced(chain, R"("children": [256])", "") + "{}]}", "a.gltf"));
  EXPECT_EQ(gltf(chain + R"({"name": "deep"}]})"),
            "a.gltf: node 'deep' lies more than 256 levels deep or inside itself; flatten the "
            "node graph");
}

constexpr char kSkins[] =
    R"({"nodes": [{"skin": 0}, {"skin": 1}, {"skin": 1, "mesh": 2}], )"
    R"("skins": [{"joints": [0], "inverseBindMatrices": 3}, {"joints": [0]}]})";

TEST(CheckGltf, TakesAwaySkinsWithoutMatrices) {
  const MendedGltf mended = mended_gltf(kSkins, "a.gltf");
  EXPECT_EQ(mended.bare_skins, 1u);
  EXPECT_EQ(nlohmann::json::parse(mended.text)["nodes"],
            nlohmann::json::parse(R"([{"skin": 0}, {}, {"mesh": 2}])"));
  const std::string same = R"({ "nodes": [{"skin": 0}], "skins": [{"inverseBindMatrices": 3}]})";
  EXPECT_EQ(mended_gltf(same, "a.gltf").text, same);
}

TEST(CheckGltf, TakesThemAwayInAGlb) {
  const auto glb = [](const std::string& json, const std::string& rest) {
    const auto word = [](std::size_t n) {
      return std::string{static_cast<char>(n & 255), static_cast<char>(n >> 8), 0, 0};
    };
    return "glTF" + word(2) + word(20 + json.size() + rest.size()) + word(json.size()) + "JSON" +
           json + rest;
  };
  std::string json = mended_gltf(kSkins, "a.gltf").text;
  json.resize((json.size() + 3) / 4 * 4, ' ');
  EXPECT_EQ(mended_gltf(glb(kSkins, "the buffer"), "a.glb").text, glb(json, "the buffer"));
}

TEST(CheckGltf, ReadsTheJsonOfAGlb) {
  const auto glb = [](std::uint8_t version, std::uint8_t json, std::string_view text) {
    std::string bytes = "glTF";
    for (const std::uint8_t byte : {version, std::uint8_t{22}, json}) {
      bytes += std::string{static_cast<char>(byte), 0, 0, 0};
    }
    return bytes + "JSON" + std::string(text);
  };
  for (const std::uint8_t version : {std::uint8_t{1}, std::uint8_t{2}}) {
    EXPECT_NO_THROW(mended_gltf(glb(version, 2, "{}"), "a.gltf"));
    EXPECT_EQ(gltf(glb(version, 2, "[]")), "a.gltf:1: not valid JSON: it must be an object, {...}");
  }
  // Assimp refuses what is cut off.
  EXPECT_NO_THROW(mended_gltf(glb(2, 44, "{}"), "a.gltf"));
  EXPECT_NO_THROW(mended_gltf(glb(2, 2, "{}").substr(0, 19), "a.gltf"));
}

}  // namespace
}  // namespace dynrt::host
