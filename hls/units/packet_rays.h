// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A packet's rays come through a unit one after the other, the lowest first. Data of one ray go to
// the port with the ray's number; data of the packet follow its last ray.
#pragma once

#include "units/traversal_tokens.h"

namespace dynrt {

inline constexpr RayIndex kLastRay = RayIndex(kRays - 1);

/// Writes a row through the port of the ray.
template <class Port, class Address, class Row>
void write_of_ray(Port (&ports)[kRays], RayIndex ray, Address address, const Row& row) {
  for (unsigned i = 0; i < kRays; ++i) {
    if (ray == RayIndex::from(i)) ports[i].write(address, row);
  }
}

/// The packet of a ray enters the object's tree with its rays `active`.
template <class C>
TraversalEvent<C> enter_tree(const ObjectRay<C>& ray, RayMask active) {
  TraversalEvent<C> enter;
  enter.packet = ray.packet;
  enter.level = 1;
  enter.kind = TraversalKind::kEnter;
  enter.next = ray.root;
  enter.active = active;
  enter.distinct_origins = ray.distinct_origins;
  return enter;
}

}  // namespace dynrt
