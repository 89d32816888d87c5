// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/maps.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <string_view>

#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

using ValueOf = std::function<float(unsigned x, unsigned y)>;

constexpr std::array kMaps = {
    MapDefinition{"nodes", "nodes fetched by the packet", "values", true},
    MapDefinition{"lists", "lists of leaves read by the packet", "values", true},
    MapDefinition{"objects", "objects entered by the packet", "values", true},
    MapDefinition{"triangles", "primitives that the packet was tested against", "values", true},
    MapDefinition{"clocks", "clocks from the packet's start to its end", "values", true},
    MapDefinition{"misses", "misses in all caches of the packet's requests", "values", true},
    MapDefinition{"wrong", "the hit compared with the true one", "classes", false},
    MapDefinition{"distance", "distance of the hit, in the scene's unit of length", "values",
                  false},
    MapDefinition{"cosine", "direction times normal, as the core has it", "values", false},
    MapDefinition{"normals", "the normal of what is hit: red x, green y, blue z", "colours", false},
};

std::vector<std::uint32_t> values(const FullPicture& picture, const ValueOf& value_of, Json& head) {
  std::vector<std::uint32_t> words;
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (unsigned y = 0; y < picture.request.height; ++y) {
    for (unsigned x = 0; x < picture.request.width; ++x) {
      const float value = value_of(x, y);
      words.push_back(std::bit_cast<std::uint32_t>(value));
      if (std::isnan(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  head["low"] = low <= high ? Json(low) : Json(0);
  head["high"] = low <= high ? Json(high) : Json(0);
  return words;
}

ValueOf work(const FullPicture& picture, std::uint32_t PacketWork::* count) {
  return [&picture, count](unsigned x, unsigned y) {
    return static_cast<float>(picture.packet_at(x, y)->*count);
  };
}

ValueOf clocks(const FullPicture& picture) {
  return [&picture](unsigned x, unsigned y) {
    const PacketWork& packet = *picture.packet_at(x, y);
    return static_cast<float>(packet.end - packet.begin);
  };
}

ValueOf distance(const LoadedScene& loaded, const FullPicture& picture) {
  return [&](unsigned x, unsigned y) {
    const HitRecord& hit = picture.frame.hits[picture.index(x, y)];
    if (!hit.hit) return kUnknown;
    const Camera& camera = picture.camera;
    const glm::dvec3 direction = ((x + 0.5) / picture.request.width - 0.5) * camera.right +
                                 (0.5 - (y + 0.5) / picture.request.height) * camera.up +
                                 camera.forward;
    return static_cast<float>(loaded.core().format->number(hit.t) * glm::length(direction) *
                              loaded.image().space.unit);
  };
}

ValueOf cosine(const LoadedScene& loaded, const FullPicture& picture) {
  return [&](unsigned x, unsigned y) {
    const HitRecord& hit = picture.frame.hits[picture.index(x, y)];
    return hit.hit ? static_cast<float>(loaded.core().format->number(hit.cosine)) : kUnknown;
  };
}

/// Towards the eye; black where nothing is hit or the surface is curved.
std::uint32_t normal_colour(const LoadedScene& loaded, const FullPicture& picture,
                            std::size_t pixel) {
  const auto id = picture.primitive_at(pixel);
  if (!id) return 0;
  const Scene& scene = loaded.image().scene;
  const Instance& instance = scene.instances[id->instance];
  const Mesh& mesh = scene.objects[instance.object];
  if (mesh.is_ellipsoid(id->primitive)) return 0;
  std::array<glm::dvec3, 3> corners = mesh.corners(id->primitive);
  for (glm::dvec3& c : corners) c = glm::dvec3(instance.transform * glm::dvec4(c, 1.0));
  glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  if (glm::dot(normal, corners[0] - picture.camera.position) > 0) normal = -normal;
  const auto level = [](double x) {
    return static_cast<std::uint32_t>(std::lround(255 * (0.5 + 0.5 * x)));
  };
  return level(normal.x) | level(normal.y) << 8 | level(normal.z) << 16;
}

std::vector<std::uint32_t> normals(const LoadedScene& loaded, const FullPicture& picture) {
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < picture.frame.pixels.size(); ++i) {
    words.push_back(normal_colour(loaded, picture, i));
  }
  return words;
}

std::vector<std::uint32_t> verdicts(const FullPicture& picture, Json& head) {
  if (!picture.truth) {
    refuse(
        "true hits need CGAL and Embree, and this program was built without them; run scripts/test "
        "--build-only");
  }
  std::vector<std::optional<PrimitiveId>> primitives;
  for (std::size_t i = 0; i < picture.frame.pixels.size(); ++i) {
    primitives.push_back(picture.primitive_at(i));
  }
  const FrameRays rays{picture.camera, picture.request.width, picture.request.height};
  std::vector<std::uint32_t> words;
  std::array<std::uint64_t, 4> counts{};
  for (const Verdict verdict : picture.truth->verdicts(rays, primitives)) {
    ++counts[static_cast<std::size_t>(verdict)];
    words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(verdict)));
  }
  head["classes"] = {"right", "another primitive", "missed", "nothing is there"};
  head["counts"] = counts;
  return words;
}

}  // namespace

std::span<const MapDefinition> view_maps() { return kMaps; }

Answer map_of(const LoadedScene& loaded, const FullPicture& picture, const std::string& name) {
  const auto found =
      std::ranges::find(kMaps, name, [](const auto& map) { return std::string_view(map.name); });
  if (found == kMaps.end()) {
    throw NotOurs("there is no such map");
  }
  if (found->watched && !picture.watch) refuse("the frame was not watched yet");
  Answer answer{.head = {{"name", name}, {"kind", found->kind}, {"number", picture.number}}};
  const std::map<std::string, ValueOf> of = {{"nodes", work(picture, &PacketWork::nodes)},
                                             {"lists", work(picture, &PacketWork::lists)},
                                             {"objects", work(picture, &PacketWork::objects)},
                                             {"triangles", work(picture, &PacketWork::triangles)},
                                             {"misses", work(picture, &PacketWork::misses)},
                                             {"clocks", clocks(picture)},
                                             {"distance", distance(loaded, picture)},
                                             {"cosine", cosine(loaded, picture)}};
  if (name == "clocks" && !picture.watched->run.cycles) {
    refuse(
        "the clocks of configuration {} are not known, as it has no schedules; take a "
        "configuration whose Verilog was built",
        picture.frame.core.name);
  }
  if (name == "wrong") {
    answer.words = verdicts(picture, answer.head);
  } else if (name == "normals") {
    answer.words = normals(loaded, picture);
  } else {
    answer.words = values(picture, of.at(name), answer.head);
  }
  return answer;
}

}  // namespace dynrt::host
