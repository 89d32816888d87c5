// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <map>

#include "host/error.h"
#include "host/scene/animation.h"
#include "host/scene/camera.h"
#include "host/scene/description_parts.h"
#include "host/scene/import.h"
#include "host/scene/json_reader.h"
#include "host/scene/mesh_builder.h"
#include "host/scene/placement.h"
#include "host/scene/scatter.h"
#include "host/scene/scene_messages.h"

namespace dynrt::host {

namespace {

constexpr int kMostScattered = 1 << 17;  // as many matrices as the board holds
constexpr glm::dvec3 kUp{0.0, 1.0, 0.0};

class Description {
 public:
  Description(const JsonReader& file, const Packages& packages)
      : file_(file), parts_(file, packages, scene_) {}

  Scene run() {
    file_.only({"about", "colours", "objects", "instances", "scatter", "camera", "path", "lights"});
    scene_.name = std::filesystem::path(file_.file()).stem().string();
    for (const JsonReader& object : file_.objects("objects")) add_object(object);
    if (file_.has("instances")) {
      for (const JsonReader& instance : file_.objects("instances")) add_instance(instance);
    } else if (!file_.has("scatter")) {
      for (const auto& [name, index] : object_of_) {
        scene_.instances.push_back({name, index, glm::dmat4(1.0)});
      }
    }
    if (file_.has("scatter")) {
      for (const JsonReader& at : file_.objects("scatter")) add_scattered(at);
    }
    if (scene_.instances.empty()) {
      refuse(messages::kNoTriangles, file_.file(), scene_.dropped.zero_area_triangles,
             scene_.dropped.points_and_lines);
    }
    require_every_object_used();
    if (file_.has("camera")) add_camera(file_.object("camera"));
    if (file_.has("path")) add_path();
    if (file_.has("lights")) {
      for (const JsonReader& light : file_.objects("lights")) add_light(light);
    }
    move_to(scene_, 0.0);
    return std::move(scene_);
  }

 private:
  static glm::dmat4 placement(const JsonReader& part) {
    const glm::dmat4 moved =
        glm::translate(glm::dmat4(1.0), part.vector("position", glm::dvec3(0.0)));
    return glm::rotate(moved, glm::radians(part.number("turn", 0.0)), kUp);
  }

  void add_object(const JsonReader& object) {
    object.only({"name", "parts"});
    const std::string name = object.text("name");
    if (object_of_.contains(name)) object.refuse("there are two objects named '{}'", name);
    MeshBuilder builder(name);
    for (const JsonReader& part : object.objects("parts")) {
      builder.append(parts_.read(part), placement(part));
    }
    Mesh mesh = builder.take();
    if (mesh.primitives() == 0) object.refuse("the object '{}' has no parts", name);
    object_of_[name] = static_cast<std::uint32_t>(scene_.objects.size());
    scene_.objects.push_back(std::move(mesh));
  }

  std::uint32_t object(const JsonReader& at, const char* key) const {
    const std::string name = at.text(key);
    const auto found = object_of_.find(name);
    if (found == object_of_.end()) at.refuse("there is no object '{}'", name);
    return found->second;
  }

  void add_instance(const JsonReader& at) {
    at.only({"object", "name", "position", "turn", "rotate", "scale", "matrix", "motion"});
    Instance instance;
    instance.object = object(at, "object");
    instance.name =
        at.text("name", at.text("object") + "#" + std::to_string(scene_.instances.size()));
    const Placement placement = read_placement(at);
    instance.transform = at.has("matrix") ? matrix(at) : placement.matrix();
    require_inverse(instance, at.file());
    if (at.has("motion")) {
      if (at.has("matrix")) {
        at.refuse(
            "an instance with a 'motion' cannot have a 'matrix'; give position, turn, rotate and "
            "scale");
      }
      instance.motion = static_cast<std::uint32_t>(scene_.motion.size());
      scene_.motion.push_back(read_motion(at.object("motion"), placement));
      scene_.motion.back().name = instance.name;
    }
    scene_.instances.push_back(std::move(instance));
  }

  void add_scattered(const JsonReader& at) {
    at.only({"object", "name", "count", "seed", "from", "to", "scale", "apart", "clear", "ground"});
    Scatter wanted;
    wanted.count = static_cast<std::size_t>(at.integer("count", 1, kMostScattered));
    wanted.seed =
        static_cast<std::uint32_t>(at.integer("seed", 0, std::numeric_limits<int>::max()));
    wanted.from = at.pair("from");
    wanted.to = at.pair("to");
    if (at.has("scale")) wanted.scale = at.pair("scale");
    if (at.has("apart")) wanted.apart = at.positive("apart");
    if (at.has("clear")) wanted.clear = at.vectors("clear");
    const auto above = [](const glm::dvec2& a, const glm::dvec2& b) {
      return glm::all(glm::greaterThan(a, b));
    };
    if (!above(wanted.to, wanted.from)) at.refuse("'from' must be below 'to' on both axes");
    if (!(wanted.scale.x > 0.0 && wanted.scale.y >= wanted.scale.x)) {
      at.refuse("'scale' must be two numbers above zero, the lower one first");
    }
    if (at.has("ground")) wanted.ground = &scene_.objects[object(at, "ground")];
    const std::uint32_t scattered = object(at, "object");
    const std::string name = at.text("name", at.text("object"));
    const std::vector<glm::dmat4> placed = scatter(wanted);
    if (placed.size() < wanted.count) {
      at.refuse(
          "there is room for only {} of {} instances of '{}'; scatter fewer, closer together or "
          "over a larger area",
          placed.size(), wanted.count, name);
    }
    for (std::size_t i = 0; i < placed.size(); ++i) {
      scene_.instances.push_back({name + " " + std::to_string(i + 1), scattered, placed[i]});
    }
  }

  // By the rows of a 3x4 matrix.
  static glm::dmat4 matrix(const JsonReader& at) {
    glm::dmat4 m(1.0);
    const std::vector<double> rows = at.numbers("matrix", 12);
    for (int i = 0; i < 12; ++i) m[i % 4][i / 4] = rows[static_cast<std::size_t>(i)];
    return m;
  }

  void require_every_object_used() const {
    for (const auto& [name, index] : object_of_) {
      const std::uint32_t object = index;
      const bool used = std::any_of(scene_.instances.begin(), scene_.instances.end(),
                                    [&](const Instance& i) { return i.object == object; });
      if (!used) file_.refuse("no instance uses the object '{}'", name);
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
      at.refuse("{}", text);
    }
  }

  void add_light(const JsonReader& at) {
    at.only({"name", "position", "colour", "intensity"});
    PointLight light;
    light.name = at.text("name", "light#" + std::to_string(scene_.lights.size()));
    light.position = at.vector("position");
    if (at.has("colour")) light.colour = parts_.colour(at, "colour");
    if (at.has("intensity")) light.colour *= at.positive("intensity");
    scene_.lights.push_back(std::move(light));
  }

  void add_path() {
    if (!scene_.camera)
      file_.refuse("a 'path' needs a 'camera', which gives its field of view and its up direction");
    scene_.path = read_path(file_);
    scene_.path_up = file_.object("camera").vector("up", kUp);
  }

  const JsonReader& file_;
  std::map<std::string, std::uint32_t> object_of_;
  Scene scene_;
  PartReader parts_;
};

}  // namespace

Scene load_description(const std::string& path, const Packages& packages) {
  const JsonReader file = JsonReader::from_file(path);
  return Description(file, packages).run();
}

}  // namespace dynrt::host
