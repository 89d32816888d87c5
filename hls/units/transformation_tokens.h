// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tokens of the transformation (thesis 6.1.3). C is a configuration (hls/configs).
#pragma once

#include "units/packet.h"
#include "units/repeated.h"
#include "units/shading_tokens.h"

namespace dynrt {

enum class TransformKind : unsigned char {
  kCamera,
  kObject,
  kTriangle,
  kSecondary,
  kBox = kSecondary,  ///< no transformation: an object's box is fetched (fetches_box)
};

/// Fields of a transformation in configurations with rays beyond the primary ones or with several
/// primitives.
template <class C>
struct TransformExtras {
  hls::OptionalField<kHasSecondary<C>, DerivedRay<C>> derived{};  ///< of kSecondary
  hls::OptionalField<kHasMirrors<C>, bool>
      distinct_origins{};         ///< the packet's rays have no common origin
  PrimitiveField<C> primitive{};  ///< of kTriangle
  [[no_unique_address]] hls::OptionalField<kTestsBoxOfLight<C>, Viewpoint<C>>
      viewpoint{};  ///< of kBox and of light rays
  HLS_FIELDS(derived, distinct_origins, primitive, viewpoint)
};

/// A pass that marks a box among the jobs of kSecondary: cores that test boxes reflect no rays.
inline constexpr Derivation kBoxPass = Derivation::kIntoObject;

template <class C>
constexpr bool fetches_box(TransformKind kind, const TransformExtras<C>& extras) {
  return kTestsWorldBox<C> && kind == TransformKind::kBox &&
         (!kHasSecondary<C> || extras.derived.get().pass == kBoxPass);
}

template <class C>
struct TransformJob {
  RepeatCount<C> repeat = 3;  ///< columns of the matrix in the memory, less one
  PacketId<C> packet;
  TransformKind kind = TransformKind::kCamera;
  RayMask<C> active;
  MatrixNumber<C> matrix;
  TransformExtras<C> extras{};
  HLS_FIELDS(repeat, packet, kind, active, matrix, extras)
};

template <class C>
struct ColumnContext {
  PacketId<C> packet;
  TransformKind kind = TransformKind::kCamera;
  RayMask<C> active;
  uint<2> column;  ///< as it is stored
  TransformExtras<C> extras{};
  hls::OptionalField<kThreeColumns<C>, MatrixNumber<C>> matrix{};  ///< otherwise the address has it
  HLS_FIELDS(packet, kind, active, column, extras, matrix)
};

/// The state of a packet's transformation in progress. What a core of triangles alone puts rays
/// together by comes first: it fits a block of RAM.
template <class C>
struct JobRecord {
  TransformKind kind = TransformKind::kCamera;
  RayMask<C> active;
  MatrixExtra<C> extra;
  MatrixNumber<C> matrix;
  hls::OptionalField<kHasSecondary<C>, DerivedRay<C>> derived{};
  hls::OptionalField<kHasMirrors<C>, uint<8>> mirror{};  ///< of a triangle
  hls::OptionalField<kSplitsPackets<C>, bool>
      distinct_origins{};  ///< the packet's rays have no common origin
  PrimitiveField<C> primitive{};
  hls::OptionalField<kScalesCosine<C>, typename C::Real> cosine_factor{};
  [[no_unique_address]] hls::OptionalField<kTestsBoxOfLight<C>, Viewpoint<C>>
      viewpoint{};  ///< of light rays
  HLS_FIELDS(kind, active, extra, matrix, derived, mirror, distinct_origins, primitive,
             cosine_factor, viewpoint)
};

template <class C>
struct SendJob {
  /// Vectors less one. They are one and one more for each ray of a compressed packet, two for each
  /// of another, two of a ray alone, three for each ray of all corners.
  RepeatCount<C> repeat;
  PacketId<C> packet;
  TransformKind kind = TransformKind::kCamera;
  hls::OptionalField<kHasSecondary<C>, DerivedRay<C>> derived{};
  [[no_unique_address]] LeafRays<C> sent{};
  [[no_unique_address]] hls::OptionalField<kFast<C>, bool>
      pairs{};  ///< each of them has an origin of its own
  HLS_FIELDS(repeat, packet, kind, derived, sent, pairs)
};

/// An object whose box a packet's rays are tested against, one ray a clock.
template <class C>
struct BoxJob {
  RepeatCount<C> repeat;  ///< rays less one
  PacketId<C> packet;
  HLS_FIELDS(repeat, packet)
};
template <class C>
struct BoxedObject {
  MatrixNumber<C> matrix;  ///< the object's
  RayMask<C> rays;         ///< to be tested
  WorldBoxSlabs<typename C::Real> slabs;
  HLS_FIELDS(matrix, rays, slabs)
};

/// Row of the point where rays that are made beside the transformation start: all packets that
/// start at the eye share one; where others start at a light, each packet has its own.
template <class C>
inline constexpr unsigned kEyeRows = kLightsAtOnce<C> ? 1u << PacketId<C>::kWidth : 1;
template <class C>
using EyeRow = uint<hls::index_width(kEyeRows<C>)>;
template <class C>
constexpr EyeRow<C> eye_row(PacketId<C> packet) {
  if constexpr (kLightsAtOnce<C>) {
    return packet;
  } else {
    return {};
  }
}

/// A packet whose camera or light rays are made beside the transformation.
template <class C>
struct CameraJob {
  RepeatCount<C> repeat = 3 * kRays<C> - 1;  ///< components of directions, less one
  PacketId<C> packet;
  [[no_unique_address]] hls::OptionalField<kLightsAtOnce<C>, bool> to_light{};
  [[no_unique_address]] hls::OptionalField<kLightsAtOnce<C>, RayMask<C>>
      lit{};  ///< rays to a light; of the camera all are made
  HLS_FIELDS(repeat, packet, to_light, lit)
};

/// A corner of a triangle, or kNoCorner.
using Corner = uint<2>;
inline constexpr unsigned kNoCorner = 3;

/// One vector on its way through the transformation. Compressed packets send the common origin and
/// a direction for each ray, others pairs of origin and direction. To map a triangle's corners a
/// ray's direction is sent once for each (units/watertight.h).
template <class C>
struct PacketVector {
  PacketId<C> packet;
  bool point = false;  ///< a point is translated, a direction is not (thesis 4.4)
  RayIndex<C> ray;     ///< 0 for a common origin
  Vector<typename C::Real> vector;
  [[no_unique_address]] LastRay<C> last{};
  hls::OptionalField<kMapsCorners<C>, Corner> corner = Corner(kNoCorner);
  hls::OptionalField<kMapsCorners<C>, typename C::Real> cosine{};  ///< with a corner that is mapped
  [[no_unique_address]] hls::OptionalField<kFast<C>, bool> to_unit{};  ///< by a triangle's matrix
  HLS_FIELDS(packet, point, ray, vector, last, corner, cosine, to_unit)
};

}  // namespace dynrt

template <>
inline constexpr unsigned hls::enum_width<dynrt::TransformKind> = 2;
