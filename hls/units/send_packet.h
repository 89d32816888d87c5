// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Send packet: reads the rays of a packet and sends them to the transformation one vector a clock
// (thesis 6.1.3). A compressed packet is its common origin and four directions, five vectors; any
// other is four pairs of origin and direction, eight. The camera transforms the pre-primary rays
// (0, 0, 0) and (x, y, 1) of section 6.2.1, an object the packet's world rays, a triangle its rays
// in the object.
#pragma once

#include "units/tokens.h"

namespace dynrt {

/// Row of the vector store: level, packet and the vector's number in the uncompressed order
/// (2 * ray is the origin, 2 * ray + 1 the direction).
template <class C>
using VectorRow = uint<LevelRow<C>::kWidth + 3>;
template <class C>
inline constexpr unsigned kVectorRows = 1u << VectorRow<C>::kWidth;

template <class C>
struct SendPacket {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<Repeated<SendJob<C>>> job;
  hls::Out<PacketVector<C>> vector;
  hls::RamRead<Vector<Real>, kVectorRows<C>> vectors;
  hls::RamRead<PixelPosition, kPackets> position;
  HLS_PORTS(job, vector, vectors, position)

  void step() {
    const Repeated<SendJob<C>> j = job.read();
    const bool compressed = j.job.repeat == RepeatCount(4);
    const bool point = compressed ? j.index == RepeatCount{} : !j.index.template bit<0>();
    const RayIndex ray = !compressed ? j.index.template bits<2, 1>()
                         : point     ? RayIndex{}
                                     : RayIndex::from(j.index.raw() - 1);

    const Level level = uint<1>(j.job.kind == TransformKind::kTriangle);
    const uint<3> number = hls::concat(ray, uint<1>(!point));
    const Vector<Real> stored =
        vectors.read(hls::concat(level_row<C>(level, j.job.packet), number));

    const PixelPosition p = position.read(j.job.packet);
    const uint<10> x = p.x | ray.template bits<0, 0>().template zext<10>();
    const uint<10> y = p.y | ray.template bits<1, 1>().template zext<10>();
    const Vector<Real> pre_primary =
        point ? Vector<Real>{Real{}, Real{}, Real{}}
              : Vector<Real>{Real::from_uint(x), Real::from_uint(y), Real::from_double(1.0)};

    const bool camera = j.job.kind == TransformKind::kCamera;
    vector.write(PacketVector<C>{j.job.packet, point, ray, camera ? pre_primary : stored});
  }
};

}  // namespace dynrt
