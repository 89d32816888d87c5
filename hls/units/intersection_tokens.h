// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tokens of the intersection and the hits that it finds (thesis 6.1.4, 5.2). C is a configuration
// (hls/configs).
#pragma once

#include <type_traits>

#include "units/packet.h"
#include "units/plane_hit.h"
#include "units/transformation_tokens.h"
#include "units/watertight.h"

namespace dynrt {

/// The ray in unit space, or the triangle in the ray's.
template <class C>
using UnitTest = std::conditional_t<
    kMapsCorners<C>, MappedTriangle<typename C::Real>,
    std::conditional_t<kMapsBlocks<C>, PlaneTriangle<typename C::Real>, Ray<typename C::Real>>>;

template <class C>
struct UnitRay {
  PacketId<C> packet;
  RayIndex<C> ray;
  bool reset = false;  ///< not a test: the ray is new and has no hit yet
  UnitTest<C> unit;
  PrimitiveField<C> primitive{};
  hls::OptionalField<kScalesCosine<C>, typename C::Real> cosine_factor{};
  [[no_unique_address]] LastRay<C> last{};
  HLS_FIELDS(packet, ray, reset, unit, primitive, cosine_factor, last)
};

/// Whether a unit ray has more than its packet's vectors say.
template <class C>
inline constexpr bool kMarksUnitRays = kHasKinds<C> || kScalesCosine<C>;
template <class C>
constexpr UnitRay<C> unit_ray_of(const PacketVector<C>& in, const JobRecord<C>& job, bool reset,
                                 const Ray<typename C::Real>& ray) {
  return {in.packet, in.ray, reset, ray, job.primitive, job.cosine_factor, in.last};
}

template <class C>
struct HitCandidate {
  PacketId<C> packet;
  RayIndex<C> ray;
  bool reset = false;
  bool hit = false;
  typename C::Real t, u, v, cosine;
  [[no_unique_address]] LastRay<C> last{};
  HLS_FIELDS(packet, ray, reset, hit, t, u, v, cosine, last)
};

template <class C>
struct HitRecord {
  bool hit = false;
  typename C::Real t, u, v, cosine;
  OfInstance<C, MatrixNumber<C>> object;
  MatrixNumber<C> triangle;
  SurfaceColour<C> colour;
  HLS_FIELDS(hit, t, u, v, cosine, object, triangle, colour)
};

}  // namespace dynrt
