// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/textures.h"

#include <assimp/scene.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <glm/common.hpp>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "host/picture/image_library.h"
#include "host/picture/srgb.h"
#include "host/scene/text_lines.h"

namespace dynrt::host {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNamed = 3;  // of the textures that cannot be read

/// "my%20wood.png" as a file is called.
std::string without_percents(std::string_view uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto code = uri[i] == '%' ? to_byte(uri.substr(i + 1, 2)) : std::nullopt;
    name += code ? static_cast<char>(*code) : uri[i];
    if (code) i += 2;
  }
  return name;
}

/// The places of a texture: the path in the file, and the folder of the file, as many files keep a
/// path of the machine that made them.
std::vector<std::string> places(const std::string& path, std::string name) {
  std::ranges::replace(name, '\\', '/');
  const fs::path folder = fs::path(path).parent_path();
  std::vector<std::string> places;
  for (const fs::path& file : {fs::path(name), fs::path(without_percents(name))}) {
    places.push_back((folder / file).string());
    places.push_back((folder / file.filename()).string());
  }
  return places;
}

class MeanColours {
 public:
  MeanColours(const aiScene& from, Assimp::IOSystem& files, const std::string& path)
      : from_(from), files_(files), path_(path) {}

  /// The mean colour of a material's texture; nothing when it has none that can be read.
  std::optional<glm::dvec3> of(const aiMaterial& material) {
    aiString name;
    if (material.GetTexture(aiTextureType_BASE_COLOR, 0, &name) != aiReturn_SUCCESS &&
        material.GetTexture(aiTextureType_DIFFUSE, 0, &name) != aiReturn_SUCCESS) {
      return std::nullopt;
    }
    const auto [entry, is_new] = read_.try_emplace(name.C_Str());
    if (is_new) entry->second = read(entry->first);
    return entry->second;
  }

  void note(const std::string& label, Scene& scene) const {
    if (read_.empty()) return;
    scene.notes.push_back(
        fmt::format("{}: the file has {} base colour texture{}; each material gets the mean colour "
                    "of its texture",
                    label, read_.size(), read_.size() == 1 ? "" : "s"));
    if (unread_.empty()) return;
    const std::span<const std::string> named(unread_.data(), std::min(kNamed, unread_.size()));
    scene.notes.push_back(fmt::format(
        "{}: {} of its textures cannot be read, so their materials keep the colours of the file: "
        "{}{}",
        label, unread_.size(), fmt::join(named, ", "), unread_.size() > kNamed ? ", ..." : ""));
  }

 private:
  std::optional<glm::dvec3> read(const std::string& name) {
    const aiTexture* embedded = from_.GetEmbeddedTexture(name.c_str());
    if (embedded != nullptr && embedded->mHeight > 0) return mean_of(*embedded);
    const auto content = embedded != nullptr ? content_of(*embedded) : content_of(name);
    if (!content) return skip(name, "does not exist");
    if (content->empty()) return skip(name, "is empty");
    const MeanColour mean = image_library().mean_colour(*content);
    if (!mean.error.empty()) return skip(name, mean.error);
    const glm::dvec3 colour(mean.linear[0], mean.linear[1], mean.linear[2]);
    if (!std::isfinite(colour.x + colour.y + colour.z)) return skip(name, "is not finite");
    return glm::clamp(colour, 0.0, 1.0);
  }

  static std::vector<std::uint8_t> content_of(const aiTexture& embedded) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(embedded.pcData);
    if (bytes == nullptr) return {};
    return {bytes, bytes + embedded.mWidth};
  }

  std::optional<std::vector<std::uint8_t>> content_of(const std::string& name) const {
    for (const std::string& place : places(path_, name)) {
      std::error_code unreachable;
      if (fs::is_directory(place, unreachable) || !files_.Exists(place.c_str())) continue;
      Assimp::IOStream* stream = files_.Open(place.c_str(), "rb");
      if (stream == nullptr) continue;
      std::vector<std::uint8_t> content(stream->FileSize());
      const std::size_t read = stream->Read(content.data(), 1, content.size());
      files_.Close(stream);
      content.resize(read);
      return content;
    }
    return std::nullopt;
  }

  /// Of texels that lie in the file one by one.
  static glm::dvec3 mean_of(const aiTexture& embedded) {
    const auto& linear = linear_levels();
    const std::size_t texels = std::size_t{embedded.mWidth} * embedded.mHeight;
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < texels; ++i) {
      const aiTexel& texel = embedded.pcData[i];
      sum += glm::dvec3(linear[texel.r], linear[texel.g], linear[texel.b]);
    }
    return sum / static_cast<double>(texels);
  }

  std::nullopt_t skip(const std::string& name, const std::string& reason) {
    unread_.push_back(fmt::format("'{}' ({})", name, reason));
    return std::nullopt;
  }

  const aiScene& from_;
  Assimp::IOSystem& files_;
  const std::string& path_;
  std::map<std::string, std::optional<glm::dvec3>> read_;  // by name
  std::vector<std::string> unread_;
};

}  // namespace

void mix_textures(const aiScene& from, Assimp::IOSystem& files, const std::string& path,
                  const std::string& label, Scene& scene) {
  MeanColours textures(from, files, path);
  for (unsigned i = 0; i < from.mNumMaterials; ++i) {
    const auto mean = textures.of(*from.mMaterials[i]);
    if (!mean) continue;
    // Programs write black for a colour that nothing is seen of.
    glm::dvec3& colour = scene.materials[i].diffuse;
    colour = colour == glm::dvec3(0.0) ? *mean : colour * *mean;
  }
  textures.note(label, scene);
}

}  // namespace dynrt::host
