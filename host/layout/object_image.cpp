// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/object_image.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "host/error.h"
#include "host/layout/limits.h"
#include "host/layout/tree_image.h"
#include "host/memory/matrix_numbers.h"
#include "host/memory/triangle_matrix.h"

namespace dynrt::host {

namespace {

/// The share that a material reflects, in 256ths; a mirror has neither 0 nor 256.
std::uint32_t mirror_part(const Material& material) {
  if (!(material.mirror > 0)) return 0;
  return static_cast<std::uint32_t>(std::clamp(std::lround(256 * material.mirror), 1L, 255L));
}

bool stored_in_three(const Mesh& object, std::size_t primitive, TriangleMatrix form) {
  return form == TriangleMatrix::kMemoryEfficient && !object.is_ellipsoid(primitive);
}

/// Takes a ray to the ray that the triangle's plane reflects: x - 2 n (n . x - n . c).
glm::dmat4x3 reflection_matrix(const std::array<glm::dvec3, 3>& triangle) {
  const glm::dvec3 n =
      glm::normalize(glm::cross(triangle[0] - triangle[2], triangle[1] - triangle[2]));
  glm::dmat4x3 matrix;
  for (int c = 0; c < 3; ++c) {
    matrix[c] = -2.0 * n[c] * n;
    matrix[c][c] += 1.0;
  }
  matrix[3] = 2.0 * glm::dot(n, triangle[2]) * n;
  return matrix;
}

/// The map of a primitive, in which a zero of either sign is the positive one.
UnitMatrix unit_matrix(const CoreInfo& core, const Mesh& mesh, std::size_t primitive, bool three) {
  const MemoryFormat& format = *core.format;
  const double largest = format.largest;
  const bool sphere = mesh.is_ellipsoid(primitive);
  UnitMatrix unit;
  if (sphere) {
    unit = ellipsoid_matrix(mesh.ellipsoid(primitive));
    unit.matrix += 0.0;
  } else {
    const auto matrix = triangle_matrix(mesh.corners(primitive));
    if (!matrix) {
      refuse("object '{}', triangle {} has no area; its corners must not lie on one line",
             mesh.name, primitive);
    }
    const glm::dmat4x3 to_unit = *matrix + 0.0;
    unit = core.is_watertight() ? corner_matrix(mesh.corners(primitive), to_unit)
           : three              ? efficient_matrix(to_unit)
                                : UnitMatrix{to_unit};
  }
  if (const auto element = out_of_range(format, unit.matrix)) {
    if (sphere) {
      refuse(
          "object '{}', sphere {}: its matrix has the element {:g}, outside the core's numbers "
          "(-{:.5g} to {:.5g}); make the sphere larger",
          mesh.name, primitive, *element, largest, largest);
    }
    refuse(
        "object '{}', triangle {}: its matrix has the element {:g}, outside the core's numbers "
        "(-{:.5g} to {:.5g}); make the triangle thicker or larger",
        mesh.name, primitive, *element, largest, largest);
  }
  return unit;
}

}  // namespace

ObjectImage::ObjectImage(const Scene& scene, std::span<const Tree> trees, const CoreInfo& core)
    : core(core) {
  const std::uint32_t apart = columns_apart(core.triangle_matrix);
  if (core.one_colour) check_colours(scene);
  const MemoryFormat& format = *core.format;
  memory.format = &format;
  memory.first_node = 1;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const Mesh& mesh = scene.objects[k];
    const Tree& tree = trees[k];
    const std::uint32_t first_matrix = memory.end_column() / apart;
    const auto matrix_of = matrix_numbers(scene, mesh, first_matrix, core.triangle_matrix);
    const auto address = add_tree(memory, tree, core, matrix_of, &mesh);
    objects.push_back({address[tree.root], address[tree.clipped_root], first_matrix, tree.box});
    check_limits(scene, core, memory);
    for (std::size_t i = 0; i < mesh.primitives(); ++i) {
      const bool three = stored_in_three(mesh, i, core.triangle_matrix);
      const UnitMatrix unit = unit_matrix(core, mesh, i, three);
      const Material& material = material_of(scene, mesh, i);
      const bool mirror = is_mirror(scene, mesh, i);
      const std::uint32_t colour = colour_bits(material.diffuse);
      const std::uint32_t part = mirror ? mirror_part(material) : 0;
      memory.columns.resize(matrix_of[i] * apart);
      if (three) {
        memory.add(to_stored_columns(format, unit, colour, part));
      } else {
        memory.add(to_columns(format, unit, colour, part));
      }
      if (mirror) {
        memory.add(to_columns(reflection_matrix(mesh.corners(i)) + 0.0, 0));
      }
    }
    memory.columns.resize(matrix_of.back() * apart);
  }
}

TreeSize ObjectImage::room_left() const {
  CoreConfiguration reached = core;
  if (core.is_specialised()) reached.address_bits = kAddressBits;
  const TreeSize ends = address_ends(reached);
  const auto left = [](std::size_t end, std::size_t used) { return end - std::min(used, end); };
  return {left(ends.nodes, memory.end_node()), left(ends.items, memory.end_entry())};
}

std::vector<Aabb> ObjectImage::boxes() const {
  std::vector<Aabb> boxes;
  boxes.reserve(objects.size());
  for (const Object& object : objects) boxes.push_back(object.box);
  return boxes;
}

}  // namespace dynrt::host
