// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tokens of ray generation and shading (thesis 6.2), and of the rays that follow from hits: to
// lights and by reflection. C is a configuration (hls/configs).
#pragma once

#include "units/frame.h"
#include "units/memory_format.h"
#include "units/packet.h"
#include "units/repeated.h"

namespace dynrt {

/// The kind of a packet's rays, each time that they are traced.
enum class RayKind : unsigned char { kPrimary, kLight, kReflection };

/// The passes of the transformation that make one light or reflection ray. A light ray takes one, a
/// reflected ray three: into the object that was hit, through the triangle's mirror, and back.
/// Where the object is the world, the mirror alone.
enum class Derivation : unsigned char { kLight, kIntoObject, kMirror, kOutOfObject };

template <class C>
inline constexpr Derivation kFirstReflection =
    kTwoLevels<C> ? Derivation::kIntoObject : Derivation::kMirror;

/// The ray that has its own matrix.
template <class C>
struct DerivedRay {
  Derivation pass = Derivation::kLight;
  RayIndex<C> ray;
  HLS_FIELDS(pass, ray)
};

/// To the unit that makes such rays: a packet is shaded, or one ray's pass is done.
template <class C>
struct DerivationEvent {
  PacketId<C> packet;
  bool shaded = false;
  RayKind kind = RayKind::kPrimary;  ///< of the shaded rays
  RayMask<C> surfaces;               ///< of the shaded rays, those that have hit something
  RayMask<C> mirrors;                ///< of them, those that are reflected
  HLS_FIELDS(packet, shaded, kind, surfaces, mirrors)
};

/// The point where a ray has hit a surface: its light rays end there and its reflection begins.
template <class C>
struct SurfacePoint {
  typename C::Real t;
  OfInstance<C, MatrixNumber<C>> object;
  MatrixNumber<C> triangle;
  HLS_FIELDS(t, object, triangle)
};

/// The result of a ray. A light ray has `hit` if something lies before the surface to which it
/// goes, and the cosine at that surface.
template <class C>
struct Found {
  bool hit = false;
  typename C::Real cosine;
  typename C::Real t;
  OfInstance<C, MatrixNumber<C>> object;
  MatrixNumber<C> triangle;
  SurfaceColour<C> colour;
  hls::OptionalField<kHasMirrors<C>, uint<8>>
      mirror{};  ///< part of the light that is reflected, in 256ths
  HLS_FIELDS(hit, cosine, t, object, triangle, colour, mirror)
};

/// A packet's place in the image: the pixel of ray 0; the others follow row by row.
struct PixelPosition {
  uint<10> x;
  uint<10> y;
  HLS_FIELDS(x, y)
};
template <class C>
PixelPosition pixel_of(const PixelPosition& packet, RayIndex<C> ray) {
  constexpr unsigned kColumnBits = hls::index_width(packet_columns(kRays<C>));
  return {packet.x | ray.template bits<kColumnBits - 1, 0>().template zext<10>(),
          packet.y | ray.template bits<kRayBits<C> - 1, kColumnBits>().template zext<10>()};
}

template <class C>
struct ShadeJob {
  RepeatCount<C> repeat;  ///< steps less one: one to shade a ray, else kLastWrite
  PacketId<C> packet;
  hls::OptionalField<kHasSecondary<C>, RayKind> kind{};
  HLS_FIELDS(repeat, packet, kind)
};

/// The last of the steps that write a packet's pixels and hits: one for each word of a hit record.
template <class C>
inline constexpr RepeatCount<C> kLastWrite = RepeatCount<C>(kHitWords * kRays<C> - 1);

}  // namespace dynrt

template <>
inline constexpr unsigned hls::enum_width<dynrt::RayKind> = 2;
template <>
inline constexpr unsigned hls::enum_width<dynrt::Derivation> = 2;
