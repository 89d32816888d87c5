// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/furniture.h"

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <set>
#include <system_error>

#include "host/error.h"
#include "host/scene/camera.h"
#include "host/scene/import.h"
#include "host/scene/mesh_builder.h"
#include "host/scene/scene_messages.h"
#include "host/scene/text_lines.h"
#include "host/scene/zip_library.h"

namespace dynrt::host {

namespace {

constexpr char kCatalogueKey[] =
    "{}: the catalogue's entry '{}' has no usable '{}'; reinstall the package "
    "sweethome3d-furniture";

constexpr char kCatalogue[] = "PluginFurnitureCatalog.properties";
constexpr char kRemedy[] = "reinstall the package sweethome3d-furniture";
constexpr double kMetres = 0.01;

// The nine numbers of modelRotation are the rows of the matrix.
std::optional<glm::dmat3> rotation(std::string_view text) {
  glm::dmat3 matrix(1.0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const auto number = to_number(take_word(text));
      if (!number) return std::nullopt;
      matrix[column][row] = *number;
    }
  }
  return matrix;
}

}  // namespace

Furniture::Furniture(const std::string& folder) {
  std::set<std::string> libraries;  // sorted: the same order on every machine
  std::error_code missing;
  for (const auto& file : std::filesystem::directory_iterator(folder, missing)) {
    if (file.path().extension() == ".sh3f") libraries.insert(file.path().string());
  }
  if (libraries.empty()) {
    refuse(
        "the models of this scene come from the Debian package sweethome3d-furniture, which is not "
        "installed ({} has no .sh3f file); install it with: apt-get install sweethome3d-furniture",
        folder);
  }
  for (const std::string& library : libraries) read_catalogue(library);
}

void Furniture::read_catalogue(const std::string& library) {
  const auto text = ZipLibrary(library, kRemedy).read(kCatalogue);
  if (!text) {
    refuse(messages::kBadLibrary, library, std::string("it does not hold ") + kCatalogue, kRemedy);
  }
  std::map<std::string, Keys> models;  // by the number behind '#'
  for (std::string_view rest = *text; !rest.empty();) {
    std::string_view line = trim(take_until(rest, '\n'));
    if (line.starts_with('#') || line.starts_with('!')) continue;
    std::string_view key = take_until(line, '=');
    const std::string_view name = trim(take_until(key, '#'));
    if (!key.empty()) models[std::string(trim(key))].text[std::string(name)] = trim(line);
  }
  for (auto& [number, keys] : models) {
    const auto id = keys.text.find("id");
    if (id == keys.text.end() || !keys.text["model"].ends_with(".obj")) continue;
    keys.library = library;
    entries_.emplace(id->second, std::move(keys));
  }
}

std::optional<FurnitureEntry> Furniture::find(const std::string& id) const {
  const auto found = entries_.find(id);
  if (found == entries_.end()) return std::nullopt;
  const auto& [library, keys] = found->second;
  const auto text = [&](std::string_view key) {
    const auto value = keys.find(key);
    return value == keys.end() ? std::string() : value->second;
  };
  const auto metres = [&](std::string_view key) {
    const auto number = to_number(text(key));
    if (!number || !(*number > 0.0)) {
      refuse(kCatalogueKey, found->second.library, id, key);
    }
    return *number * kMetres;
  };
  FurnitureEntry entry;
  entry.id = id;
  entry.library = library;
  entry.model = text("model");
  if (entry.model.starts_with('/')) entry.model.erase(0, 1);
  entry.creator = text("creator");
  entry.size = {metres("width"), metres("height"), metres("depth")};
  if (keys.contains("modelRotation")) {
    const auto matrix = rotation(text("modelRotation"));
    if (!matrix) refuse(kCatalogueKey, library, id, "modelRotation");
    entry.rotation = *matrix;
  }
  return entry;
}

Scene Furniture::load(const FurnitureEntry& entry, std::optional<glm::dvec3> size) const {
  ZipLibrary library(entry.library, kRemedy);
  const std::string label = entry.library + ":" + entry.model;
  const auto text = library.read(entry.model);
  if (!text) refuse(messages::kBadLibrary, entry.library, entry.model + " is missing", kRemedy);
  // Descriptions give the catalogue's materials their colours by name.
  Scene scene = import_obj(library, entry.model, *text, label, Textures::kIgnored);

  scene.instances[0].transform = glm::dmat4(entry.rotation);
  const Box box = bounds(scene);
  const glm::dvec3 wanted = size.value_or(entry.size);
  glm::dmat4 scale(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = box.high[axis] - box.low[axis];
    if (extent > 0.0) scale[axis][axis] = wanted[axis] / extent;
  }
  const glm::dvec3 foot((box.low.x + box.high.x) / 2.0, box.low.y, (box.low.z + box.high.z) / 2.0);
  glm::dmat4 to_foot(1.0);
  to_foot[3] = glm::dvec4(-foot, 1.0);
  MeshBuilder builder(entry.id);
  builder.append(scene.objects[0], scale * to_foot * scene.instances[0].transform);
  scene.objects[0] = builder.take();
  scene.instances[0] = {entry.id, 0, glm::dmat4(1.0)};
  scene.name = entry.id;
  return scene;
}

}  // namespace dynrt::host
