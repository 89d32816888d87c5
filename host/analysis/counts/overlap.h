// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Top levels for objects that overlap other than by a mailbox (thesis 4.3): the core has none of
// them, they are counted to be compared with it.
#pragma once

#include <span>

#include "host/analysis/counts/counts.h"

namespace dynrt::host {

/// The same tree with instances moved from its leaves to the list of an inner node (4.3.1), each to
/// where its intersections expected by the surface area are fewest. Subtrees left without an
/// instance become empty children.
TopLevel hierarchical_top_level(const Tree& plain);

/// The instance with the largest box is entered first, as the main scene, and the tree holds the
/// others (4.3.3). object_boxes[k] is the box of object k's tree.
TopLevel main_scene_first(const Scene& scene, std::span<const Aabb> object_boxes);

}  // namespace dynrt::host
