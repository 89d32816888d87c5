// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "host/layout/memory_order.h"
#include "host/memory/memory.h"
#include "host/scene/scene.h"
#include "host/tree/tree.h"

namespace dynrt::host {

/// Appends a tree, of an object's primitives or of instances, in an order; item i becomes the
/// matrix matrix_of[i]. Returns the pointers to the tree's nodes, of `address_bits` bits:
/// addresses, or where nodes point to the lists of leaves, such pointers (units/packet.h).
std::vector<std::uint32_t> add_tree(MemoryPart& part, const Tree& tree, const MemoryOrder& order,
                                    unsigned address_bits, std::span<const std::uint32_t> matrix_of,
                                    const Mesh* object);

}  // namespace dynrt::host
