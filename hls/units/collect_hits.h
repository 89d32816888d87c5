// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Collect hits: keeps the closest hit of every ray (thesis 6.1.1): distance, barycentric
// coordinates, scalar product with the normal, object, triangle and colour. Of equal distances the
// first stays. After a packet's last ray the list goes on, or, where the rays were new, the
// traversal may start.
//
// A light ray comes from the light and ends at the surface, t = 1: a hit before that is a shadow,
// and the surface's own triangle gives the cosine of the light. A reflected ray begins where it is
// reflected, at the hit distance of the arriving ray (thesis 6.2.3). Neither sees the triangle that
// it belongs to; margins relative to t keep rounding from casting a shadow or a reflection of the
// neighbouring one. Only a sphere may shadow itself: its far side is in its own shadow.
#pragma once

#include "units/intersection_tokens.h"
#include "units/packet_rays.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct CollectHits {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  /// A margin is 2^-9 of t, or four steps of a mantissa that is too short for that.
  static constexpr unsigned kMarginBits = std::min(9u, Real::kMantissaBits - 2);
  /// The state of a ray so far.
  struct Closest {
    Real t;
    hls::OptionalField<kHasSecondary<C>, RayKind> kind;
    hls::OptionalField<kHasMirrors<C>, Real> start;  ///< of a reflected ray
    hls::OptionalField<kHasLights<C>, bool> shadow;  ///< of a light ray
    hls::OptionalField<kHasLights<C>, Real> cosine;  ///< of a light ray with the surface's normal
    HLS_FIELDS(t, kind, start, shadow, cosine)
  };

  hls::In<HitCandidate<C>> candidate;
  hls::RamRead<JobRecord<C>, kPackets> record;
  hls::OptionalPort<kTwoLevels<C>, hls::RamRead<MatrixNumber<C>, kPackets>> object;
  hls::Out<ListJob<C>> go_on;
  hls::Out<MailboxEntry<C>> start;
  hls::RamWrite<Real, kPackets> distance[kRays<C>];
  hls::OptionalPort<kTestsWorldBox<C>, hls::RamWrite<Real, kRayRows<C>>> reach;  ///< the distances
  hls::RamWrite<HitRecord<C>, kRayRows<C>> hit;  ///< of primary rays
  hls::OptionalPort<kHasSecondary<C> && !kLightsAtOnce<C>, hls::Out<DerivationEvent<C>>> derived;
  hls::OptionalPort<kHasSecondary<C>, hls::RamRead<SurfacePoint<C>, kRayRows<C>>> surface;
  hls::OptionalPort<kHasSecondary<C>, hls::RamWrite<Found<C>, kRayRows<C>>> found;
  hls::OptionalPort<kHasMirrors<C>, hls::RamWrite<Real, kPackets>> start_distance[kRays<C>];
  hls::Ram1R1W<Closest, kRayRows<C>> closest;
  HLS_PORTS(candidate, record, object, go_on, start, distance, reach, hit, derived, surface, found,
            start_distance)

  void step() {
    const HitCandidate<C> in = candidate.read();
    const JobRecord<C> job = record.read(in.packet);
    OfInstance<C, MatrixNumber<C>> instance;
    if constexpr (kTwoLevels<C>) instance = object.read(in.packet);
    const RayRow<C> row = ray_row<C>(in.packet, in.ray);
    const bool alone = kHasSecondary<C> && job.kind == TransformKind::kSecondary;
    SurfacePoint<C> from;
    if constexpr (kHasSecondary<C>) from = surface.read(row);

    const Closest before = closest.read(row);
    const Closest begun = begin(job, from);
    const RayKind kind = before.kind.get();
    const bool own =
        kind != RayKind::kPrimary && is_same(instance, from.object) && job.matrix == from.triangle;
    // A ray that is not traced now keeps its earlier result.
    const bool traced = !kHasSecondary<C> || job.active.bit(static_cast<unsigned>(in.ray.to_u64()));
    const bool before_itself =
        kind == RayKind::kLight && is_primitive<C>(Primitive::kSphere, job.primitive);
    const bool closer = in.hit && traced && (!own || before_itself) && in.t < before.t &&
                        (kind != RayKind::kReflection || before.start.get() < in.t);
    const bool lit = kind == RayKind::kLight && own && traced;

    Closest now = in.reset ? begun : before;
    if (!in.reset && closer) {
      now.t = in.t;
      now.shadow = true;
    }
    if (!in.reset && lit) now.cosine = in.cosine;

    const HitRecord<C> best = record_of(in, instance, job);
    if (in.reset || closer || lit) closest.write(row, now);
    if (in.reset || closer) {
      const Real far = in.reset && alone && is_light(job) ? kReach : now.t;
      write_of_ray(distance, in.ray, in.packet, far);
      if constexpr (kTestsWorldBox<C>) reach.write(row, far);
    }
    if ((in.reset && !alone) || (closer && kind == RayKind::kPrimary)) hit.write(row, best);
    if constexpr (kHasSecondary<C>) {
      const bool light = kind == RayKind::kLight && !in.reset;
      Found<C> f{light ? now.shadow.get() : best.hit,
                 light ? now.cosine.get() : best.cosine,
                 best.t,
                 best.object,
                 best.triangle,
                 best.colour,
                 job.mirror};
      if (in.reset || closer || lit) found.write(row, f);
    }
    if constexpr (kHasMirrors<C>) {
      for (unsigned i = 0; i < kRays<C>; ++i) {
        if (in.reset && in.ray == RayIndex<C>::from(i)) {
          start_distance[i].write(in.packet, begun.start.get());
        }
      }
    }

    go_on_after(in, job, begun, alone);
  }

 private:
  static HitRecord<C> record_of(const HitCandidate<C>& in,
                                const OfInstance<C, MatrixNumber<C>>& instance,
                                const JobRecord<C>& job) {
    HitRecord<C> best;
    best.hit = !in.reset;
    best.t = in.reset ? Real::largest() : in.t;
    if (!in.reset) {
      best.u = in.u;
      best.v = in.v;
      best.cosine = in.cosine;
      best.object = instance;
      best.triangle = job.matrix;
      if constexpr (!C::kOneColour) best.colour = job.extra;
    }
    return best;
  }
  /// A ray that is made alone is followed by the next; the last ray of a packet by its list, or, if
  /// the rays are new, by the traversal.
  void go_on_after(const HitCandidate<C>& in, const JobRecord<C>& job, const Closest& begun,
                   bool alone) {
    if (in.reset && alone && !kLightsAtOnce<C>) {
      if constexpr (kHasSecondary<C> && !kLightsAtOnce<C>) {
        DerivationEvent<C> go_on_deriving;
        go_on_deriving.packet = in.packet;
        derived.write(go_on_deriving);
      }
    } else if (is_last_ray<C>(in.ray, in.last)) {
      if (in.reset) {
        MailboxEntry<C> begin_packet;
        begin_packet.packet = in.packet;
        begin_packet.active = job.active;
        begin_packet.clear = true;
        if constexpr (kLightsAtOnce<C>) {
          begin_packet.kind = begun.kind.get();
          begin_packet.viewpoint = job.viewpoint;
        }
        start.write(begin_packet);
      } else {
        ListJob<C> next;
        next.packet = in.packet;
        next.level = Level(1);
        go_on.write(next);
      }
    }
  }
  /// The end of a light ray's shadows, and the end of the ray behind the surface's triangle.
  static constexpr Real kShadowEnd = Real::from_double(1.0 - 1.0 / (1u << kMarginBits));
  static constexpr Real kReach = Real::from_double(1.0 + 1.0 / (1u << kMarginBits));

  using Instance = OfInstance<C, MatrixNumber<C>>;
  static bool is_same(const Instance& a, const Instance& b) {
    if constexpr (kTwoLevels<C>) {
      return a == b;
    } else {
      return true;
    }
  }
  static bool is_light(const JobRecord<C>& job) {
    return kHasLights<C> && job.derived.get().pass == Derivation::kLight;
  }
  /// t and the margin behind it, in steps of the mantissa.
  static Real behind(Real t) {
    return t.template moved_up<(1u << (Real::kMantissaBits - kMarginBits))>();
  }
  static Closest begin(const JobRecord<C>& job, const SurfacePoint<C>& from) {
    const bool alone = kHasSecondary<C> && job.kind == TransformKind::kSecondary;
    const bool light = alone && is_light(job);
    Closest c;
    c.t = light ? kShadowEnd : Real::largest();
    c.kind = !alone ? RayKind::kPrimary : light ? RayKind::kLight : RayKind::kReflection;
    c.start = alone && !light ? behind(from.t) : Real{};
    return c;
  }
};

}  // namespace dynrt
