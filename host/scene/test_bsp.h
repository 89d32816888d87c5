// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Quake 3 maps that tests write themselves, record by record.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>

namespace dynrt::host {

struct BspWriter {
  static constexpr int kEntities = 0, kTextures = 1, kModels = 7, kVertices = 10,
                       kMeshVertices = 11, kFaces = 13, kLightmaps = 14;
  static constexpr std::size_t kHeaderBytes = 144;

  std::array<std::string, 17> lumps;
  std::uint32_t version = 46;

  static std::string word(std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
    return bytes;
  }
  static std::string integer(int value) { return word(static_cast<std::uint32_t>(value)); }
  static std::string real(float value) { return word(std::bit_cast<std::uint32_t>(value)); }

  void texture(std::string name, std::uint32_t flags = 0) {
    name.resize(64, '\0');
    lumps[kTextures] += name + word(flags) + word(0);
  }

  /// The colour is r = g = b = `light`.
  void vertex(float x, float y, float z, std::uint8_t light = 255, float u = 0, float v = 0) {
    const char l = static_cast<char>(light);
    lumps[kVertices] += real(x) + real(y) + real(z) + real(0) + real(0) + real(u) + real(v) +
                        real(0) + real(0) + real(1) + std::string{l, l, l, l};
  }

  struct Face {
    int texture = 0, type = 1, first_vertex = 0, vertices = 0, first_mesh = 0, meshes = 0;
    int lightmap = -1, width = 0, height = 0;
  };
  void face(const Face& f) {
    lumps[kFaces] += integer(f.texture) + integer(-1) + integer(f.type) + integer(f.first_vertex) +
                     integer(f.vertices) + integer(f.first_mesh) + integer(f.meshes) +
                     integer(f.lightmap) + std::string(64, '\0') + integer(f.width) +
                     integer(f.height);
  }
  void mesh_vertices(std::initializer_list<int> corners) {
    for (const int corner : corners) lumps[kMeshVertices] += integer(corner);
  }
  void model(int first_face, int faces) {
    lumps[kModels] +=
        std::string(24, '\0') + integer(first_face) + integer(faces) + std::string(8, '\0');
  }
  void lightmap(std::uint8_t light) {
    lumps[kLightmaps] += std::string(128 * 128 * 3, static_cast<char>(light));
  }

  std::string bytes() const {
    std::string header = "IBSP" + word(version), body;
    for (const std::string& lump : lumps) {
      header += word(static_cast<std::uint32_t>(kHeaderBytes + body.size())) +
                word(static_cast<std::uint32_t>(lump.size()));
      body += lump;
    }
    return header + body;
  }
};

/// A floor of two triangles, a patch, a mesh of one triangle, and what is not drawn: a sky, a
/// hidden face and a billboard. The second model, one triangle, is placed by an entity.
inline BspWriter small_map() {
  BspWriter map;
  map.lumps[BspWriter::kEntities] =
      "{\n\"classname\" \"worldspawn\"\n}\n{\n\"classname\" \"func_door\"\n\"model\" \"*1\"\n"
      "\"origin\" \"0 0 64\"\n}\n{\n\"classname\" \"info_player_deathmatch\"\n"
      "\"origin\" \"1 2 3\"\n\"angle\" \"90\"\n}\n";
  map.texture("textures/stone");
  map.texture("textures/moss");
  map.texture("textures/sky", 0x4);
  map.texture("textures/hidden", 0x80);
  map.vertex(0, 0, 0);
  map.vertex(0, 8, 0);
  map.vertex(8, 8, 0);
  map.vertex(8, 0, 0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      map.vertex(static_cast<float>(column), static_cast<float>(row), column == 1 ? 2.0f : 0.0f,
                 64);
    }
  }
  map.mesh_vertices({0, 1, 2, 0, 2, 3, 0, 1, 2});
  map.lightmap(32);
  map.face({.vertices = 4, .meshes = 6, .lightmap = 0});
  map.face({.texture = 1, .type = 2, .first_vertex = 4, .vertices = 9, .width = 3, .height = 3});
  map.face({.texture = 1, .type = 3, .vertices = 3, .first_mesh = 6, .meshes = 3});
  map.face({.texture = 2, .vertices = 4, .meshes = 6});
  map.face({.texture = 3, .vertices = 4, .meshes = 6});
  map.face({.texture = 1, .type = 4, .vertices = 1});
  map.face({.type = 3, .vertices = 3, .first_mesh = 6, .meshes = 3});
  map.model(0, 6);
  map.model(6, 1);
  return map;
}

}  // namespace dynrt::host
