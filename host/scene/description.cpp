// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/description.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <optional>

#include "host/scene/camera.h"
#include "host/scene/generate.h"
#include "host/scene/import.h"
#include "host/scene/json_reader.h"
#include "host/scene/mesh_builder.h"
#include "host/scene/wording.h"

namespace dynrt::host {

namespace {

constexpr glm::dvec3 kUp{0.0, 1.0, 0.0};

class Description {
 public:
  Description(const JsonReader& file, std::string furniture_folder)
      : file_(file), furniture_folder_(std::move(furniture_folder)) {}

  Scene run() {
    file_.only({"about", "colours", "objects", "instances", "camera"});
    scene_.name = std::filesystem::path(file_.file()).stem().string();
    for (const JsonReader& object : file_.objects("objects")) add_object(object);
    if (file_.has("instances")) {
      for (const JsonReader& instance : file_.objects("instances")) add_instance(instance);
    } else {
      for (const auto& [name, index] : object_of_) {
        scene_.instances.push_back({name, index, glm::dmat4(1.0)});
      }
    }
    if (scene_.instances.empty()) {
      wording::fail(wording::kNoTriangles, file_.file(), scene_.dropped.zero_area_triangles,
                    scene_.dropped.points_and_lines);
    }
    require_every_object_used();
    if (file_.has("camera")) add_camera(file_.object("camera"));
    return std::move(scene_);
  }

 private:
  [[noreturn]] static void fail(const JsonReader& at, const std::string& sentence) {
    wording::fail(wording::kDescription, at.file(), at.where(), sentence);
  }

  // A name of the file's "colours" or three numbers in [0, 1].
  glm::dvec3 colour(const JsonReader& part, const std::string& key) const {
    if (part.has(key) && part.is_text(key)) {
      const std::string name = part.text(key);
      const auto colours =
          file_.has("colours") ? std::optional(file_.object("colours")) : std::nullopt;
      if (!colours || !colours->has(name)) {
        fail(part, fmt::format(wording::kNoColour, name));
      }
      return colour(*colours, name);
    }
    const glm::dvec3 rgb = part.vector(key);
    if (glm::any(glm::lessThan(rgb, glm::dvec3(0.0))) ||
        glm::any(glm::greaterThan(rgb, glm::dvec3(1.0)))) {
      fail(part, fmt::format(wording::kColourRange, key));
    }
    return rgb;
  }

  uint32_t add_material(const JsonReader& part, const std::string& name) {
    scene_.materials.push_back({name, colour(part, "colour")});
    return static_cast<uint32_t>(scene_.materials.size() - 1);
  }

  static glm::dmat4 placement(const JsonReader& part) {
    const glm::dmat4 moved =
        glm::translate(glm::dmat4(1.0), part.vector("position", glm::dvec3(0.0)));
    return glm::rotate(moved, glm::radians(part.number("turn", 0.0)), kUp);
  }

  void add_object(const JsonReader& object) {
    object.only({"name", "parts"});
    const std::string name = object.text("name");
    if (object_of_.contains(name)) fail(object, fmt::format(wording::kTwice, name));
    MeshBuilder builder(name);
    for (const JsonReader& part : object.objects("parts")) {
      builder.append(part.has("model") ? model(part) : generated(part), placement(part));
    }
    Mesh mesh = builder.take();
    if (mesh.triangles.empty()) fail(object, fmt::format(wording::kNoParts, name));
    object_of_[name] = static_cast<uint32_t>(scene_.objects.size());
    scene_.objects.push_back(std::move(mesh));
  }

  Mesh model(const JsonReader& part) {
    part.only({"model", "position", "turn", "size", "colours"});
    if (!furniture_) furniture_.emplace(furniture_folder_);
    const std::string id = part.text("model");
    const auto entry = furniture_->find(id);
    if (!entry) wording::fail(wording::kNoModel, part.file(), part.where(), id);
    std::optional<glm::dvec3> size;
    if (part.has("size")) {
      size = part.vector("size");
      if (!glm::all(glm::greaterThan(*size, glm::dvec3(0.0)))) fail(part, wording::kSize);
    }
    Scene model = furniture_->load(*entry, size);
    if (part.has("colours")) repaint(part.object("colours"), model);
    const auto first = static_cast<uint32_t>(scene_.materials.size());
    for (Material& material : model.materials) {
      scene_.materials.push_back({id + "/" + material.name, material.diffuse});
    }
    for (uint32_t& material : model.objects[0].material) material += first;
    scene_.dropped.zero_area_triangles += model.dropped.zero_area_triangles;
    scene_.dropped.points_and_lines += model.dropped.points_and_lines;
    std::move(model.notes.begin(), model.notes.end(), std::back_inserter(scene_.notes));
    return std::move(model.objects[0]);
  }

  // Colours in place of the materials' own, by the material's name: where the model has a texture.
  void repaint(const JsonReader& colours, Scene& model) const {
    for (const std::string& name : colours.keys()) {
      const auto material = std::find_if(model.materials.begin(), model.materials.end(),
                                         [&](const Material& m) { return m.name == name; });
      if (material == model.materials.end()) {
        std::vector<std::string> names;
        for (const Material& m : model.materials) names.push_back(m.name);
        fail(colours, fmt::format(wording::kNoMaterial, name, fmt::join(names, ", ")));
      }
      material->diffuse = colour(colours, name);
    }
  }

  Mesh generated(const JsonReader& part) {
    if (!part.has("generate")) fail(part, wording::kPartKind);
    const std::string shape = part.text("generate");
    const uint32_t material = add_material(part, part.text("name", shape));
    if (shape == "box") {
      part.only({"generate", "name", "colour", "from", "to", "position", "turn"});
      const glm::dvec3 low = part.vector("from"), high = part.vector("to");
      if (!glm::all(glm::lessThan(low, high))) fail(part, wording::kBoxCorners);
      return make_box(low, high, material);
    }
    if (shape == "sphere") {
      part.only({"generate", "name", "colour", "radius", "subdivisions", "position", "turn"});
      return make_sphere(part.positive("radius"), part.integer("subdivisions", 0, 6), material);
    }
    if (shape == "torus") {
      part.only({"generate", "name", "colour", "major_radius", "minor_radius", "segments", "sides",
                 "position", "turn"});
      return make_torus(part.positive("major_radius"), part.positive("minor_radius"),
                        part.integer("segments", 3, 512), part.integer("sides", 3, 512), material);
    }
    fail(part, fmt::format(wording::kShape, shape));
  }

  void add_instance(const JsonReader& at) {
    at.only({"object", "name", "position", "rotate", "scale", "matrix"});
    const std::string object = at.text("object");
    const auto found = object_of_.find(object);
    if (found == object_of_.end()) fail(at, fmt::format(wording::kNoObject, object));
    Instance instance;
    instance.name = at.text("name", object + "#" + std::to_string(scene_.instances.size()));
    instance.object = found->second;
    instance.transform = transform(at);
    require_inverse(instance, at.file());
    scene_.instances.push_back(std::move(instance));
  }

  // Scaled, then rotated, then moved; or the rows of a 3x4 matrix.
  static glm::dmat4 transform(const JsonReader& at) {
    glm::dmat4 m(1.0);
    if (at.has("matrix")) {
      const std::vector<double> rows = at.numbers("matrix", 12);
      for (int i = 0; i < 12; ++i) m[i % 4][i / 4] = rows[static_cast<std::size_t>(i)];
      return m;
    }
    m = glm::translate(m, at.vector("position", glm::dvec3(0.0)));
    if (at.has("rotate")) {
      const JsonReader rotate = at.object("rotate");
      rotate.only({"axis", "degrees"});
      const glm::dvec3 axis = rotate.vector("axis");
      if (!(glm::length(axis) > 0.0)) fail(rotate, wording::kAxis);
      m = glm::rotate(m, glm::radians(rotate.number("degrees")), glm::normalize(axis));
    }
    return glm::scale(m, at.vector("scale", glm::dvec3(1.0)));
  }

  void require_every_object_used() const {
    for (const auto& [name, index] : object_of_) {
      const uint32_t object = index;
      const bool used = std::any_of(scene_.instances.begin(), scene_.instances.end(),
                                    [&](const Instance& i) { return i.object == object; });
      if (!used) fail(file_, fmt::format(wording::kUnusedObject, name));
    }
  }

  void add_camera(const JsonReader& at) {
    at.only({"position", "look_at", "up", "field_of_view"});
    try {
      scene_.camera = look_at(at.vector("position"), at.vector("look_at"), at.vector("up", kUp),
                              at.number("field_of_view", kDefaultFieldOfView), 1.0);
    } catch (const UserError& error) {
      const std::string text = error.what();
      if (text.starts_with(at.file())) throw;
      fail(at, text);
    }
  }

  const JsonReader& file_;
  const std::string furniture_folder_;
  std::optional<Furniture> furniture_;
  std::map<std::string, uint32_t> object_of_;
  Scene scene_;
};

}  // namespace

Scene load_description(const std::string& path, const std::string& furniture_folder) {
  const JsonReader file = JsonReader::from_file(path);
  return Description(file, furniture_folder).run();
}

}  // namespace dynrt::host
