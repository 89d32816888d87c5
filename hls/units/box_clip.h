// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Box clip: clips the rays that enter an object to the object's box before its tree is traversed,
// in place of six clipping nodes above the tree's root (thesis 4.2), which would take six steps of
// the whole traversal unit. The object's matrix takes the box to the cube from -1 to 1, so the unit
// needs only the rays. If no ray of a packet meets the box before its hit so far, the packet goes
// on in the list at once.
//
// With r = 1 / d rounded once and t = (+-1 - o) r rounded twice more, t is wrong by less than two
// steps of the mantissa; the interval is widened by four at both ends.
#pragma once

#include "units/packet_rays.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct BoxClip {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  static constexpr unsigned kWidening = 4;  ///< not the traversal's

  hls::In<ObjectRay<C>> ray;
  hls::Out<TraversalEvent<C>> enter_object;
  hls::Out<ListJob<C>> missed;
  hls::RamRead<Real, kPackets> hit_distance[kRays<C>];
  hls::OptionalPort<kHasMirrors<C>, hls::RamRead<Real, kPackets>> start_distance[kRays<C>];
  hls::RamWrite<BoxInterval<C>, kPackets> interval[kRays<C>];
  HLS_PORTS(ray, enter_object, missed, hit_distance, start_distance, interval)

  void step() {
    const ObjectRay<C> in = ray.read();
    Real hit[kRays<C>], start[kRays<C>];
    for (unsigned i = 0; i < kRays<C>; ++i) {
      hit[i] = hit_distance[i].read(in.packet);
      if constexpr (kHasMirrors<C>) start[i] = start_distance[i].read(in.packet);
    }
    BoxInterval<C> inside{of_ray(start, in.ray), of_ray(hit, in.ray)};
    clip(inside, in.in_object.origin.x, in.in_object.direction.x);
    clip(inside, in.in_object.origin.y, in.in_object.direction.y);
    clip(inside, in.in_object.origin.z, in.in_object.direction.z);
    write_of_ray(interval, in.ray, in.packet, inside);

    entering_ = with_next_ray(entering_, inside.near < inside.far);
    const RayMask<C> entering = entering_ & in.active;
    if (is_last_ray<C>(in.ray, in.last)) {
      if (entering != RayMask<C>{}) {
        enter_object.write(enter_tree(in, entering));
      } else {
        ListJob<C> go_on;
        go_on.packet = in.packet;
        missed.write(go_on);
      }
    }
  }

 private:
  /// To the slab from -1 to 1 along one axis. `direction` or its reciprocal, if the core has such.
  static void clip(BoxInterval<C>& inside, Real origin, Real direction) {
    const Real reciprocal = kHasReciprocals<C> ? direction : Real::one() / direction;
    const Real low = (-Real::one() - origin) * reciprocal;
    const Real high = (Real::one() - origin) * reciprocal;
    const Real enters = direction.sign() ? high : low;
    const Real leaves = direction.sign() ? low : high;
    const Real near = enters.template moved_down<kWidening>();
    if (!enters.sign() && inside.near < near) inside.near = near;
    // Behind the ray's origin it leaves the box before it enters.
    const Real far = leaves.sign() ? Real{} : leaves.template moved_up<kWidening>();
    if (far < inside.far) inside.far = far;
  }

  RayMask<C> entering_;  ///< of the packet, whose rays come one after the other
};

}  // namespace dynrt
