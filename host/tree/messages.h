// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The wordings of what the tree builders refuse.
#pragma once

#include <fmt/format.h>

#include <string>

namespace dynrt::host::tree_messages {

inline std::string no_triangles(const std::string& object) {
  return fmt::format(
      "object '{}' has no triangles to build a tree over; an object must have at least one",
      object);
}
inline std::string coordinate(const std::string& object, std::size_t triangle, unsigned vertex,
                              char axis, double value, double limit) {
  return fmt::format(
      "object '{}', triangle {}, vertex {}: {} = {:g} is outside the core's numbers; coordinates "
      "must lie within -{:.5g} and {:.5g}",
      object, triangle, vertex, axis, value, limit, limit);
}
inline std::string no_instances(const std::string& scene) {
  return fmt::format(
      "scene '{}' has no instances to build a tree over; a scene must have at least one", scene);
}
inline std::string instance_box(const std::string& instance, char axis, double value,
                                double limit) {
  return fmt::format(
      "instance '{}': its box reaches {} = {:g}, outside the core's numbers; coordinates must lie "
      "within -{:.5g} and {:.5g}",
      instance, axis, value, limit, limit);
}

}  // namespace dynrt::host::tree_messages
