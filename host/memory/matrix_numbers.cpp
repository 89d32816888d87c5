// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/memory/matrix_numbers.h"

#include <algorithm>
#include <cmath>

#include "units/memory_format.h"

namespace dynrt::host {

namespace {

/// Numbers that a primitive takes: one, and those that its fourth column or its reflection, a
/// matrix of four columns at the next number, reach into.
std::uint32_t numbers_of(const Scene& scene, const Mesh& object, std::size_t primitive,
                         TriangleMatrix form) {
  const bool mirror = is_mirror(scene, object, primitive);
  if (form == TriangleMatrix::kNormalConsistent) return mirror ? 2 : 1;
  return mirror ? 3 : object.is_ellipsoid(primitive) ? 2 : 1;
}

}  // namespace

std::uint32_t columns_apart(TriangleMatrix form) {
  return form == TriangleMatrix::kMemoryEfficient ? kStoredColumns : 4;
}

std::size_t matrices_taken(std::size_t numbers, TriangleMatrix form) {
  return (numbers * columns_apart(form) + 3) / 4;
}

std::size_t numbers_taken(const Scene& scene, const Mesh& object, TriangleMatrix form) {
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < object.primitives(); ++i) {
    numbers += numbers_of(scene, object, i, form);
  }
  return numbers;
}

std::vector<std::uint32_t> matrix_numbers(const Scene& scene, const Mesh& object,
                                          std::uint32_t first, TriangleMatrix form) {
  std::vector<std::uint32_t> numbers{first};
  for (std::size_t i = 0; i < object.primitives(); ++i) {
    numbers.push_back(numbers.back() + numbers_of(scene, object, i, form));
  }
  return numbers;
}

const Material& material_of(const Scene& scene, const Mesh& object, std::size_t primitive) {
  return scene.materials.at(object.material_of(primitive));
}

bool is_mirror(const Scene& scene, const Mesh& object, std::size_t primitive) {
  return !object.is_ellipsoid(primitive) && material_of(scene, object, primitive).mirror > 0;
}

std::uint32_t colour_bits(const glm::dvec3& colour) {
  std::uint32_t bits = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double level = std::clamp(colour[channel], 0.0, 1.0) * 255.0;
    bits |= static_cast<std::uint32_t>(std::lround(level)) << (8 * channel);
  }
  return bits;
}

bool has_mirrors(const Scene& scene) {
  for (const Mesh& object : scene.objects) {
    for (std::size_t i = 0; i < object.primitives(); ++i) {
      if (is_mirror(scene, object, i)) return true;
    }
  }
  return false;
}

std::size_t matrices_of_boxes(const Scene& scene) {
  return (scene.instances.size() * (has_mirrors(scene) ? 2 : 1) + 3) / 4;
}

}  // namespace dynrt::host
