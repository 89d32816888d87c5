// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/way.h"

#include <array>
#include <map>
#include <optional>

namespace dynrt::host {

namespace {

constexpr std::array kEvents = {"rays", "node", "list", "entry", "box", "object", "triangle"};

/// Follows a packet's steps and knows where each node lies.
class Guide {
 public:
  Guide(const LoadedScene& loaded, const FullPicture& picture)
      : image_(loaded.image()), frame_(picture.image), owners_(picture.owners) {
    enter_world();
  }

  Json step(const PacketStep& step) {
    Json json = {{"event", kEvents[static_cast<std::size_t>(step.event)]},
                 {"clock", step.clock},
                 {"number", step.number},
                 {"top", step.top}};
    switch (step.event) {
      case PacketEvent::kRays:
        enter_world();
        break;
      case PacketEvent::kNode:
        add_node(step, json);
        break;
      case PacketEvent::kObject:
        add_object(step, json);
        break;
      case PacketEvent::kTriangle:
        add_triangle(step, json);
        break;
      default:
        break;
    }
    return json;
  }

 private:
  /// A tree, and the boxes of those nodes whose parents the packet has met.
  struct Level {
    glm::dmat4 to_world{1.0};  ///< of the core's space
    Aabb box{};
    std::map<std::uint32_t, Aabb> boxes{};
  };

  void enter_world() {
    levels_[0] = {.box = image_.trees.instances.box};
    instance_.reset();
  }

  const MemoryNode* node_at(std::uint32_t address) const {
    for (const MemoryPart* part : {&frame_.memory, &image_.objects.memory}) {
      if (address >= part->first_node && address < part->end_node()) {
        return &part->nodes[address - part->first_node];
      }
    }
    return nullptr;
  }

  void add_node(const PacketStep& step, Json& json) {
    Level& level = levels_[step.top ? 0 : 1];
    const auto known = level.boxes.find(step.number);
    const Aabb box = known == level.boxes.end() ? level.box : known->second;
    json["box"] = corners_of(level, box);
    const MemoryNode* node = node_at(step.number);
    if (node == nullptr || node->kind == NodeKind::kLeaf) return;
    const auto axis = static_cast<int>(node->kind);
    json["axis"] = axis;
    Aabb left = box, right = box;
    left.high[axis] = right.low[axis] = node->split;
    level.boxes.insert_or_assign(node->left, left);
    level.boxes.insert_or_assign(node->right, right);
  }

  void add_object(const PacketStep& step, Json& json) {
    instance_ = owners_.instance_of(step.number);
    if (!instance_) return;
    const Instance& instance = image_.scene.instances[*instance_];
    const ObjectImage::Object& object = image_.objects.objects[instance.object];
    Level level{.to_world = instance.transform, .box = object.box};
    json["name"] = image_.scene.objects[instance.object].name;
    json["box"] = corners_of(level, level.box);
    levels_[1] = std::move(level);
  }

  void add_triangle(const PacketStep& step, Json& json) const {
    if (!instance_) return;
    const Instance& instance = image_.scene.instances[*instance_];
    const auto primitive = owners_.primitive_of(instance.object, step.number);
    if (!primitive) return;
    const Mesh& mesh = image_.scene.objects[instance.object];
    json["primitive"] = *primitive;
    if (mesh.is_ellipsoid(*primitive)) return;
    Json corners = Json::array();
    for (const glm::dvec3& corner : mesh.corners(*primitive)) {
      corners.push_back(in_file(glm::dvec3(instance.transform * glm::dvec4(corner, 1.0))));
    }
    json["corners"] = std::move(corners);
  }

  Json in_file(const glm::dvec3& p) const { return json_of(image_.space.outside(p)); }

  Json corners_of(const Level& level, const Aabb& box) const {
    Json corners = Json::array();
    for (unsigned i = 0; i < 8; ++i) {
      const glm::dvec3 corner((i & 1 ? box.high : box.low).x, (i & 2 ? box.high : box.low).y,
                              (i & 4 ? box.high : box.low).z);
      corners.push_back(in_file(glm::dvec3(level.to_world * glm::dvec4(corner, 1.0))));
    }
    return corners;
  }

  const MemoryImage& image_;
  const FrameImage& frame_;
  const MatrixOwners& owners_;
  std::array<Level, 2> levels_{};
  std::optional<std::uint32_t> instance_{};
};

}  // namespace

Json way_json(const LoadedScene& loaded, const FullPicture& picture, const PacketWork& packet) {
  Guide guide(loaded, picture);
  Json way = Json::array();
  for (const PacketStep& step : packet.way) way.push_back(guide.step(step));
  return way;
}

}  // namespace dynrt::host
