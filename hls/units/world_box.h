// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// World box: tests which rays of a packet meet the box of an object in the world, one ray a clock,
// before the object is entered. Rays that miss it, or meet it only behind their hit so far, do not
// enter; if none is left, the packet goes on in the list at once. To enter takes four columns, a
// vector for each ray through the transformation, and six clipping nodes; a test takes one column.
// The object's traversal begins with the rays' intervals in the box, so that most objects need no
// clipping nodes.
//
// All rays of a packet start at the eye or at a light, and the box is stored as it lies from there
// (memory_format.h), so a side's distance along a ray is one product with a reciprocal of the ray's
// direction.
//
// No ray that meets the box is rejected. Distances have fewer bits of the mantissa, m, than the
// core's numbers, whose reciprocals are rounded to nearest. Both the reciprocal and the product are
// truncated by less than 2^-m of themselves. That moves a distance towards the eye, which is right
// where a ray enters, and wrong where it leaves, by at most five steps with the rounding; these
// are added there. A product that saturates stays in the order of the others. Only for a component
// of a direction above half of the numbers' range is the reciprocal too large (ray_reciprocal.h); a
// camera has no such directions.
#pragma once

#include "units/packet_rays.h"
#include "units/repeated.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct WorldBox {
  using Real = typename C::Real;
  using Distance = BoxDistance<Real>;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  static constexpr unsigned kSteps = 5;  ///< of the mantissa, added where a ray leaves

  hls::In<Repeated<BoxJob<C>>> job;  ///< once for each ray
  hls::Out<TransformJob<C>> enter;
  hls::Out<ListJob<C>> missed;
  hls::RamRead<BoxedObject<C>, kPackets> object;
  hls::RamRead<Vector<Real>, kRayRows<C>> reciprocal;  ///< of directions
  hls::RamRead<Real, kRayRows<C>> reach;               ///< hit distances so far
  hls::RamWrite<CoarseInterval<C>, kPackets> interval[kRays<C>];
  HLS_PORTS(job, enter, missed, object, reciprocal, reach, interval)

  void step() {
    const Repeated<BoxJob<C>> j = job.read();
    const PacketId<C> packet = j.job.packet;
    const BoxedObject<C> o = object.read(packet);
    const bool first = j.index == RepeatCount<C>{};

    const RayMask<C> left = first ? o.rays : left_;
    left_ = without_lowest(left);
    const RayIndex<C> ray = lowest_ray<C>(left);
    const RayRow<C> row = ray_row<C>(packet, ray);
    const Vector<Real> r = reciprocal.read(row);
    const Distance hit = shorter<Distance>(reach.read(row));

    const Interval x = along(o.slabs[0], r.x);
    const Interval y = along(o.slabs[1], r.y);
    const Interval z = along(o.slabs[2], r.z);
    const Distance near = larger(larger(x.near, y.near), z.near);
    const Distance far =
        smaller(smaller(x.far, y.far), smaller(z.far, hit)).template moved_up<kSteps>();
    const bool behind = x.behind || y.behind || z.behind;
    const bool meets = !behind && !(far < near);
    write_of_ray(interval, ray, packet, CoarseInterval<C>{near.magnitude(), far.magnitude()});

    const RayMask<C> before = first ? RayMask<C>{} : meeting_;
    const RayMask<C> meeting = meets ? before | (left & ~without_lowest(left)) : before;
    meeting_ = meeting;
    if (j.last) {
      if (meeting != RayMask<C>{}) {
        TransformJob<C> into;
        into.packet = packet;
        into.kind = TransformKind::kObject;
        into.active = meeting;
        into.matrix = o.matrix;
        enter.write(into);
      } else {
        ListJob<C> go_on;
        go_on.packet = packet;
        missed.write(go_on);
      }
    }
  }

 private:
  /// The part of a ray between two sides of the box; `behind` where both lie behind the eye.
  struct Interval {
    Distance near, far;
    bool behind;
  };
  static Interval along(const Slab<Real>& slab, Real reciprocal) {
    const bool down = reciprocal.sign();
    const Distance enters = distance(down ? slab.high : slab.low, reciprocal);
    const Distance leaves = distance(down ? slab.low : slab.high, reciprocal);
    return {enters.sign() ? Distance{} : enters, leaves, leaves.sign()};
  }
  static Distance distance(Bound<Real> bound, Real reciprocal) {
    return longer<Distance>(bound) * shorter<Distance>(reciprocal);
  }
  static Distance larger(Distance a, Distance b) { return a < b ? b : a; }
  static Distance smaller(Distance a, Distance b) { return b < a ? b : a; }

  RayMask<C> left_;     ///< rays of the packet that are yet to be tested
  RayMask<C> meeting_;  ///< of those that have been, the ones that meet the box
};

}  // namespace dynrt
