// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The bottom-level tree: the triangles of one object, in its own coordinates.
#pragma once

#include "host/scene/scene.h"
#include "host/tree/build.h"

namespace dynrt::host {

/// Item i of the tree is triangle i of the object. Throws UserError for an object without
/// triangles, or with a coordinate that is not finite or lies outside the grid's numbers.
Tree build_triangle_tree(const Mesh& object, const TreeOptions& options = {});

}  // namespace dynrt::host
