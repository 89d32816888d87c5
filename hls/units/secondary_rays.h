// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Secondary rays: decides which rays of a packet follow those that have been shaded, and has the
// transformation make them (thesis 6.2.2, 6.2.3). Each light or reflection ray takes a matrix of
// its own, so a packet's are made one after the other: a light ray in one pass of the
// transformation, a reflected one in three. When the last is ready the packet's traversal may
// start.
#pragma once

#include "units/frame.h"
#include "units/packet_rays.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct SecondaryRays {
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  struct State {
    RayKind kind = RayKind::kLight;
    RayMask<C> rays;     ///< to be traced
    RayMask<C> missing;  ///< of them, not yet made; the lowest is being made
    Derivation pass = Derivation::kLight;
    RayMask<C> surfaces;  ///< rays that have hit something, for light rays to go there
    RayMask<C> mirrors;   ///< of them, those that are reflected when all lights have been
    uint<4> light;
    uint<4> bounces;
    HLS_FIELDS(kind, rays, missing, pass, surfaces, mirrors, light, bounces)
  };

  hls::In<DerivationEvent<C>> derive;
  hls::Config<FrameRegisters<C>> frame;
  hls::OptionalPort<kHasMirrors<C>, hls::RamRead<SurfacePoint<C>, kRayRows<C>>> surface;
  hls::RamWrite<RayMask<C>, kPackets> traced;
  hls::Out<TransformJob<C>> job;
  hls::Out<MailboxEntry<C>> start;
  hls::Out<ShadeJob<C>> finished;  ///< no more rays: the pixels are complete
  hls::Ram1R1W<State, kPackets> states;
  HLS_PORTS(derive, frame, surface, traced, job, start, finished)

  void step() {
    const DerivationEvent<C> d = derive.read();
    State s = states.read(d.packet);
    if (d.shaded) {
      s = next_rays(s, d);
    } else if (kTwoLevels<C> && kHasMirrors<C> && s.pass == Derivation::kIntoObject) {
      s.pass = Derivation::kMirror;
    } else if (kTwoLevels<C> && kHasMirrors<C> && s.pass == Derivation::kMirror) {
      s.pass = Derivation::kOutOfObject;
    } else {
      s.missing = without_lowest(s.missing);
      s.pass = first_pass(s.kind);
    }
    states.write(d.packet, s);
    if (d.shaded) traced.write(d.packet, s.rays);

    const RayIndex<C> ray = lowest_ray<C>(s.missing);
    SurfacePoint<C> point;
    if constexpr (kHasMirrors<C>) point = surface.read(ray_row<C>(d.packet, ray));
    if (d.shaded && s.rays == RayMask<C>{}) {
      ShadeJob<C> done;
      done.repeat = kLastWrite<C>;
      done.packet = d.packet;
      finished.write(done);
    } else if (s.missing == RayMask<C>{}) {
      MailboxEntry<C> begin;
      begin.packet = d.packet;
      begin.clear = true;
      begin.active = s.rays;
      begin.kind = s.kind;
      begin.viewpoint = Viewpoint<C>::from((s.light + uint<1>(1)).raw());
      start.write(begin);
    } else {
      TransformJob<C> transform;
      transform.packet = d.packet;
      transform.kind = TransformKind::kSecondary;
      transform.active = s.rays;
      transform.matrix = matrix(s, point);
      transform.extras.derived = DerivedRay<C>{s.pass, ray};
      job.write(transform);
    }
  }

 private:
  /// After a packet has been shaded: light rays from the next light to the hits of the other rays,
  /// after the last light the reflections, and so on; no rays when all is done.
  State next_rays(State s, const DerivationEvent<C>& d) const {
    const FrameRegisters<C> config = frame.get();
    const bool after_light = d.kind == RayKind::kLight;
    if (d.kind == RayKind::kPrimary) s.bounces = 0;
    if (!after_light) {
      const bool last = s.bounces == config.reflections.template trunc<4>();
      s.surfaces = d.surfaces;
      s.mirrors = last ? RayMask<C>{} : d.mirrors;
    }
    s.light = after_light ? hls::next(s.light) : uint<4>(0);
    const bool lights = kHasLights<C> && s.light < config.lights.template trunc<4>();
    if (lights && s.surfaces != RayMask<C>{}) {
      s.kind = RayKind::kLight;
      s.rays = s.surfaces;
    } else {
      s.kind = RayKind::kReflection;
      s.rays = kHasMirrors<C> ? s.mirrors : RayMask<C>{};
      s.bounces = hls::next(s.bounces);
    }
    s.missing = s.rays;
    s.pass = first_pass(s.kind);
    return s;
  }
  static Derivation first_pass(RayKind kind) {
    return kHasMirrors<C> && kind == RayKind::kReflection ? kFirstReflection<C>
                                                          : Derivation::kLight;
  }

  /// An instance's way back to the world and a triangle's mirror lie behind their own matrices.
  MatrixNumber<C> matrix(const State& s, const SurfacePoint<C>& point) const {
    const MatrixNumber<C> light =
        MatrixNumber<C>::from(frame.get().light_matrix.template trunc<C::kMatrixBits>().raw() +
                              MatrixNumber<C>::from(s.light.raw()).raw());
    if constexpr (!kHasMirrors<C>) {
      return light;
    } else if constexpr (!kTwoLevels<C>) {
      return s.pass == Derivation::kMirror ? hls::next(point.triangle) : light;
    } else {
      switch (s.pass) {
        case Derivation::kIntoObject:
          return point.object;
        case Derivation::kMirror:
          return hls::next(point.triangle);
        case Derivation::kOutOfObject:
          return hls::next(point.object);
        default:
          return light;
      }
    }
  }
};

}  // namespace dynrt
