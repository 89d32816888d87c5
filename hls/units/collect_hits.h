// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Collect hits: keeps the closest hit of every ray (thesis 6.1.1): distance, barycentric
// coordinates, scalar product with the normal, object, triangle and colour. Of equal distances the
// first stays. After a packet's last ray the list goes on, or, where the rays were new, the
// traversal may start.
#pragma once

#include "units/tokens.h"

namespace dynrt {

template <class C>
using HitRow = uint<PacketId<C>::kWidth + 2>;

template <class C>
struct CollectHits {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  static constexpr unsigned kHitRows = 4 * kPackets;

  hls::In<HitCandidate<C>> candidate;
  hls::RamRead<JobRecord<C>, kPackets> record;
  hls::RamRead<MatrixIndex, kPackets> object;
  hls::Out<ListJob<C>> go_on;
  hls::Out<MailboxEntry<C>> start;
  hls::RamWrite<Real, kPackets> distance[kRays];
  hls::RamWrite<HitRecord<C>, kHitRows> hit;
  hls::Ram1R1W<Real, kHitRows> closest;
  HLS_PORTS(candidate, record, object, go_on, start, distance[0], distance[1], distance[2],
            distance[3], hit)

  void step() {
    const HitCandidate<C> in = candidate.read();
    const JobRecord<C> job = record.read(in.packet);
    const MatrixIndex instance = object.read(in.packet);
    const HitRow<C> row = hls::concat(in.packet, in.ray);
    const bool closer = in.hit && in.t < closest.read(row);

    if (in.reset || closer) {
      HitRecord<C> best;
      best.hit = !in.reset;
      best.t = in.reset ? Real::largest() : in.t;
      if (!in.reset) {
        best.u = in.u;
        best.v = in.v;
        best.cosine = in.cosine;
        best.object = instance;
        best.triangle = job.matrix;
        best.colour = job.extra;
      }
      closest.write(row, best.t);
      hit.write(row, best);
      for (unsigned i = 0; i < kRays; ++i) {
        if (in.ray == RayIndex::from(i)) distance[i].write(in.packet, best.t);
      }
    }
    if (in.ray == RayIndex(3)) {
      if (in.reset) {
        MailboxEntry<C> begin;
        begin.packet = in.packet;
        begin.active = job.active;
        begin.clear = true;
        start.write(begin);
      } else {
        ListJob<C> next;
        next.packet = in.packet;
        next.level = 1;
        go_on.write(next);
      }
    }
  }
};

}  // namespace dynrt
