// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene's trees for a core. Where triangles are tested watertight two things are
// asked of them. They are built over the corners as the core has them, rounded: a part of a
// triangle that only rounding brought into a cell is listed there. And as the test decides with
// rounded differences, a triangle may be hit by a ray that passes a little beside it; it is listed
// that far around. The proof is in docs/explanation/watertight.md.
#pragma once

#include <string>
#include <vector>

#include "host/layout/object_image.h"
#include "host/tree/scene_trees.h"

namespace dynrt::host {

/// The corners as the memory will hold them.
Scene with_rounded_corners(Scene scene, const MemoryFormat& format);

/// For each object, in its own coordinates: how far beside a triangle a ray may pass that hits it.
/// A ray's origin is taken to be no farther from the scene's middle than its farthest corner, the
/// eye or a light, at any moment of its animation. The margin is at most kWidest of the object's
/// size, which the shipped format has for rays from 64 sizes away: with a wider one the tree would
/// no longer divide the object.
std::vector<double> rounding_margins(const Scene& scene, const glm::dvec3& eye,
                                     const MemoryFormat& format);
inline constexpr double kWidest = 1.0 / 128;
/// The objects for which that is less than it would have to be.
std::vector<std::string> beyond_margins(const Scene& scene, const glm::dvec3& eye,
                                        const MemoryFormat& format);

/// The grid is the core's, whatever the options say.
SceneTrees trees_for(const Scene& scene, const glm::dvec3& eye, const CoreInfo& core = {},
                     TreeOptions options = {});

}  // namespace dynrt::host
