// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Send packet: reads the rays of a packet and sends them to the transformation one vector a clock
// (thesis 6.1.3). A compressed packet is its common origin and a direction for each ray; any other
// is a pair of origin and direction for each. The camera transforms the pre-primary rays (0, 0, 0)
// and (x, y, 1) of section 6.2.1, an object the packet's world rays, a triangle its rays in the
// object. A ray with a matrix of its own is sent alone: a light's transforms the ray (0, 0, 0), (1,
// t, -1) of section 6.2.2, a reflection's the ray that is reflected (6.2.3). For a watertight test
// each ray's direction is sent three times, once for each corner of the triangle; once, without an
// origin, where the corners have that subtracted already.
#pragma once

#include "units/packet_rays.h"
#include "units/repeated.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"

namespace dynrt {

/// Row of the vector store: level, packet and the vector's number in the uncompressed order
/// (2 * ray is the origin, 2 * ray + 1 the direction), or the ray, where the store has directions
/// alone: the rays of a packet have one origin, which the traversal's store has.
template <class C>
using VectorRow = uint<LevelRow<C>::kWidth + kRayBits<C> + (kCommonOrigin<C> ? 0 : 1)>;
template <class C>
inline constexpr unsigned kVectorRows = 1u << VectorRow<C>::kWidth;
template <class C>
constexpr VectorRow<C> vector_row(LevelRow<C> row, RayIndex<C> ray, bool point) {
  if constexpr (kCommonOrigin<C>) {
    return hls::concat(row, ray);
  } else {
    return hls::concat(row, hls::concat(ray, uint<1>(!point)));
  }
}

template <class C>
inline constexpr bool kSendsLightRays = kHasLights<C> && !kLightsAtOnce<C>;

template <class C>
struct SendPacket {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<Repeated<SendJob<C>>> job;
  hls::Out<PacketVector<C>> vector;
  hls::RamRead<Vector<Real>, kVectorRows<C>> vectors;
  hls::OptionalPort<kCommonOrigin<C>, hls::RamRead<Vector<Real>, kLevelRows<C>>> origin;
  hls::OptionalPort<!kFast<C>, hls::RamRead<PixelPosition, kPackets>> position;
  hls::OptionalPort<kSendsLightRays<C>, hls::RamRead<SurfacePoint<C>, kRayRows<C>>> surface;
  hls::OptionalPort<kHasMirrors<C>, hls::RamRead<Ray<Real>, kRayRows<C>>> arriving;
  HLS_PORTS(job, vector, vectors, origin, position, surface, arriving)

  void step() {
    const Repeated<SendJob<C>> j = job.read();
    const bool corners = kMapsCorners<C> && j.job.kind == TransformKind::kTriangle;
    const bool blocks = kMapsBlocks<C> && j.job.kind == TransformKind::kTriangle;
    const bool alone = kHasSecondary<C> && j.job.kind == TransformKind::kSecondary;
    const bool compressed = kFast<C>                 ? !corners && !alone && !j.job.pairs.get()
                            : kHasDistinctOrigins<C> ? j.job.repeat == RepeatCount<C>(kRays<C>)
                                                     : !corners && !alone;
    const DerivedRay<C> derived = j.job.derived.get();
    const bool point = !corners && !blocks &&
                       (compressed ? j.index == RepeatCount<C>{} : !j.index.template bit<0>());
    const RayIndex<C> ray = kFast<C> && !alone ? next_active(j, point, compressed, corners)
                            : corners          ? ray_of(j.index)
                            : alone            ? derived.ray
                            : blocks           ? j.index.template trunc<kRayBits<C>>()
                            : !compressed      ? j.index.template bits<kRayBits<C>, 1>()
                            : point            ? RayIndex<C>{}
                                               : RayIndex<C>::from(j.index.raw() - 1);

    // Of a ray alone the passes after the first find it in the object.
    const Level level = uint<1>(j.job.kind == TransformKind::kTriangle || alone);
    const LevelRow<C> row = level_row<C>(level, j.job.packet);
    Vector<Real> stored = vectors.read(vector_row<C>(row, ray, point));
    if constexpr (kCommonOrigin<C>) {
      const Vector<Real> common = origin.read(row);
      if (point) stored = common;
    }

    Vector<Real> out = stored;
    if constexpr (!kFast<C>) {
      const PixelPosition p = pixel_of<C>(position.read(j.job.packet), ray);
      const Vector<Real> pre_primary =
          point ? Vector<Real>{Real{}, Real{}, Real{}}
                : Vector<Real>{Real::from_uint(p.x), Real::from_uint(p.y), Real::from_double(1.0)};
      if (j.job.kind == TransformKind::kCamera) out = pre_primary;
    }
    if constexpr (kSendsLightRays<C>) {
      const Real t = surface.read(ray_row<C>(j.job.packet, ray)).t;
      const Vector<Real> pre_light =
          point ? Vector<Real>{Real{}, Real{}, Real{}} : Vector<Real>{Real::one(), t, -Real::one()};
      if (alone && derived.pass == Derivation::kLight) out = pre_light;
    }
    if constexpr (kHasMirrors<C>) {
      const Ray<Real> r = arriving.read(ray_row<C>(j.job.packet, ray));
      if (alone && derived.pass == kFirstReflection<C>) out = point ? r.origin : r.direction;
    }
    PacketVector<C> sent{j.job.packet, point, ray, out};
    if (corners) sent.corner = corner_of(j.index);
    sent.last = j.last;
    sent.to_unit = j.job.kind == TransformKind::kTriangle;
    vector.write(sent);
  }

 private:
  /// Of the rays that are sent, the one whose turn it is; 0 for a common origin.
  RayIndex<C> next_active(const Repeated<SendJob<C>>& j, bool point, bool compressed,
                          bool corners) {
    const RayMask<C> left = j.index == RepeatCount<C>{} ? j.job.sent.get() : left_.get();
    const bool ends = corners ? corner_of(j.index) == Corner(2) : !point;
    left_ = ends ? without_lowest(left) : left;
    return point && compressed ? RayIndex<C>{} : lowest_ray<C>(left);
  }
  /// Of three corners for each ray.
  static RayIndex<C> ray_of(RepeatCount<C> index) {
    RayIndex<C> ray(kRays<C> - 1);
    for (unsigned i = kRays<C> - 1; i-- > 0;) {
      if (index < RepeatCount<C>::from(3 * (i + 1))) ray = RayIndex<C>::from(i);
    }
    return ray;
  }
  static Corner corner_of(RepeatCount<C> index) {
    const RayIndex<C> ray = ray_of(index);
    return Corner::from((index - (ray + hls::concat(ray, uint<1>(0)))).raw());
  }

  LeafRays<C> left_;  ///< of the packet, whose vectors are sent one after the other
};

}  // namespace dynrt
