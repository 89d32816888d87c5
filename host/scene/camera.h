// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Where a picture is taken from: the user's flags, else the scene's own camera, else one that
// frames the whole scene. Angles in degrees, the field of view is the vertical one, aspect is
// width / height of the image.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "host/scene/scene.h"

namespace dynrt::host {

inline constexpr double kDefaultFieldOfView = 45.0;

/// The user's flags; the scene or a framing camera provides the rest.
struct CameraOverrides {
  std::optional<glm::dvec3> position;
  std::optional<glm::dvec3> look_at;
  std::optional<glm::dvec3> up;
  std::optional<double> field_of_view;
};

struct Box {
  glm::dvec3 low, high;
};

/// The box of an object, and the world-space box of all instances.
Box bounds(const Mesh& object);
Box bounds(const Scene& scene);

/// |forward| = 1, |up| = 2 tan(field_of_view / 2), |right| = aspect * |up|. Throws UserError when
/// position and look_at coincide, up is parallel to the view, or the field of view is not in
/// (0, 180).
Camera look_at(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec3& up,
               double field_of_view, double aspect);

/// The field of view of a camera, for any image.
double field_of_view_of(const Camera& camera);

/// Sees the whole scene, from the front, right and above (direction (0.5, 0.4, 1) from its centre).
Camera frame(const Box& box, const glm::dvec3& up, double field_of_view, double aspect);

Camera choose_camera(const Scene& scene, const CameraOverrides& flags, int width, int height);

}  // namespace dynrt::host
