// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A packet's rays come through a unit one after the other, the lowest first. Data of one ray go to
// the port with the ray's number; data of the packet follow its last ray.
#pragma once

#include "units/traversal_tokens.h"

namespace dynrt {

/// Writes a row through the port of the ray.
template <class Port, unsigned N, class Index, class Address, class Row>
void write_of_ray(Port (&ports)[N], Index ray, Address address, const Row& row) {
  for (unsigned i = 0; i < N; ++i) {
    if (ray == Index::from(i)) ports[i].write(address, row);
  }
}

/// Of the values of a packet's rays, that of the ray.
template <class T, unsigned N, class Index>
T of_ray(const T (&values)[N], Index ray) {
  T value = values[N - 1];
  for (unsigned i = N - 1; i-- > 0;) {
    if (ray == Index::from(i)) value = values[i];
  }
  return value;
}

/// A bit for each ray of a packet, once all have come: the lowest comes first, so bits move in from
/// above.
template <unsigned N>
uint<N> with_next_ray(uint<N> mask, bool bit) {
  return hls::concat(uint<1>(bit), mask.template bits<N - 1, 1>());
}

/// The lowest ray of a mask that has one.
template <class C>
RayIndex<C> lowest_ray(RayMask<C> mask) {
  RayIndex<C> ray(kRays<C> - 1);
  for (unsigned i = kRays<C> - 1; i-- > 0;) {
    if (mask.bit(i)) ray = RayIndex<C>::from(i);
  }
  return ray;
}
template <unsigned N>
uint<N> without_lowest(uint<N> mask) {
  return mask & uint<N>::from(mask.raw() - 1);
}

/// The packet of a ray enters the object's tree with its rays `active`.
template <class C>
TraversalEvent<C> enter_tree(const ObjectRay<C>& ray, RayMask<C> active) {
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
