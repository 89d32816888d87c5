// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene's trees for a core. The watertight triangle test needs two things of them. They are built
// over the core's rounded corners, so that a part of a triangle that lies in a cell only after
// rounding is listed there. And the test decides with rounded differences, so a ray that passes a
// little outside a triangle may hit it; the triangle is listed that far around. The proof is in
// docs/explanation/watertight.md.
#pragma once

#include <string>
#include <vector>

#include "host/layout/object_image.h"
#include "host/tree/scene_trees.h"

namespace dynrt::host {

/// The corners as the memory holds them.
Scene with_rounded_corners(Scene scene, const MemoryFormat& format);

/// For each object, in its own coordinates: the largest distance from a triangle at which a ray may
/// still hit it. A ray's origin is taken to be no farther from the scene's middle than its farthest
/// corner, the eye or a light, at any moment of its animation. The margin is at most kWidest of the
/// object's size, which the shipped format has for rays from 64 sizes away, and kWidestOfTriangle
/// of its triangles' mean size: with a wider one the tree would no longer divide the object.
std::vector<double> rounding_margins(const Scene& scene, const glm::dvec3& eye,
                                     const MemoryFormat& format);
inline constexpr double kWidest = 1.0 / 128;
inline constexpr double kWidestOfTriangle = 1.0 / 16;
/// The objects whose margin is smaller than the proof requires.
std::vector<std::string> beyond_margins(const Scene& scene, const glm::dvec3& eye,
                                        const MemoryFormat& format);

/// The way its memory has leaves.
Leaves leaves_of(const CoreConfiguration& core);
/// The cost of entering an object, in steps of the traversal, that its top-level tree is built for.
double object_cost(const CoreConfiguration& core);

/// The memory that the trees of both levels may take together.
TreeSize memory_for_trees(const CoreInfo& core);

/// Uses the core's grid and costs and ignores those of the options.
SceneTrees trees_for(const Scene& scene, const glm::dvec3& eye, const CoreInfo& core,
                     TreeOptions options = {});

}  // namespace dynrt::host
