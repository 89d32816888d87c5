// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr glm::dvec3 kFramedFrom{0.5, 0.4, 1.0};  // right, above and in front of the centre

void require_finite(const glm::dvec3& v, const char* what) {
  if (!std::isfinite(v.x + v.y + v.z)) {
    refuse("the camera's {} ({}, {}, {}) is not finite", what, v.x, v.y, v.z);
  }
}

void require_field_of_view(double degrees) {
  if (!(degrees > 0.0 && degrees < 180.0)) {
    refuse("the camera's field of view is {} degrees; it must lie between 0 and 180", degrees);
  }
}

Camera widen(Camera camera, double aspect) {
  camera.right = glm::normalize(camera.right) * glm::length(camera.up) * aspect;
  return camera;
}

}  // namespace

Box bounds(const Mesh& object) {
  Box box{glm::dvec3(kInf), glm::dvec3(-kInf)};
  const auto include = [&box](const glm::dvec3& v) {
    box.low = glm::min(box.low, v);
    box.high = glm::max(box.high, v);
  };
  for (const glm::dvec3& v : object.vertices) include(v);
  for (const Rectangle& r : object.rectangles) {
    for (const glm::dvec3& v : r.corners()) include(v);
  }
  for (const Ellipsoid& e : object.ellipsoids) {
    const glm::dvec3 centre(e.from_unit[3]);
    include(centre - e.extent());
    include(centre + e.extent());
  }
  return box;
}

Box bounds(const Scene& scene) {
  Box box{glm::dvec3(kInf), glm::dvec3(-kInf)};
  for (const Instance& instance : scene.instances) {
    const Mesh& object = scene.objects[instance.object];
    const auto include = [&](const glm::dvec3& v) {
      const glm::dvec3 world(instance.transform * glm::dvec4(v, 1.0));
      box.low = glm::min(box.low, world);
      box.high = glm::max(box.high, world);
    };
    for (const glm::dvec3& v : object.vertices) include(v);
    for (const Rectangle& r : object.rectangles) {
      for (const glm::dvec3& v : r.corners()) include(v);
    }
    for (const Ellipsoid& e : object.ellipsoids) {
      const Ellipsoid world{instance.transform * e.from_unit};
      const glm::dvec3 centre(world.from_unit[3]);
      box.low = glm::min(box.low, centre - world.extent());
      box.high = glm::max(box.high, centre + world.extent());
    }
  }
  return box;
}

double field_of_view_of(const Camera& camera) {
  return glm::degrees(2.0 *
                      std::atan(glm::length(camera.up) / (2.0 * glm::length(camera.forward))));
}

Camera look_at(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec3& up,
               double field_of_view, double aspect) {
  require_finite(position, "position");
  require_finite(target, "look-at point");
  require_finite(up, "up");
  require_field_of_view(field_of_view);
  const double distance = glm::length(target - position);
  if (!(distance > 0.0)) {
    refuse(
        "the camera's position and the point that it looks at are the same ({}, {}, {}); move one "
        "of the two",
        target.x, target.y, target.z);
  }
  const glm::dvec3 forward = (target - position) / distance;
  const glm::dvec3 sideways = glm::cross(forward, up);
  if (!(glm::length(sideways) > 1e-9 * glm::length(up))) {
    refuse("the camera's up direction ({}, {}, {}) is parallel to its view; give another one", up.x,
           up.y, up.z);
  }
  const double height = 2.0 * std::tan(glm::radians(field_of_view) / 2.0);
  const glm::dvec3 right = glm::normalize(sideways);
  return {position, right * height * aspect, glm::cross(right, forward) * height, forward};
}

Camera frame(const Box& box, const glm::dvec3& up, double field_of_view, double aspect) {
  require_field_of_view(field_of_view);
  const glm::dvec3 centre = (box.low + box.high) / 2.0;
  const double radius = glm::length(box.high - box.low) / 2.0;
  const double half_height = glm::radians(field_of_view) / 2.0;
  const double half_width = std::atan(std::tan(half_height) * aspect);
  const double distance = radius / std::sin(std::min(half_height, half_width));
  return look_at(centre + glm::normalize(kFramedFrom) * distance, centre, up, field_of_view,
                 aspect);
}

Camera choose_camera(const Scene& scene, const CameraOverrides& flags, int width, int height) {
  if (width < 1 || height < 1) {
    refuse("the image is {}x{} pixels; both sides must be at least 1", width, height);
  }
  const double aspect = static_cast<double>(width) / height;
  const bool flagged = flags.position || flags.look_at || flags.up || flags.field_of_view;
  if (scene.camera && !flagged) return widen(*scene.camera, aspect);

  const glm::dvec3 up = flags.up.value_or(scene.camera ? scene.camera->up : glm::dvec3(0, 1, 0));
  const double field_of_view = flags.field_of_view.value_or(
      scene.camera ? field_of_view_of(*scene.camera) : kDefaultFieldOfView);
  const Box box = bounds(scene);
  const Camera start =
      scene.camera ? *scene.camera : frame(box, glm::dvec3(0, 1, 0), field_of_view, aspect);
  const glm::dvec3 position = flags.position.value_or(start.position);
  // A camera that is only moved keeps looking the way the scene's looks, or at the scene's centre.
  const glm::dvec3 target = flags.look_at.value_or(scene.camera ? position + scene.camera->forward
                                                                : (box.low + box.high) / 2.0);
  return look_at(position, target, up, field_of_view, aspect);
}

}  // namespace dynrt::host
