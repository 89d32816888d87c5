// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/map.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <system_error>
#include <tuple>

#include "host/error.h"
#include "host/scene/bsp.h"
#include "host/scene/camera.h"
#include "host/scene/mesh_builder.h"
#include "host/scene/scene_messages.h"
#include "host/scene/text_lines.h"
#include "host/scene/zip_library.h"

namespace dynrt::host {

namespace {

constexpr double kOverbright = 4.0;  // the game's factor for baked light (2 bits)
constexpr double kEyeAboveSpawn = 26.0;
constexpr double kFieldOfView = 74.0;  // the game's 90 across an image of 4:3
constexpr glm::dvec3 kGrey{0.8};

glm::dvec3 y_up(const glm::dvec3& p) { return {p.x, p.z, -p.y}; }

// Three numbers of an entity's text; nothing when it is another one.
std::optional<glm::dvec3> numbers(std::string_view text) {
  glm::dvec3 v;
  for (int i = 0; i < 3; ++i) {
    const auto number = to_number(take_word(text));
    if (!number || !std::isfinite(*number)) return std::nullopt;
    v[i] = *number;
  }
  return v;
}

template <typename T>
T bezier(const T& a, const T& b, const T& c, double t) {
  return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
}

class MapScene {
 public:
  MapScene(const BspMap& map, const std::string& label, const MapOptions& options)
      : map_(map), label_(label), options_(options), builder_(stem()) {}

  Scene run() {
    scene_.name = stem();
    place_models();
    for (std::size_t m = 0; m < map_.models.size(); ++m) {
      const BspModel& model = map_.models[m];
      offset_ = offset_of_[m];
      for (std::uint32_t f = 0; f < model.faces; ++f) add(map_.faces[model.first_face + f]);
    }
    scene_.dropped.zero_area_triangles = builder_.zero_area_triangles();
    Mesh mesh = builder_.take();
    if (mesh.triangles.empty()) {
      refuse(messages::kNoTriangles, label_, scene_.dropped.zero_area_triangles, 0);
    }
    scene_.objects.push_back(std::move(mesh));
    scene_.instances.push_back({scene_.name, 0, glm::dmat4(1.0)});
    add_camera();
    return std::move(scene_);
  }

 private:
  std::string stem() const { return std::filesystem::path(label_).stem().string(); }

  // A door or the like that turns about a point is modelled around it and stands where its entity
  // does.
  void place_models() {
    offset_of_.assign(map_.models.size(), glm::dvec3(0.0));
    for (const BspMap::Entity& entity : map_.entities) {
      const auto model = entity.find("model"), origin = entity.find("origin");
      if (model == entity.end() || origin == entity.end()) continue;
      if (!model->second.starts_with('*')) continue;
      const auto number = to_integer(std::string_view(model->second).substr(1));
      const auto offset = numbers(origin->second);
      if (!number || *number < 0 || *number >= std::ssize(offset_of_) || !offset) {
        refuse(
            "{}: an entity places the model '{}' at '{}'; the model must be one of the map's {}, "
            "written as '*' and its number, and the place must be three numbers",
            label_, model->second, origin->second, map_.models.size());
      }
      offset_of_[static_cast<std::size_t>(*number)] = *offset;
    }
  }

  void add(const BspFace& face) {
    if (!map_.textures[face.texture].is_drawn()) return;
    if (face.type == BspFace::kPatch) {
      add_patch(face);
    } else {
      add_corners(face);
    }
  }

  // Light is averaged over all of a polygon, which would else show how it is cut; over each
  // triangle of a mesh. Seen from its front a triangle of the file is clockwise.
  void add_corners(const BspFace& face) {
    const auto vertex = [&](std::size_t i) -> const BspVertex& {
      return map_.vertices[face.first_vertex + face.corners[i]];
    };
    const std::size_t at_once = face.type == BspFace::kPolygon ? face.corners.size() : 3;
    for (std::size_t begin = 0; begin < face.corners.size(); begin += at_once) {
      glm::dvec3 sum(0.0);
      double area = 0.0;
      for (std::size_t i = begin; i < begin + at_once; i += 3) {
        const BspVertex &a = vertex(i), &b = vertex(i + 1), &c = vertex(i + 2);
        const double size =
            glm::length(glm::cross(b.position - a.position, c.position - a.position));
        sum += size * light(face, a, b, c);
        area += size;
      }
      const std::uint32_t paint = material(face, area > 0.0 ? sum / area : glm::dvec3(1.0));
      for (std::size_t i = begin; i < begin + at_once; i += 3) {
        add(vertex(i), vertex(i + 2), vertex(i + 1), paint);
      }
    }
  }

  void add_patch(const BspFace& face) {
    const std::uint32_t width = face.patch.x;
    const int level = options_.tessellation;
    const auto side = static_cast<std::size_t>(level) + 1;
    std::vector<BspVertex> grid(side * side);
    for (std::uint32_t row = 0; row + 2 < face.patch.y; row += 2) {
      for (std::uint32_t column = 0; column + 2 < width; column += 2) {
        for (std::size_t j = 0; j < side; ++j) {
          for (std::size_t i = 0; i < side; ++i) {
            grid[j * side + i] = point(face, row, column, static_cast<double>(i) / level,
                                       static_cast<double>(j) / level);
          }
        }
        for (std::size_t j = 0; j + 1 < side; ++j) {
          for (std::size_t i = 0; i + 1 < side; ++i) {
            const BspVertex &a = grid[j * side + i], &b = grid[j * side + i + 1],
                            &c = grid[(j + 1) * side + i], &d = grid[(j + 1) * side + i + 1];
            const std::uint32_t paint =
                material(face, 0.5 * (light(face, a, b, c) + light(face, d, c, b)));
            add(a, b, c, paint);
            add(b, d, c, paint);
          }
        }
      }
    }
  }

  // Neighbouring pieces share a row of control points and so, to the last bit, their border.
  BspVertex point(const BspFace& face, std::uint32_t row, std::uint32_t column, double u,
                  double v) const {
    std::array<BspVertex, 3> along;
    const auto between = [](const BspVertex& a, const BspVertex& b, const BspVertex& c, double t) {
      return BspVertex{bezier(a.position, b.position, c.position, t),
                       bezier(a.lightmap, b.lightmap, c.lightmap, t),
                       bezier(a.colour, b.colour, c.colour, t)};
    };
    for (std::uint32_t k = 0; k < 3; ++k) {
      const BspVertex* p = &map_.vertices[face.first_vertex + (row + k) * face.patch.x + column];
      along[k] = between(p[0], p[1], p[2], u);
    }
    return between(along[0], along[1], along[2], v);
  }

  void add(const BspVertex& a, const BspVertex& b, const BspVertex& c, std::uint32_t paint) {
    builder_.add(y_up(a.position + offset_), y_up(b.position + offset_), y_up(c.position + offset_),
                 paint);
  }

  // The mean of the baked light over a triangle: the lightmap at the points with barycentric
  // coordinates in fifths, or the corners' colours.
  glm::dvec3 light(const BspFace& face, const BspVertex& a, const BspVertex& b,
                   const BspVertex& c) const {
    if (!options_.baked_light) return glm::dvec3(1.0);
    if (face.lightmap < 0) return (a.colour + b.colour + c.colour) / 3.0;
    constexpr int kSteps = 5;
    glm::dvec3 sum(0.0);
    int samples = 0;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j, ++samples) {
        const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
        sum += texel(face.lightmap, (1 - u - v) * a.lightmap + u * b.lightmap + v * c.lightmap);
      }
    }
    return sum / static_cast<double>(samples);
  }

  glm::dvec3 texel(int lightmap, const glm::dvec2& at) const {
    constexpr double kSide = BspMap::kLightmapSide;
    const glm::dvec2 clamped = glm::clamp(at * kSide, 0.0, kSide - 1);
    const auto x = static_cast<std::size_t>(clamped.x), y = static_cast<std::size_t>(clamped.y);
    const std::string& bytes = map_.lightmaps[static_cast<std::size_t>(lightmap)];
    const char* rgb = &bytes[3 * (y * BspMap::kLightmapSide + x)];
    const auto byte = [&](int i) { return static_cast<double>(static_cast<std::uint8_t>(rgb[i])); };
    return glm::dvec3(byte(0), byte(1), byte(2)) / 255.0;
  }

  // One for each texture and colour, in the 8 bits a channel that the board keeps.
  std::uint32_t material(const BspFace& face, const glm::dvec3& light) {
    const std::string& name = map_.textures[face.texture].name;
    glm::dvec3 colour = options_.colour ? options_.colour(name) : kGrey;
    if (options_.baked_light) {
      // Too bright light keeps its hue, as in the game.
      const glm::dvec3 bright = kOverbright * light;
      colour *= bright / std::max({1.0, bright.x, bright.y, bright.z});
    }
    const glm::uvec3 bytes(glm::round(255.0 * colour));
    const auto [entry, is_new] =
        material_of_.try_emplace(std::tuple(face.texture, bytes.x, bytes.y, bytes.z),
                                 static_cast<std::uint32_t>(scene_.materials.size()));
    if (is_new) scene_.materials.push_back({name, glm::dvec3(bytes) / 255.0});
    return entry->second;
  }

  // Of the first entity that a player can start at.
  void add_camera() {
    for (const BspMap::Entity& entity : map_.entities) {
      const auto kind = entity.find("classname"), origin = entity.find("origin");
      if (kind == entity.end() || origin == entity.end()) continue;
      if (kind->second != "info_player_deathmatch" && kind->second != "info_player_start") continue;
      const auto at = numbers(origin->second);
      if (!at) continue;
      const auto angle = entity.find("angle");
      const double degrees =
          angle == entity.end() ? 0.0 : to_number(trim(angle->second)).value_or(0.0);
      const double turn = std::isfinite(degrees) ? glm::radians(degrees) : 0.0;
      const glm::dvec3 eye = y_up(*at + glm::dvec3(0.0, 0.0, kEyeAboveSpawn));
      const glm::dvec3 ahead = y_up({std::cos(turn), std::sin(turn), 0.0});
      scene_.camera = look_at(eye, eye + ahead, glm::dvec3(0, 1, 0), kFieldOfView, 1.0);
      return;
    }
  }

  const BspMap& map_;
  const std::string& label_;
  const MapOptions& options_;
  MeshBuilder builder_;
  std::vector<glm::dvec3> offset_of_;  // by model
  glm::dvec3 offset_{0.0};
  std::map<std::tuple<std::uint32_t, unsigned, unsigned, unsigned>, std::uint32_t> material_of_;
  Scene scene_;
};

constexpr char kFolder[] = "maps/";
constexpr char kSuffix[] = ".bsp";

std::vector<std::string> map_names(const ZipLibrary& library) {
  std::vector<std::string> names;
  for (const std::string& file : library.names()) {
    if (!file.starts_with(kFolder) || !file.ends_with(kSuffix)) continue;
    names.push_back(std::filesystem::path(file).stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Scene load_from(const ZipLibrary& library, const std::string& pk3, std::string name,
                const MapOptions& options) {
  const std::vector<std::string> names = map_names(library);
  const std::string list = fmt::format("{}", fmt::join(names, ", "));
  if (names.empty()) refuse("{}: the file holds no map (maps/NAME.bsp)", pk3);
  if (name.empty() && names.size() > 1) {
    refuse("{}: the file holds {} maps; name one of them, such as {}:{} (the maps are {})", pk3,
           names.size(), pk3, names[0], list);
  }
  if (name.empty()) name = names[0];
  const std::string file = kFolder + name + kSuffix;
  const auto bytes = library.read(file);
  if (!bytes) refuse("{}: the file has no map '{}'; its maps are {}", pk3, name, list);
  return map_scene(*bytes, pk3 + ":" + file, options);
}

}  // namespace

Scene map_scene(std::string_view bytes, const std::string& label, const MapOptions& options) {
  const BspMap map = read_bsp(bytes, label);
  return MapScene(map, label, options).run();
}

Scene load_map(const std::string& pk3, const std::string& name, const MapOptions& options) {
  return load_from(ZipLibrary(pk3, "a .pk3 file must be a zip file"), pk3, name, options);
}

Scene load_package_map(const std::string& name, const MapOptions& options, const std::string& pk3) {
  std::error_code unreachable;
  if (!std::filesystem::exists(pk3, unreachable)) {
    refuse(
        "the map of this scene comes from the Debian package openarena-081-maps, which is not "
        "installed ({} is missing); install it with: apt-get install openarena-081-maps",
        pk3);
  }
  return load_from(ZipLibrary(pk3, "reinstall the package openarena-081-maps"), pk3, name, options);
}

}  // namespace dynrt::host
