// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "host/scene/check_file.h"
#include "host/scene/json_reader.h"
#include "host/scene/scene_messages.h"

namespace dynrt::host {

namespace {

constexpr std::size_t kDeepestNode = 256;

std::uint32_t little_endian(std::string_view text, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t b = 0; b < 4; ++b) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + b])) << (8 * b);
  }
  return value;
}

/// The JSON chunk of a GLB file: 12 bytes of header (magic, version, length), then the chunk's
/// length, its type and its text. Nothing where the file ends before: Assimp refuses that.
std::string_view json_chunk(std::string_view text) {
  constexpr std::size_t kLength = 12, kHeader = 20;
  if (text.size() < kHeader) return {};
  const std::uint32_t length = little_endian(text, kLength);
  return length > text.size() - kHeader ? std::string_view() : text.substr(kHeader, length);
}

/// Follows each node up to its root.
void check_depth(const nlohmann::json& nodes, const std::string& path) {
  constexpr std::size_t kNone = SIZE_MAX;
  std::vector<std::size_t> parent(nodes.size(), kNone);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!nodes[n].is_object() || !nodes[n].contains("children")) continue;
    for (const nlohmann::json& child : nodes[n]["children"]) {
      if (child.is_number_unsigned() && child.get<std::size_t>() < nodes.size()) {
        parent[child.get<std::size_t>()] = n;
      }
    }
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    std::size_t depth = 0;
    for (std::size_t at = n; at != kNone; at = parent[at]) {
      if (++depth <= kDeepestNode) continue;
      const bool named = nodes[n].contains("name") && nodes[n]["name"].is_string();
      wording::fail(wording::kNodesDeep, path,
                    named ? nodes[n]["name"].get<std::string>() : std::to_string(n), kDeepestNode);
    }
  }
}

/// The element of an array, or null.
const nlohmann::json& element(const nlohmann::json& json, const char* array, const char* index,
                              const nlohmann::json& of) {
  static const nlohmann::json kNone;
  const auto at = json.find(array);
  if (at == json.end() || !at->is_array() || !of.is_object() || !of.contains(index)) return kNone;
  const nlohmann::json& number = of[index];
  if (!number.is_number_unsigned() || number.get<std::size_t>() >= at->size()) return kNone;
  return (*at)[number.get<std::size_t>()];
}

/// Assimp makes up a keyframe where an accessor has none.
void check_keyframes(const nlohmann::json& json, const std::string& path) {
  const auto animations = json.find("animations");
  if (animations == json.end() || !animations->is_array()) return;
  for (const nlohmann::json& animation : *animations) {
    if (!animation.is_object() || !animation.contains("channels")) continue;
    for (const nlohmann::json& channel : animation["channels"]) {
      const nlohmann::json& sampler = element(animation, "samplers", "sampler", channel);
      const nlohmann::json& times = element(json, "accessors", "input", sampler);
      if (!times.is_object() || times.value("count", nlohmann::json(1)) != 0) continue;
      const nlohmann::json target = channel.value("target", nlohmann::json::object());
      const nlohmann::json& node = element(json, "nodes", "node", target);
      const bool named = node.is_object() && node.contains("name") && node["name"].is_string();
      wording::fail(wording::kChannelEmpty, path,
                    named ? node["name"].get<std::string>() : target.value("node", target).dump());
    }
  }
}

/// Assimp 5.2 crashes where a skin has none, which the format allows.
void check_skins(const nlohmann::json& json, const std::string& path) {
  const auto skins = json.find("skins");
  if (skins == json.end() || !skins->is_array()) return;
  for (std::size_t s = 0; s < skins->size(); ++s) {
    const nlohmann::json& skin = (*skins)[s];
    if (skin.is_object() && !skin.contains("inverseBindMatrices")) {
      wording::fail(wording::kSkinWithoutMatrices, path, s);
    }
  }
}

}  // namespace

void check_gltf(std::string_view text, const std::string& path) {
  if (text.starts_with("glTF")) text = json_chunk(text);
  if (text.empty()) return;
  const nlohmann::json json = parse_json(text, path);
  const auto nodes = json.find("nodes");
  if (nodes != json.end() && nodes->is_array()) check_depth(*nodes, path);
  if (!json.is_object()) return;
  check_keyframes(json, path);
  check_skins(json, path);
}

}  // namespace dynrt::host
