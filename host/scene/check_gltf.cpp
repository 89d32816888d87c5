// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "host/error.h"
#include "host/scene/check_file.h"
#include "host/scene/json_reader.h"

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

void put_little_endian(std::string& text, std::size_t at, std::size_t value) {
  for (std::size_t b = 0; b < 4; ++b) text[at + b] = static_cast<char>(value >> (8 * b) & 0xFF);
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
      refuse("{}: node '{}' lies more than {} levels deep or inside itself; flatten the node graph",
             path, named ? nodes[n]["name"].get<std::string>() : std::to_string(n), kDeepestNode);
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
      refuse(
          "{}: node '{}': its animation has no keyframes; add a keyframe or remove the animation",
          path, named ? node["name"].get<std::string>() : target.value("node", target).dump());
    }
  }
}

/// Takes the skins without matrices from the nodes; Assimp 5.2 crashes on such a skin, which the
/// format allows. Returns their number.
std::size_t take_bare_skins(nlohmann::json& json) {
  std::set<nlohmann::json> bare;
  const auto nodes = json.find("nodes");
  if (nodes == json.end() || !nodes->is_array()) return 0;
  for (nlohmann::json& node : *nodes) {
    const nlohmann::json& skin = element(json, "skins", "skin", node);
    if (!skin.is_object() || skin.contains("inverseBindMatrices")) continue;
    bare.insert(node["skin"]);
    node.erase("skin");
  }
  return bare.size();
}

/// A GLB file with another JSON chunk. The chunk's length is a multiple of 4, as GLB 2 demands.
std::string with_json_chunk(std::string_view glb, std::string json) {
  constexpr std::size_t kTotal = 8, kLength = 12, kHeader = 20;
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string_view after = glb.substr(kHeader + little_endian(glb, kLength));
  std::string mended(glb.substr(0, kHeader));
  mended += json;
  mended += after;
  put_little_endian(mended, kTotal, mended.size());
  put_little_endian(mended, kLength, json.size());
  return mended;
}

}  // namespace

MendedGltf mended_gltf(std::string text, const std::string& path) {
  const bool is_binary = text.starts_with("glTF");
  const std::string_view source = is_binary ? json_chunk(text) : std::string_view(text);
  if (source.empty()) return {.text = std::move(text)};
  nlohmann::json json = parse_json(source, path);
  const auto nodes = json.find("nodes");
  if (nodes != json.end() && nodes->is_array()) check_depth(*nodes, path);
  if (!json.is_object()) return {.text = std::move(text)};
  check_keyframes(json, path);
  const std::size_t bare_skins = take_bare_skins(json);
  if (bare_skins == 0) return {.text = std::move(text)};
  return {.text = is_binary ? with_json_chunk(text, json.dump()) : json.dump(),
          .bare_skins = bare_skins};
}

}  // namespace dynrt::host
