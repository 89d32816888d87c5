// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Unit decoder: puts rays in unit space together again, apart from those that the packet decoder
// saves, so that neither waits for the other.
#pragma once

#include "units/intersection_tokens.h"
#include "units/transformation_tokens.h"

namespace dynrt {

template <class C>
struct UnitDecoder {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<PacketVector<C>> vector;
  hls::OptionalPort<kMarksUnitRays<C>, hls::RamRead<JobRecord<C>, kPackets>> record;
  hls::Out<UnitRay<C>> unit_ray;
  HLS_PORTS(vector, record, unit_ray)

  void step() {
    const PacketVector<C> in = vector.read();
    JobRecord<C> job;
    if constexpr (kMarksUnitRays<C>) job = record.read(in.packet);
    if (in.point) {
      origin_ = in.vector;
    } else {
      unit_ray.write(unit_ray_of(in, job, false, {origin_, in.vector}));
    }
  }

 private:
  Vector<Real> origin_;  ///< of the packet, whose vectors come one after the other
};

}  // namespace dynrt
