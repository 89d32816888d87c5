// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The matrix numbers that a scene's primitives take, and the other contents of their matrices:
// colour and mirror.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/scene/scene.h"
#include "units/options.h"

namespace dynrt::host {

/// Columns from one primitive's number to the next.
std::uint32_t columns_apart(TriangleMatrix form);

/// Matrices of four columns that this many numbers of primitives take.
std::size_t matrices_taken(std::size_t numbers, TriangleMatrix form);

/// Numbers that an object's primitives take.
std::size_t numbers_taken(const Scene& scene, const Mesh& object, TriangleMatrix form);

/// The matrices of an object's primitives, the first of which is `first`, as hit records name them;
/// behind the last primitive's, where the next object begins.
std::vector<std::uint32_t> matrix_numbers(const Scene& scene, const Mesh& object,
                                          std::uint32_t first, TriangleMatrix form);

const Material& material_of(const Scene& scene, const Mesh& object, std::size_t primitive);

/// A surface's colour as its matrix holds it: 0x00BBGGRR.
std::uint32_t colour_bits(const glm::dvec3& colour);

/// A sphere is no mirror, as each of its points would reflect differently.
bool is_mirror(const Scene& scene, const Mesh& object, std::size_t primitive);

/// Tells whether a triangle of the scene reflects. If so, the matrix back to the world follows the
/// matrix of every instance, and its reflection follows a mirror's matrix (thesis 6.2.3).
bool has_mirrors(const Scene& scene);

/// Matrices of four columns that the boxes of all instances take in the world: a column for each
/// of the instances' numbers.
std::size_t matrices_of_boxes(const Scene& scene);

}  // namespace dynrt::host
