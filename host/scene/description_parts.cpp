// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/description_parts.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <map>
#include <set>

#include "host/error.h"
#include "host/scene/generate.h"
#include "host/scene/map.h"
#include "host/scene/mesh_builder.h"

namespace dynrt::host {

namespace {

constexpr char kNoMaterial[] = "the model has no material '{}'; its materials are {}";

}  // namespace

Mesh PartReader::read(const JsonReader& part) {
  if (part.has("model")) return model(part);
  if (part.has("map")) return map(part);
  if (part.has("generate")) return generated(part);
  if (part.has("primitive")) return primitive(part);
  part.refuse("a part needs one of the keys 'model', 'map', 'generate' and 'primitive'");
}

glm::dvec3 PartReader::colour(const JsonReader& at, const std::string& key) const {
  if (at.has(key) && at.is_text(key)) {
    const std::string name = at.text(key);
    const auto colours =
        file_.has("colours") ? std::optional(file_.object("colours")) : std::nullopt;
    if (!colours || !colours->has(name)) at.refuse("'{}' is not a colour of this file", name);
    return colour(*colours, name);
  }
  const glm::dvec3 rgb = at.vector(key);
  if (glm::any(glm::lessThan(rgb, glm::dvec3(0.0))) ||
      glm::any(glm::greaterThan(rgb, glm::dvec3(1.0)))) {
    at.refuse("'{}' must be three numbers from 0 to 1", key);
  }
  return rgb;
}

// Colours in place of the materials' own, by the material's name: where the model has a texture.
void PartReader::repaint(const JsonReader& colours, Scene& model) const {
  for (const std::string& name : colours.keys()) {
    const auto material = std::find_if(model.materials.begin(), model.materials.end(),
                                       [&](const Material& m) { return m.name == name; });
    if (material == model.materials.end()) {
      std::vector<std::string> names;
      for (const Material& m : model.materials) names.push_back(m.name);
      colours.refuse(kNoMaterial, name, fmt::join(names, ", "));
    }
    material->diffuse = colour(colours, name);
  }
}

// The names in "mirror": materials of a model, textures of a map. A map has many materials of a
// name.
void PartReader::polish(const JsonReader& part, Scene& model) const {
  if (!part.has("mirror")) return;
  std::set<std::string> names;
  for (const Material& material : model.materials) names.insert(material.name);
  for (const std::string& name : part.texts("mirror")) {
    if (!names.contains(name)) {
      part.refuse(kNoMaterial, name, fmt::join(names, ", "));
    }
    for (Material& material : model.materials) {
      if (material.name == name) material.mirror = kMirrorShare;
    }
  }
}

// The one object of a scene, whose materials become the whole's.
Mesh PartReader::take(Scene&& part, const std::string& prefix) {
  const auto first = static_cast<std::uint32_t>(scene_.materials.size());
  for (Material& material : part.materials) {
    material.name = prefix + "/" + material.name;
    scene_.materials.push_back(std::move(material));
  }
  for (std::uint32_t& material : part.objects[0].material) material += first;
  scene_.dropped.zero_area_triangles += part.dropped.zero_area_triangles;
  scene_.dropped.points_and_lines += part.dropped.points_and_lines;
  std::move(part.notes.begin(), part.notes.end(), std::back_inserter(scene_.notes));
  return std::move(part.objects[0]);
}

Mesh PartReader::model(const JsonReader& part) {
  part.only({"model", "position", "turn", "size", "colours", "mirror"});
  if (!furniture_) furniture_.emplace(packages_.furniture);
  const std::string id = part.text("model");
  const auto entry = furniture_->find(id);
  if (!entry) {
    refuse("{}: {}: the package sweethome3d-furniture has no model with the catalogue id '{}'",
           part.file(), part.where(), id);
  }
  std::optional<glm::dvec3> size;
  if (part.has("size")) {
    size = part.vector("size");
    if (!glm::all(glm::greaterThan(*size, glm::dvec3(0.0)))) {
      part.refuse("'size' must be three numbers above zero");
    }
  }
  Scene model = furniture_->load(*entry, size);
  if (part.has("colours")) repaint(part.object("colours"), model);
  polish(part, model);
  return take(std::move(model), id);
}

Mesh PartReader::map(const JsonReader& part) {
  part.only(
      {"map", "tessellation", "scale", "baked_light", "colours", "mirror", "position", "turn"});
  std::map<std::string, glm::dvec3> colours;
  if (part.has("colours")) {
    const JsonReader list = part.object("colours");
    for (const std::string& texture : list.keys()) colours[texture] = colour(list, texture);
  }
  std::set<std::string> met;
  MapOptions options;
  if (part.has("tessellation")) {
    options.tessellation = part.integer("tessellation", 1, kFinestTessellation);
  }
  options.baked_light = part.flag("baked_light", options.baked_light);
  options.colour = [&](const std::string& texture) {
    met.insert(texture);
    const auto found = colours.find(texture);
    return found == colours.end() ? Material().diffuse : found->second;
  };
  const std::string name = part.text("map");
  Scene map = load_package_map(name, options, packages_.maps);
  for (const auto& [texture, unused] : colours) {
    if (!met.contains(texture)) {
      part.object("colours").refuse("the map has no texture '{}'; its textures are {}", texture,
                                    fmt::join(met, ", "));
    }
  }
  const double scale = part.has("scale") ? part.positive("scale") : 1.0;
  for (glm::dvec3& vertex : map.objects[0].vertices) vertex *= scale;
  polish(part, map);
  return take(std::move(map), name);
}

Mesh PartReader::generated(const JsonReader& part) {
  const std::string shape = part.text("generate");
  scene_.materials.push_back({part.text("name", shape), colour(part, "colour"),
                              part.flag("mirror", false) ? kMirrorShare : 0.0});
  const auto material = static_cast<std::uint32_t>(scene_.materials.size() - 1);
  if (shape == "box") {
    part.only({"generate", "name", "colour", "mirror", "from", "to", "position", "turn"});
    const glm::dvec3 low = part.vector("from"), high = part.vector("to");
    if (!glm::all(glm::lessThan(low, high))) part.refuse("'from' must be below 'to' on every axis");
    return make_box(low, high, material);
  }
  if (shape == "sphere") {
    part.only(
        {"generate", "name", "colour", "mirror", "radius", "subdivisions", "position", "turn"});
    return make_sphere(part.positive("radius"), part.integer("subdivisions", 0, 6), material);
  }
  if (shape == "torus") {
    part.only({"generate", "name", "colour", "mirror", "major_radius", "minor_radius", "segments",
               "sides", "position", "turn"});
    return make_torus(part.positive("major_radius"), part.positive("minor_radius"),
                      part.integer("segments", 3, 512), part.integer("sides", 3, 512), material);
  }
  if (shape == "hills") {
    part.only(
        {"generate", "name", "colour", "mirror", "side", "height", "cells", "position", "turn"});
    return make_hills(part.positive("side"), part.number("height"), part.integer("cells", 1, 250),
                      material);
  }
  part.refuse("dynrt cannot generate '{}'; it generates sphere, box, torus and hills", shape);
}

Mesh PartReader::primitive(const JsonReader& part) {
  const std::string shape = part.text("primitive");
  scene_.materials.push_back({part.text("name", shape), colour(part, "colour"),
                              part.flag("mirror", false) ? kMirrorShare : 0.0});
  const auto material = static_cast<std::uint32_t>(scene_.materials.size() - 1);
  Mesh mesh;
  if (shape == "sphere") {
    part.only({"primitive", "name", "colour", "mirror", "radius", "radii", "position", "turn"});
    if (part.has("radius") == part.has("radii")) {
      part.refuse("a sphere has either a 'radius' or three 'radii'");
    }
    const glm::dvec3 radii =
        part.has("radii") ? part.vector("radii") : glm::dvec3(part.positive("radius"));
    if (!glm::all(glm::greaterThan(radii, glm::dvec3(0.0)))) {
      part.refuse("'radii' must be three numbers above zero");
    }
    if (part.flag("mirror", false)) {
      part.refuse(
          "a sphere that is a primitive cannot be a 'mirror', as each of its points would reflect "
          "in another direction; generate a sphere of triangles");
    }
    mesh.ellipsoids.push_back({glm::scale(glm::dmat4(1.0), radii), material});
    return mesh;
  }
  if (shape == "rectangle") {
    part.only(
        {"primitive", "name", "colour", "mirror", "corner", "across", "along", "position", "turn"});
    const Rectangle rectangle{part.vector("corner"), part.vector("across"), part.vector("along"),
                              material};
    if (has_zero_area(glm::dvec3(0.0), rectangle.across, rectangle.along)) {
      part.refuse("'across' and 'along' must not be zero and must not lie on one line");
    }
    mesh.rectangles.push_back(rectangle);
    return mesh;
  }
  part.refuse("'{}' is not a primitive; the primitives are sphere and rectangle", shape);
}

}  // namespace dynrt::host
