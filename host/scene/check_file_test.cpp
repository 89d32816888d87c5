// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/check_file.h"

#include <gtest/gtest.h>

#include "host/scene/test_files.h"

namespace dynrt::host {
namespace {

std::string obj(std::string_view text) {
  return user_error([&] { check_obj(text, "a.obj"); });
}

std::string ply(std::string_view text) {
  return user_error([&] { check_ply(text, "a.ply"); });
}

std::string gltf(std::string_view text) {
  return user_error([&] { check_gltf(text, "a.gltf"); });
}

TEST(CheckObj, TakesWhatIsRight) {
  const std::string text =
      "# comment\r\nmtllib a b.mtl\n\nv -1.5e-3 +2 .5 1 0 0\nv 1 2 3\nv 1e-400 0 0\n"
      "f 1/1 2//3 \\\n -1/2/3 # tail\ncstype bezier\nmtllib c.mtl\n";
  EXPECT_EQ(check_obj(text, "a.obj"), (std::vector<std::string>{"a b.mtl", "c.mtl"}));
}

TEST(CheckObj, NamesTheLine) {
  EXPECT_EQ(obj("v 0 0 0\nvertex 1 2 3\n"), "a.obj:2: 'vertex' is not a statement of an OBJ file");
  EXPECT_EQ(obj("\x89PNG\n"), "a.obj:1: '?PNG' is not a statement of an OBJ file");
  EXPECT_EQ(obj("v 0 0 0\n\nv 1 0.\x01 2\n"),
            "a.obj:3: a vertex needs three numbers, not '1 0.? 2'");
  EXPECT_EQ(obj("v 0 0 0\nv 1 0"), "a.obj:2: a vertex needs three numbers, not '1 0'");
  EXPECT_EQ(obj("v 0 0 0\nv 0 nan 1\n"),
            "a.obj:2: vertex 2 is not finite: 'nan' is outside the range of single precision");
  EXPECT_EQ(obj("v 0 0 -inf\n"),
            "a.obj:1: vertex 1 is not finite: '-inf' is outside the range of single precision");
  EXPECT_EQ(obj("v 0 0 1e39\n"),
            "a.obj:1: vertex 1 is not finite: '1e39' is outside the range of single precision");
  EXPECT_EQ(obj("v 0 0 1e999\n"),
            "a.obj:1: vertex 1 is not finite: '1e999' is outside the range of single precision");
}

TEST(CheckObj, JudgesFaces) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(obj(three + "f 1 2\n"),
            "a.obj:4: a face needs at least three vertices, this one has 2");
  EXPECT_EQ(obj(three + "f 1 x 3\n"), "a.obj:4: 'x' is not a vertex of a face");
  EXPECT_EQ(obj(three + "f 1 0 3\n"), "a.obj:4: '0' is not a vertex of a face");
  EXPECT_EQ(obj(three + "f 1 2 3\nf 1 2 4\n"),
            "a.obj:5: the face uses vertex 4, but the file has 3 vertices");
  EXPECT_EQ(obj(three + "f 1 2 -4\n"),
            "a.obj:4: the face uses vertex -4, but the file has 3 vertices");
  EXPECT_EQ(obj(three + "f 1 2 -9223372036854775808\n"),
            "a.obj:4: the face uses vertex -9223372036854775808, but the file has 3 vertices");
  EXPECT_NO_THROW(check_obj("f 1 2 3\n" + three, "a.obj"));
}

constexpr char kHeader[] =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(CheckPly, JudgesTheHeader) {
  EXPECT_EQ(ply("obj\n"), "a.ply: is not a valid PLY file: it must begin with 'ply'");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement vertex 3\n"),
            "a.ply: the PLY header has no 'end_header'; the file seems cut off");
  EXPECT_EQ(ply("ply\nelement vertex 0\nproperty float x\nend_header\n"),
            "a.ply: the PLY header has no 'format' line");
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
  EXPECT_EQ(ply("ply\nformat binary_little_endian 1.0\nelement dust 9000000000000\nend_header\n"),
            "a.ply: the PLY header gives element 'dust' no property; it needs at least one");
}

TEST(CheckPly, JudgesAnAsciiBody) {
  const std::string header = kHeader;
  EXPECT_NO_THROW(check_ply(header + "0 0 0\n1 0 0\n\n0 1 0\n3 0 1 2\n", "a.ply"));
  EXPECT_EQ(ply(header + "0 0 0\n1 0 0\n"),
            "a.ply: the PLY header announces 3 of element 'vertex', but the file ends after 2; it "
            "seems cut off");
  EXPECT_EQ(ply(header + "0 0 0\n1 0 0\n0 1 0\n"),
            "a.ply: the PLY header announces 1 of element 'face', but the file ends after 0; it "
            "seems cut off");
  EXPECT_EQ(ply(header + "0 0 0\n1 0 zero\n"),
            "a.ply:11: 'zero' is not a number of element 'vertex'");
  EXPECT_EQ(ply(header + "0 0 0\n1 0\n"), "a.ply:11: '' is not a number of element 'vertex'");
  EXPECT_EQ(ply(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "a.ply: face 0 uses vertex 3, but the file has 3 vertices");
  EXPECT_EQ(ply(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
            "a.ply: face 0 uses vertex -1, but the file has 3 vertices");
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
    EXPECT_NO_THROW(check_ply(header + face(2), "a.ply"));
    EXPECT_EQ(ply(header + face(5)), "a.ply: face 0 uses vertex 5, but the file has 3 vertices");
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
            "a.gltf:3: is not valid JSON: syntax error while parsing object key - unexpected end "
            "of input; expected string literal");
  EXPECT_EQ(gltf("[1, 2]"), "a.gltf:1: is not valid JSON: it must be an object, {...}");
  EXPECT_EQ(gltf("{\"a\":" + std::string(100000, '[')),
            "a.gltf: is not a valid file: its JSON is nested deeper than 64 levels");
}

TEST(CheckGltf, JudgesTheNodeGraph) {
  EXPECT_EQ(gltf(R"({"nodes": [{"children": [1]}, {"name": "b", "children": [0]}]})"),
            "a.gltf: node '0' lies more than 256 levels deep or inside itself; flatten the node "
            "graph");
  std::string chain = R"({"nodes": [)";
  for (int n = 0; n < 256; ++n) chain += "{\"children\": [" + std::to_string(n + 1) + "]},";
  EXPECT_NO_THROW(check_gltf(replaced(chain, R"("children": [256])", "") + "{}]}", "a.gltf"));
  EXPECT_EQ(gltf(chain + R"({"name": "deep"}]})"),
            "a.gltf: node 'deep' lies more than 256 levels deep or inside itself; flatten the "
            "node graph");
}

TEST(CheckGltf, JudgesTheGlbHeader) {
  const auto glb = [](uint8_t version, uint8_t length, uint8_t json) {
    std::string text = "glTF";
    for (const uint8_t byte : {version, length, json}) {
      text += std::string{static_cast<char>(byte), 0, 0, 0};
    }
    return text + "JSON{}";
  };
  const std::string magic =
      "a.gltf: is not a valid GLB file: it must begin with 'glTF', version 2 and a JSON chunk";
  EXPECT_NO_THROW(check_gltf(glb(2, 22, 2), "a.gltf"));
  EXPECT_EQ(gltf(glb(1, 22, 2)), magic);
  EXPECT_EQ(gltf(glb(2, 22, 2).substr(0, 19)), magic);
  EXPECT_EQ(gltf(glb(2, 90, 2)),
            "a.gltf: the GLB header announces 90 bytes, but the file has 22; it seems cut off");
  EXPECT_EQ(gltf(glb(2, 22, 44)),
            "a.gltf: the GLB header announces 64 bytes, but the file has 22; it seems cut off");
}

}  // namespace
}  // namespace dynrt::host
