// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A map of the game Quake 3 as it lies in its file, BSP version 46: the parts that a picture needs
// (no visibility, no brushes). read_bsp checks every index. Positions are the file's: z up, a unit
// is about an inch. Lump numbers and record sizes are those of the engine's published source
// (qfiles.h).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace dynrt::host {

struct BspTexture {
  static constexpr std::uint32_t kSky = 0x4, kNoDraw = 0x80;  ///< bits of the surface flags

  std::string name;
  std::uint32_t flags = 0;

  bool is_drawn() const { return (flags & (kSky | kNoDraw)) == 0; }
};

struct BspVertex {
  glm::dvec3 position{0.0};
  glm::dvec2 lightmap{0.0};  ///< within its face's lightmap, [0, 1]^2
  glm::dvec3 colour{0.0};    ///< light at the vertex, [0, 1]
};

struct BspFace {
  enum Type : std::uint32_t { kPolygon = 1, kPatch = 2, kMesh = 3, kBillboard = 4 };

  Type type = kPolygon;
  std::uint32_t texture = 0;
  std::uint32_t first_vertex = 0;
  std::vector<std::uint32_t>
      corners;          ///< polygon, mesh: three a triangle, counted from first_vertex
  glm::uvec2 patch{0};  ///< patch: control points along and across, both odd, at least 3
  int lightmap = -1;    ///< -1: lit by its vertices' colours
};

/// Faces [first, first + count) belong to one model; model 0 is the world.
struct BspModel {
  std::uint32_t first_face = 0, faces = 0;
};

struct BspMap {
  static constexpr unsigned kLightmapSide = 128;  ///< texels; three bytes each, red first

  using Entity = std::map<std::string, std::string>;

  std::vector<Entity> entities;
  std::vector<BspTexture> textures;
  std::vector<BspModel> models;
  std::vector<BspVertex> vertices;
  std::vector<BspFace> faces;
  std::vector<std::string> lightmaps;
};

/// `bytes` is the whole file, `label` its name in messages. Throws UserError if the file is no such
/// map, has another version, is cut off or has an index out of range.
BspMap read_bsp(std::string_view bytes, const std::string& label);

}  // namespace dynrt::host
