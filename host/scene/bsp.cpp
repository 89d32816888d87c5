// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/bsp.h"

#include <bit>
#include <cmath>

#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr char kBspEntities[] =
    "{}: the list of entities ends inside an entity; the file is damaged";

constexpr char kBspHeader[] =
    "{}: the map has {} bytes, fewer than the {} of its header; it seems cut off";

constexpr std::uint32_t kVersion = 46;
constexpr std::size_t kHeaderBytes = 8 + 17 * 8;

struct Lump {
  const char* name;
  unsigned number;
  std::size_t record_bytes;
};
constexpr Lump kEntities{"entities", 0, 1};
constexpr Lump kTextures{"textures", 1, 72};
constexpr Lump kModels{"models", 7, 40};
constexpr Lump kVertices{"vertices", 10, 44};
constexpr Lump kMeshVertices{"mesh vertices", 11, 4};
constexpr Lump kFaces{"faces", 13, 104};
constexpr Lump kLightmaps{"lightmaps", 14, BspMap::kLightmapSide* BspMap::kLightmapSide * 3};

// Little-endian numbers at byte offsets of one record.
class Record {
 public:
  explicit Record(std::string_view bytes) : bytes_(bytes) {}

  std::uint8_t byte(std::size_t at) const { return static_cast<std::uint8_t>(bytes_[at]); }
  std::uint32_t word(std::size_t at) const {
    return byte(at) | std::uint32_t{byte(at + 1)} << 8 | std::uint32_t{byte(at + 2)} << 16 |
           std::uint32_t{byte(at + 3)} << 24;
  }
  std::int32_t integer(std::size_t at) const { return static_cast<std::int32_t>(word(at)); }
  double real(std::size_t at) const { return std::bit_cast<float>(word(at)); }

 private:
  std::string_view bytes_;
};

class BspReader {
 public:
  BspReader(std::string_view bytes, const std::string& label) : bytes_(bytes), label_(label) {}

  BspMap run() {
    if (!bytes_.starts_with("IBSP")) {
      refuse("{}: not a Quake 3 map: the file must begin with 'IBSP' and the version 46", label_);
    }
    if (bytes_.size() < 8) refuse(kBspHeader, label_, bytes_.size(), kHeaderBytes);
    const std::uint32_t version = Record(bytes_).word(4);
    if (version != kVersion) {
      refuse("{}: the map has version {}; dynrt reads only version {}, that of Quake 3", label_,
             version, kVersion);
    }
    if (bytes_.size() < kHeaderBytes) {
      refuse(kBspHeader, label_, bytes_.size(), kHeaderBytes);
    }
    textures();
    vertices();
    lightmaps();
    faces();
    models();
    entities();
    return std::move(map_);
  }

 private:
  std::string_view lump(const Lump& lump) const {
    const Record header(bytes_.substr(8 + 8 * std::size_t{lump.number}, 8));
    const std::size_t begin = header.word(0), length = header.word(4);
    if (begin > bytes_.size() || length > bytes_.size() - begin) {
      refuse("{}: the map's {} lie in bytes {} to {}, but it has {} bytes; it seems cut off",
             label_, lump.name, begin, begin + length, bytes_.size());
    }
    if (length % lump.record_bytes != 0) {
      refuse("{}: the map's {} take {} bytes, which is not a multiple of {}; the file is damaged",
             label_, lump.name, length, lump.record_bytes);
    }
    return bytes_.substr(begin, length);
  }

  std::vector<Record> records(const Lump& of) const {
    std::vector<Record> records;
    for (std::string_view rest = lump(of); !rest.empty(); rest.remove_prefix(of.record_bytes)) {
      records.emplace_back(rest.substr(0, of.record_bytes));
    }
    return records;
  }

  void textures() {
    for (std::string_view rest = lump(kTextures); !rest.empty(); rest.remove_prefix(72)) {
      const std::string_view name = rest.substr(0, 64);
      map_.textures.push_back(
          {std::string(name.substr(0, name.find('\0'))), Record(rest).word(64)});
    }
  }

  void vertices() {
    for (const Record& r : records(kVertices)) {
      BspVertex vertex{{r.real(0), r.real(4), r.real(8)}, {r.real(20), r.real(24)}, {}};
      const glm::dvec3& p = vertex.position;
      if (!std::isfinite(p.x + p.y + p.z)) {
        refuse("{}: vertex {} is not finite; the file is damaged", label_, map_.vertices.size());
      }
      // Map compilers leave anything at vertices that have no lightmap.
      if (!std::isfinite(vertex.lightmap.x + vertex.lightmap.y)) vertex.lightmap = {0.0, 0.0};
      vertex.colour = glm::dvec3(r.byte(40), r.byte(41), r.byte(42)) / 255.0;
      map_.vertices.push_back(vertex);
    }
  }

  void lightmaps() {
    for (std::string_view rest = lump(kLightmaps); !rest.empty();
         rest.remove_prefix(kLightmaps.record_bytes)) {
      map_.lightmaps.emplace_back(rest.substr(0, kLightmaps.record_bytes));
    }
  }

  // Throws unless [first, first + count) exists, of `all`.
  void require(std::size_t face, const char* what, std::int64_t first, std::int64_t count,
               std::size_t all) const {
    if (first < 0 || count < 0 || first + count > static_cast<std::int64_t>(all)) {
      refuse("{}: face {} uses {} {} to {}, but there are {}; the file is damaged", label_, face,
             what, first, first + count - 1, all);
    }
  }

  void faces() {
    const std::vector<Record> mesh_vertices = records(kMeshVertices);
    for (const Record& r : records(kFaces)) {
      const std::size_t number = map_.faces.size();
      BspFace face;
      const std::uint32_t type = r.word(8);
      if (type < BspFace::kPolygon || type > BspFace::kBillboard) {
        refuse(
            "{}: face {} is of type {}; types are 1 (polygon), 2 (patch), 3 (mesh) and 4 "
            "(billboard)",
            label_, number, type);
      }
      face.type = static_cast<BspFace::Type>(type);
      require(number, "texture", r.integer(0), 1, map_.textures.size());
      face.texture = r.word(0);
      face.first_vertex = r.word(12);
      const std::uint32_t vertices = r.word(16);
      require(number, "vertices", r.integer(12), r.integer(16), map_.vertices.size());
      face.lightmap = r.integer(28) < 0 ? -1 : r.integer(28);
      if (face.lightmap >= 0) {
        require(number, "lightmap", face.lightmap, 1, map_.lightmaps.size());
      }
      if (face.type == BspFace::kPatch) {
        face.patch = {r.word(96), r.word(100)};
        const auto odd = [](std::uint32_t n) { return n >= 3 && n % 2 == 1; };
        if (!odd(face.patch.x) || !odd(face.patch.y) ||
            std::uint64_t{face.patch.x} * face.patch.y != vertices) {
          refuse(
              "{}: face {} is a patch of {} by {} control points and has {}; both sides must be "
              "odd and at least 3, and their product must be that number",
              label_, number, face.patch.x, face.patch.y, vertices);
        }
      } else if (face.type != BspFace::kBillboard) {
        corners(face, number, r, vertices, mesh_vertices);
      }
      map_.faces.push_back(std::move(face));
    }
  }

  void corners(BspFace& face, std::size_t number, const Record& r, std::uint32_t vertices,
               const std::vector<Record>& mesh_vertices) const {
    require(number, "mesh vertices", r.integer(20), r.integer(24), mesh_vertices.size());
    const std::uint32_t first = r.word(20), count = r.word(24);
    if (count % 3 != 0) {
      refuse("{}: face {} has {} corners, which is not a multiple of 3; the file is damaged",
             label_, number, count);
    }
    for (std::uint32_t i = first; i < first + count; ++i) {
      const std::int32_t corner = mesh_vertices[i].integer(0);
      require(number, "corner", corner, 1, vertices);
      face.corners.push_back(static_cast<std::uint32_t>(corner));
    }
  }

  void models() {
    for (const Record& r : records(kModels)) {
      const std::int64_t first = r.integer(24), count = r.integer(28);
      if (first < 0 || count < 0 || first + count > static_cast<std::int64_t>(map_.faces.size())) {
        refuse("{}: model {} uses faces {} to {}, but there are {}; the file is damaged", label_,
               map_.models.size(), first, first + count - 1, map_.faces.size());
      }
      map_.models.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)});
    }
  }

  // { "key" "value" ... } ...; there are no escapes. Words outside braces or quotes are skipped.
  void entities() {
    bool inside = false;
    std::string key;
    bool has_key = false;
    for (std::string_view rest = lump(kEntities); !rest.empty();) {
      const char c = rest.front();
      rest.remove_prefix(1);
      if (c == '{') {
        map_.entities.emplace_back();
        inside = true;
        has_key = false;
      } else if (c == '}') {
        inside = false;
      } else if (c == '"' && inside) {
        const auto end = rest.find('"');
        if (end == rest.npos) refuse(kBspEntities, label_);
        std::string text(rest.substr(0, end));
        rest.remove_prefix(end + 1);
        if (has_key) {
          map_.entities.back()[key] = std::move(text);
        } else {
          key = std::move(text);
        }
        has_key = !has_key;
      }
    }
    if (inside) refuse(kBspEntities, label_);
  }

  const std::string_view bytes_;
  const std::string& label_;
  BspMap map_;
};

}  // namespace

BspMap read_bsp(std::string_view bytes, const std::string& label) {
  return BspReader(bytes, label).run();
}

}  // namespace dynrt::host
