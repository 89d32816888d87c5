// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Trees made by hand, a plane a level, along which a ray pushes one far child after the other.
#pragma once

#include "host/analysis/stress/trial.h"
#include "host/tree/tree.h"

namespace dynrt::host::stress {

/// A tree of planes x = spacing, 2 spacing, .. `splits` of them, the farthest on top; the leaf
/// between planes k and k + 1 holds item k alone. Between every two nodes lie `unused` others.
Tree chain_tree(int splits, double spacing, const Aabb& box, unsigned unused = 0);

/// Rays from (-1, 0, 0), 8 x 8 of them: number k meets `target(x, k)` at whatever x that has.
Shot at_targets();
/// A triangle in the plane of an x, for ray number k of at_targets(); beside all for k = -1.
void add_target(Mesh& mesh, double x, int k);
/// The box around targets from x = 0 to this one.
Aabb box_of_targets(double to);

/// One object of `splits` + 1 targets under a chain.
Trial lower_chain(const MemoryFormat& numbers, int splits, unsigned unused = 0);
/// As many objects of one target each under a chain of instances.
Trial upper_chain(const MemoryFormat& numbers, int splits);
/// Both: `upper` + 1 objects, each of `lower` + 1 targets, 64 of which are aimed at.
Trial nested_chains(int upper, int lower);

}  // namespace dynrt::host::stress
