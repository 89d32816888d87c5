// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Plane offset: the distance of a node's plane from the point where a packet's rays start, along
// the axis that the node splits. It is subtracted here once for the packet, and takes the place of
// the plane on the way to the slices, each of which only divides it by its ray's direction. The
// rays of a camera and of a light start at one point in the world, and so in every object.
#pragma once

#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct PlaneOffset {
  using Real = typename C::Real;

  hls::In<Step<C>> step_in;
  hls::Out<Step<C>> offset;
  hls::RamRead<Vector<Real>, kLevelRows<C>> origin;
  HLS_PORTS(step_in, offset, origin)

  void step() {
    Step<C> s = step_in.read();
    const Vector<Real> from = origin.read(level_row<C>(s.context.level, s.context.packet));
    const Real start = of_split_axis(s.node.kind, from.x, from.y, from.z);
    s.in_plane = s.node.split == start;
    s.node.split = s.node.split - start;
    offset.write(s);
  }
};

}  // namespace dynrt
