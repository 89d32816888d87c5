// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Other ways than the mailbox to treat overlapping objects in the top level (thesis 4.3). The core
// has none of them; they are counted for comparison.
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
