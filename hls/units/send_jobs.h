// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A part of the matrix store: the vectors that a packet with a whole matrix sends through the
// transformation (thesis 6.1.3). All rays of a packet are sent, and a camera's as all others.
#pragma once

#include "units/memory_tokens.h"
#include "units/transformation_tokens.h"

namespace dynrt {

/// What kind of vectors a packet sends, beside an origin and a direction for each ray.
struct SentVectors {
  bool one_ray;           ///< a ray alone: an origin and a direction
  bool corners;           ///< a direction for each corner of a triangle (units/watertight.h)
  bool blocks;            ///< directions alone (units/plane_map.h)
  bool distinct_origins;  ///< of the rays; otherwise one origin and the directions
};

template <class C>
struct SendAllRays {
  hls::Out<SendJob<C>> ready;
  HLS_PORTS(ready)

  void store_camera(const ColumnReply<C>& /*reply*/, const Vector<typename C::Real>& /*values*/) {}
  void send_on(const ColumnReply<C>& r, const SentVectors& v) {
    SendJob<C> send;
    send.repeat = v.corners            ? RepeatCount<C>(3 * kRays<C> - 1)
                  : v.blocks           ? RepeatCount<C>(kRays<C> - 1)
                  : v.one_ray          ? RepeatCount<C>(1)
                  : v.distinct_origins ? RepeatCount<C>(2 * kRays<C> - 1)
                                       : RepeatCount<C>(kRays<C>);
    send.packet = r.context.packet;
    send.kind = r.context.kind;
    send.derived = r.context.extras.derived;
    ready.write(send);
  }
};

}  // namespace dynrt
