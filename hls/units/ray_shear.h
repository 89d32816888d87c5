// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Ray shear: on the way of a packet's rays into an object, the map by which each will take the
// corners of the object's triangles (units/watertight.h). It is written before the packet's
// traversal of the object begins.
#pragma once

#include "units/packet_rays.h"
#include "units/traversal_tokens.h"
#include "units/watertight.h"

namespace dynrt {

template <class C>
struct RayShear {
  using Real = typename C::Real;

  hls::In<ObjectRay<C>> ray;
  hls::Out<TraversalEvent<C>> enter_object;
  hls::RamWrite<RayMap<Real>, kRayRows<C>> map;
  HLS_PORTS(ray, enter_object, map)

  void step() {
    const ObjectRay<C> in = ray.read();
    map.write(ray_row<C>(in.packet, in.ray), ray_map(in.in_object));
    if (is_last_ray<C>(in.ray, in.last)) enter_object.write(enter_tree(in, in.active));
  }
};

}  // namespace dynrt
