// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The models of the Debian package sweethome3d-furniture. A library is a zip file (.sh3f) with
// OBJ models and a catalogue, PluginFurnitureCatalog.properties, of lines like `width#47=63.5`.
// A model is turned as the catalogue says (modelRotation) and its bounding box scaled to the
// catalogue's width x height x depth, as Sweet Home 3D does it.
#pragma once

#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>

#include "host/scene/scene.h"

namespace dynrt::host {

inline constexpr char kFurnitureFolder[] = "/usr/share/sweethome3d/furniture";

struct FurnitureEntry {
  std::string id;        ///< "Scopia#office_chair"
  std::string library;   ///< path of the zip file
  std::string model;     ///< path of the OBJ in it
  std::string creator;   ///< as the catalogue names it
  glm::dvec3 size{0.0};  ///< x width, y height, z depth; in metres (the catalogue: centimetres)
  glm::dmat3 rotation{1.0};
};

class Furniture {
 public:
  /// Reads the catalogues of all libraries. Throws UserError with the command that installs the
  /// package when the folder has none.
  explicit Furniture(const std::string& folder = kFurnitureFolder);

  /// Nothing if no catalogue has the id; throws UserError if its entry cannot be used.
  std::optional<FurnitureEntry> find(const std::string& id) const;

  /// One object, one instance. The object stands on y = 0, centred on x = z = 0, its front towards
  /// +z, with the bounding box of the catalogue, or of `size` in metres.
  Scene load(const FurnitureEntry& entry, std::optional<glm::dvec3> size = {}) const;

 private:
  struct Keys {
    std::string library;
    std::map<std::string, std::string, std::less<>> text;  ///< of one entry: "width" -> "63.5"
  };

  void read_catalogue(const std::string& library);

  std::map<std::string, Keys> entries_;  ///< by id
};

}  // namespace dynrt::host
