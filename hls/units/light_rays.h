// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Light rays: has a shaded packet's rays to the next light made, all at once beside the
// transformation (units/camera_rays.h), as long as a light is left (thesis 6.2.2). They go to the
// points that the primary rays have hit. Cores that reflect rays or make each light ray with a
// matrix of its own have units/secondary_rays.h instead.
#pragma once

#include "units/frame.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"

namespace dynrt {

template <class C>
struct LightRays {
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  struct State {
    RayMask<C> surfaces;  ///< rays that have hit something, for light rays to go there
    uint<4> light;
    HLS_FIELDS(surfaces, light)
  };

  hls::In<DerivationEvent<C>> derive;
  hls::Config<FrameRegisters<C>> frame;
  hls::RamWrite<RayMask<C>, kPackets> traced;
  hls::Out<TransformJob<C>> job;
  hls::Out<ShadeJob<C>> finished;  ///< no more rays: the pixels are complete
  hls::Ram1R1W<State, kPackets> states;
  HLS_PORTS(derive, frame, traced, job, finished)

  void step() {
    const DerivationEvent<C> d = derive.read();
    const FrameRegisters<C> config = frame.get();
    const State before = states.read(d.packet);
    const bool primary = d.kind == RayKind::kPrimary;
    const State now{primary ? d.surfaces : before.surfaces,
                    primary ? uint<4>(0) : hls::next(before.light)};
    states.write(d.packet, now);
    traced.write(d.packet, now.surfaces);

    const bool lit = now.light < config.lights.template trunc<4>();
    if (lit && now.surfaces != RayMask<C>{}) {
      TransformJob<C> light;
      light.packet = d.packet;
      light.kind = TransformKind::kSecondary;
      light.active = now.surfaces;
      light.matrix = MatrixNumber<C>::from(
          (config.light_matrix.template trunc<C::kMatrixBits>() + now.light).raw());
      light.extras.derived = DerivedRay<C>{Derivation::kLight, {}};
      light.extras.viewpoint = Viewpoint<C>::from((now.light + uint<1>(1)).raw());
      job.write(light);
    } else {
      ShadeJob<C> done;
      done.repeat = kLastWrite<C>;
      done.packet = d.packet;
      finished.write(done);
    }
  }
};

}  // namespace dynrt
