// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "host/error.h"
#include "host/memory/triangle_matrix.h"
#include "host/scene/animation.h"
#include "host/tree/instance_tree.h"

namespace dynrt::host {

namespace {

constexpr char kReaches[] = "{} {} = {:g}";

constexpr int kCentreDigits = 3;  ///< binary, of a centre relative to the extent
constexpr int kObjectStep = 4;    ///< powers of two, between the scales of objects

/// Power of two of a number's leading digit.
int exponent_of(double x) { return std::ilogb(x); }

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// The middle of a box, in few digits: coordinates that have few themselves keep them. Along an
/// axis that is no further from the origin than half the longest extent the box is left where it
/// is: to move it would gain a digit at most.
glm::dvec3 centre_of(const Aabb& box) {
  const glm::dvec3 middle = box.low + box.extent() / 2.0;
  const glm::dvec3 extent = box.extent();
  const double longest = std::max({extent.x, extent.y, extent.z});
  if (!std::isfinite(longest)) return glm::dvec3(0.0);
  if (!(longest > 0)) return middle;
  const double step = std::ldexp(1.0, exponent_of(longest) - kCentreDigits);
  const glm::dvec3 rounded = glm::round(middle / step) * step;
  return glm::mix(rounded, glm::dvec3(0.0),
                  glm::lessThanEqual(glm::abs(middle), glm::dvec3(longest / 2.0)));
}

Aabb box_of(const Mesh& mesh) {
  const Box box = bounds(mesh);
  return {box.low, box.high};
}

/// The largest of some numbers, and its description for messages.
struct Extreme {
  double value = 0;
  std::function<std::string()> tell;

  template <class Tell>
  void include(double x, Tell&& told) {
    if (!(std::abs(x) > value)) return;
    value = std::abs(x);
    tell = std::forward<Tell>(told);
  }
};

class Fitter {
 public:
  Fitter(const Scene& scene, const Camera& camera) : scene_(scene), camera_(camera) {
    for (const Mesh& object : scene.objects) boxes_.push_back(box_of(object));
    place_objects();
    place_world();
    measure_world();
    measure_objects();
  }

  Fit run(const MemoryFormat& format) {
    const bool finite = std::isfinite(far_.value) && std::isfinite(fine_.value);
    if (finite && geometry_ > 0 && fine_.value > 0) scale(format);
    return std::move(fit_);
  }

 private:
  Aabb world_box(const Instance& instance, const glm::dmat4& transform) const {
    return transformed_box(boxes_[instance.object], transform);
  }

  /// An object has the scale that its instances have in the world, in coarse steps: the core takes
  /// brightness from directions in the object, which so keep about their length.
  void place_objects() {
    std::vector<std::pair<int, int>> scales(
        boxes_.size(), {std::numeric_limits<int>::max(), std::numeric_limits<int>::min()});
    for (const Instance& instance : scene_.instances) {
      const double volume = std::abs(glm::determinant(glm::dmat3(instance.transform)));
      if (!(volume > 0 && std::isfinite(volume))) continue;
      const int scale = floor_div(exponent_of(volume) + 1, 3);
      auto& [least, most] = scales[instance.object];
      least = std::min(least, scale);
      most = std::max(most, scale);
    }
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      const auto& [least, most] = scales[k];
      const int scale = least > most ? 0 : floor_div(least + most, 2);
      const int steps = floor_div(scale + kObjectStep / 2, kObjectStep);
      fit_.objects.push_back({centre_of(boxes_[k]), std::ldexp(1.0, -kObjectStep * steps)});
    }
  }

  void place_world() {
    for (const double time : moments_of(scene_)) {
      const std::vector<glm::dmat4> at = transforms_at(scene_, time);
      for (std::size_t i = 0; i < at.size(); ++i) {
        world_.include(world_box(scene_.instances[i], at[i]));
      }
      transforms_.push_back(at);
    }
    fit_.world.centre = centre_of(world_);
  }

  /// A place in the world; `what` describes it.
  template <class What>
  void include(const glm::dvec3& p, What&& what) {
    const glm::dvec3 from_centre = p - fit_.world.centre;
    for (int axis = 0; axis < 3; ++axis) {
      far_.include(from_centre[axis], [what, axis, p] {
        return fmt::format(kReaches, what(), static_cast<char>('x' + axis), p[axis]);
      });
    }
  }

  void measure_world() {
    for (const std::vector<glm::dmat4>& at : transforms_) {
      for (std::size_t i = 0; i < at.size(); ++i) {
        const Instance& instance = scene_.instances[i];
        const Aabb box = world_box(instance, at[i]);
        const auto what = [&instance] {
          return fmt::format("instance '{}' reaches", instance.name);
        };
        include(box.low, what);
        include(box.high, what);
      }
    }
    geometry_ = far_.value;
    // The world's origin as an instance sees it is in its matrix.
    for (const std::vector<glm::dmat4>& at : transforms_) {
      for (std::size_t i = 0; i < at.size(); ++i) {
        const Instance& instance = scene_.instances[i];
        const Space& object = fit_.objects[instance.object];
        const glm::dvec3 origin(glm::inverse(at[i]) * glm::dvec4(fit_.world.centre, 1.0));
        const glm::dvec3 seen = object.inside(origin);
        far_.include(std::max({std::abs(seen.x), std::abs(seen.y), std::abs(seen.z)}), [&instance] {
          return fmt::format("instance '{}' is scaled down too far", instance.name);
        });
      }
    }
    const auto camera_stands = [] { return std::string("the camera stands at"); };
    include(camera_.position, camera_stands);
    for (const double time : moments_of(scene_)) {
      if (const auto camera = camera_at(scene_, time)) include(camera->position, camera_stands);
    }
    for (const PointLight& light : scene_.lights) {
      include(light.position, [&light] { return fmt::format("light '{}' stands at", light.name); });
    }
  }

  void measure_objects() {
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      const Mesh& mesh = scene_.objects[k];
      const Space& space = fit_.objects[k];
      for (const glm::dvec3& corner : {boxes_[k].low, boxes_[k].high}) {
        const glm::dvec3 p = space.inside(corner);
        for (int axis = 0; axis < 3; ++axis) {
          geometry_ = std::max(geometry_, std::abs(p[axis]));
          far_.include(p[axis], [&mesh, axis, corner] {
            return fmt::format(kReaches, fmt::format("object '{}' reaches", mesh.name),
                               static_cast<char>('x' + axis), corner[axis]);
          });
        }
      }
      for (std::size_t i = 0; i < mesh.primitives(); ++i) {
        const double element = largest_element(mesh, i);
        fine_.include(element * space.unit, [&mesh, i, element] {
          return fmt::format("{} {} of object '{}' has a matrix with the element {:g}",
                             mesh.is_ellipsoid(i) ? "sphere" : "triangle", i, mesh.name, element);
        });
      }
    }
  }

  /// Of those of a primitive's matrix that grow as it shrinks.
  static double largest_element(const Mesh& mesh, std::size_t primitive) {
    const bool sphere = mesh.is_ellipsoid(primitive);
    const auto matrix = sphere ? std::optional(ellipsoid_matrix(mesh.ellipsoid(primitive)).matrix)
                               : triangle_matrix(mesh.corners(primitive));
    double largest = 0;
    for (int c = 0; matrix && c < 3; ++c) {
      for (int r = 0; r < (sphere ? 3 : 2); ++r) {
        largest = std::max(largest, std::abs((*matrix)[c][r]));
      }
    }
    return largest;
  }

  void scale(const MemoryFormat& format) {
    const int bias = (1 << (format.exponent_bits - 1)) - 1;
    const double reach = format.largest / 2;  // range that the trees leave to a coordinate
    const int least = exponent_of(fine_.value) - bias;
    const int most = bias - 1 - exponent_of(far_.value);
    int scale = -1 - exponent_of(geometry_);
    scale = std::min(std::max(scale, least), most);
    const double far = std::ldexp(far_.value, scale);
    const double fine = std::ldexp(fine_.value, -scale);
    if (!(far <= reach && fine <= format.largest)) {
      refuse(
          "no scale fits scene '{}' into the {} exponent bits of the core's numbers: {}, and {}; "
          "take a format with more exponent bits, or make the two more alike in size",
          scene_.name, format.exponent_bits, far_.tell(), fine_.tell());
    }
    fit_.world.unit = std::ldexp(1.0, -scale);
    for (Space& object : fit_.objects) object.unit = std::ldexp(object.unit, -scale);
    fit_.headroom = {exponent_of(reach / far), exponent_of(format.largest / fine)};
  }

  const Scene& scene_;
  const Camera& camera_;
  std::vector<Aabb> boxes_;  ///< of the objects
  std::vector<std::vector<glm::dmat4>> transforms_;
  Aabb world_;
  double geometry_ = 0;  ///< the largest coordinate of an object or an instance
  Extreme far_, fine_;
  Fit fit_;
};

void move_object(const Space& space, Mesh& mesh) {
  for (glm::dvec3& vertex : mesh.vertices) vertex = space.inside(vertex);
  for (Rectangle& rectangle : mesh.rectangles) {
    rectangle.corner = space.inside(rectangle.corner);
    rectangle.across /= space.unit;
    rectangle.along /= space.unit;
  }
  for (Ellipsoid& ellipsoid : mesh.ellipsoids) {
    ellipsoid.from_unit = space.into() * ellipsoid.from_unit;
  }
}

/// One more node goes between the world and the moving nodes, and one between those and each
/// object.
void move_motion(const Fit& fit, Scene& scene) {
  if (scene.motion.empty()) return;
  const auto after = [](std::optional<std::uint32_t>& index) {
    if (index) ++*index;
  };
  for (MotionNode& node : scene.motion) {
    node.parent = node.parent ? *node.parent + 1 : 0;
  }
  scene.motion.insert(scene.motion.begin(), MotionNode{.name = "space",
                                                       .parent = std::nullopt,
                                                       .transform = fit.world.into(),
                                                       .position = {},
                                                       .rotation = {},
                                                       .scale = {}});
  after(scene.camera_motion);
  for (Instance& instance : scene.instances) {
    if (!instance.motion) continue;
    after(instance.motion);
    scene.motion.push_back({.name = instance.name,
                            .parent = instance.motion,
                            .transform = fit.objects[instance.object].back(),
                            .position = {},
                            .rotation = {},
                            .scale = {}});
    instance.motion = static_cast<std::uint32_t>(scene.motion.size() - 1);
  }
}

}  // namespace

Fit fit(const Scene& scene, const Camera& camera, const MemoryFormat& format) {
  return Fitter(scene, camera).run(format);
}

void move_into(const Fit& fit, Scene& scene) {
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    move_object(fit.objects[k], scene.objects[k]);
  }
  for (Instance& instance : scene.instances) {
    instance.transform =
        fit.world.into() * instance.transform * fit.objects[instance.object].back();
  }
  move_motion(fit, scene);
  for (PointLight& light : scene.lights) {
    light.position = fit.world.inside(light.position);
    light.colour /= fit.world.unit;  // it falls with the distance
  }
  if (scene.camera) scene.camera = moved_into(fit.world, *scene.camera);
  for (PathKey& key : scene.path) {
    key.position = fit.world.inside(key.position);
    key.look_at = fit.world.inside(key.look_at);
  }
}

Camera moved_into(const Space& space, const Camera& camera) {
  Camera moved = camera;
  moved.position = space.inside(camera.position);
  return moved;
}

CameraOverrides moved_into(const Space& space, const CameraOverrides& flags) {
  CameraOverrides moved = flags;
  if (flags.position) moved.position = space.inside(*flags.position);
  if (flags.look_at) moved.look_at = space.inside(*flags.look_at);
  return moved;
}

}  // namespace dynrt::host
