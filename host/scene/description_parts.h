// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a scene description's objects: a model of the furniture package, a map, a generated
// shape; and the colours they are given. scenes/README.md has the keys.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "host/scene/description.h"
#include "host/scene/furniture.h"
#include "host/scene/json_reader.h"
#include "host/scene/scene.h"

namespace dynrt::host {

class PartReader {
 public:
  /// Adds materials, notes and counts of left-out primitives to `scene`.
  PartReader(const JsonReader& file, const Packages& packages, Scene& scene)
      : file_(file), packages_(packages), scene_(scene) {}

  /// Throws UserError if the part has a mistake.
  Mesh read(const JsonReader& part);

  /// A name of the file's "colours" or three numbers in [0, 1].
  glm::dvec3 colour(const JsonReader& at, const std::string& key) const;

 private:
  Mesh model(const JsonReader& part);
  Mesh map(const JsonReader& part);
  Mesh generated(const JsonReader& part);
  Mesh primitive(const JsonReader& part);

  void polish(const JsonReader& part, Scene& model) const;
  void repaint(const JsonReader& colours, Scene& model) const;
  Mesh take(Scene&& part, const std::string& prefix);

  const JsonReader& file_;
  const Packages& packages_;
  std::optional<Furniture> furniture_;
  Scene& scene_;
};

}  // namespace dynrt::host
