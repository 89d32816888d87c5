// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The wordings of what cannot be laid out in the board's memory.
#pragma once

#include <fmt/format.h>

#include <string>

namespace dynrt::host::image_messages {

inline std::string too_many(const std::string& scene, const char* what, std::size_t needed,
                            std::size_t limit) {
  return fmt::format(
      "scene '{}' needs {} {}, {} more than the {} that the board's memory holds; use fewer or "
      "smaller objects",
      scene, needed, what, needed - limit, limit);
}
inline std::string flat_triangle(const std::string& object, std::size_t triangle) {
  return fmt::format("object '{}', triangle {} has no area; its corners must not lie on one line",
                     object, triangle);
}
inline std::string triangle_range(const std::string& object, std::size_t triangle, double element,
                                  double limit) {
  return fmt::format(
      "object '{}', triangle {}: its matrix has the element {:g}, outside the core's numbers "
      "(-{:.5g} to {:.5g}); the triangle must be less thin or less small",
      object, triangle, element, limit, limit);
}
inline std::string no_inverse(const std::string& instance) {
  return fmt::format(
      "instance '{}' has a transform without an inverse; it must not flatten its object", instance);
}
inline std::string instance_range(const std::string& instance, double element, double limit) {
  return fmt::format(
      "instance '{}': the inverse of its transform has the element {:g}, outside the core's "
      "numbers (-{:.5g} to {:.5g}); the transform must flatten its object less",
      instance, element, limit, limit);
}
inline std::string camera_range(double element, double limit) {
  return fmt::format(
      "the camera's matrix has the element {:g}, outside the core's numbers (-{:.5g} to {:.5g}); "
      "the camera must be closer",
      element, limit, limit);
}

}  // namespace dynrt::host::image_messages
