// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>

#include "host/memory/memory.h"
#include "host/scene/scene.h"
#include "host/tree/tree.h"

namespace dynrt::host {

/// Appends a tree, of an object's primitives or of instances, its planes moved and scaled to a
/// space; item i becomes the matrix matrix_of[i]. Returns the address of the tree's node 0, which
/// has no place itself: node i lies at that address + i.
std::uint32_t add_tree(MemoryPart& part, const Tree& tree, std::span<const std::uint32_t> matrix_of,
                       const Mesh* object, const glm::dmat4& to_space = glm::dmat4(1.0));

}  // namespace dynrt::host
