// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Another space for the scene of a file: its origin is the point `centre` of the file's, its unit
// of length is `unit` of the file's, a power of two, so that only the move rounds. Directions of
// rays and turns stay as they are; a ray's distances are in units too.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace dynrt::host {

struct Space {
  glm::dvec3 centre{0.0};
  double unit = 1.0;

  glm::dvec3 inside(const glm::dvec3& p) const { return (p - centre) / unit; }
  glm::dvec3 outside(const glm::dvec3& p) const { return centre + unit * p; }
  glm::dmat4 into() const {
    return glm::translate(glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / unit)), -centre);
  }
  glm::dmat4 back() const {
    return glm::scale(glm::translate(glm::dmat4(1.0), centre), glm::dvec3(unit));
  }
};

}  // namespace dynrt::host
