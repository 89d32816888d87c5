// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The packet of a configuration C (hls/configs): 2x2, 4x2 or 4x4 rays, masks with one bit per ray,
// ray 0 lowest; rows of the RAMs that keep something per packet, level or ray; and which parts of
// the core C has. Level 0 is the top-level tree over object instances, level 1 the tree of one
// object (thesis chapter 4). A core of one level has only the tree of one object, which lies in the
// world as it is: rays start in it, and tokens have no level.
#pragma once

#include <type_traits>

#include "hls/ports.h"
#include "units/memory_format.h"
#include "units/options.h"

namespace dynrt {

/// Rays per packet.
template <class C>
inline constexpr unsigned kRays = C::kPacketRays;

/// Whether there is a tree over instances above the trees of objects.
template <class C>
inline constexpr bool kTwoLevels = C::kLevels == 2;

/// Whether rays enter the main object of a scene before the tree over the others (thesis 4.3.3).
template <class C>
inline constexpr bool kMainFirst = kTwoLevels<C> && C::kMainFirst;

/// Whether a configuration traces rays beyond the primary ones (thesis 6.2.2, 6.2.3).
template <class C>
inline constexpr bool kHasLights = C::kLights > 0;
template <class C>
inline constexpr bool kHasMirrors = C::kReflections > 0;
template <class C>
inline constexpr bool kHasSecondary = kHasLights<C> || kHasMirrors<C>;

/// The treatment of reflected rays that cross (thesis 3.1.3). No other rays cross.
template <class C>
inline constexpr bool kSplitsPackets = kHasMirrors<C> && C::kCrossing == Crossing::kSplit;
template <class C>
inline constexpr bool kRemembersChild = kHasMirrors<C> && C::kCrossing == Crossing::kRemember;

/// Whether a packet's rays may have origins of their own when it is transformed.
template <class C>
inline constexpr bool kHasDistinctOrigins = C::kUncompressed || kHasMirrors<C>;

/// Whether the datapath is `fast`. Then rays that are not in a leaf are left out of what follows;
/// slices multiply with reciprocals of directions; a unit of its own makes camera rays, another
/// puts rays in unit space together; the sum of a transformation's products is rounded once; a
/// child that is a leaf is known by the pointer to it, which is to its list; and of the FIFOs of
/// packets those alone hold every packet that it takes to keep each loop moving (units/pipeline.h).
template <class C>
inline constexpr bool kFast = C::kDatapath == Datapath::kFast;

/// Whether the rays of a packet start at one point, as those of a camera and of a light do.
template <class C>
inline constexpr bool kCommonOrigin = C::kOrigins == Origins::kCommon;

/// Whether light rays are among those that are tested against an object's box in the world: each
/// light has boxes of its own, as they lie from there.
template <class C>
inline constexpr bool kTestsBoxOfLight = kTestsWorldBox<C> && (C::kLights > 0);
/// Where a packet's rays start: at the eye, 0, or at a light, its number and 1.
template <class C>
using Viewpoint = uint<hls::index_width(C::kLights + 1)>;

/// Tokens that the FIFOs of a unit take beyond those in its pipeline, at least, where bursts come
/// through: columns of a matrix, rays of a packet, decisions behind nodes that come from memory.
template <class C>
inline constexpr unsigned kRoomForBursts = kFast<C> ? 12 : 4;

/// ns of each clock that stay free in units that stand at wide RAMs or many multipliers: in a core
/// of eight rays, placed on an LFE5U-85F, their wires take as much more than the delay model says.
template <class C>
inline constexpr double kLongWiresNs = kRays<C> > 4 ? 0.8 : 0;

/// Whether the light rays of a packet are made beside the transformation too, all at once.
/// Otherwise each is a ray with a matrix of its own, as a reflected ray is.
template <class C>
inline constexpr bool kLightsAtOnce = kFast<C> && kHasLights<C> && !kHasMirrors<C>;

/// Whether no ray passes between two triangles that share an edge; whether the map of each ray then
/// takes the corners (units/watertight.h), or corners from which the packet's origin has been
/// subtracted (units/plane_map.h).
template <class C>
inline constexpr bool kWatertight = C::kTriangleTest == TriangleTest::kWatertight;
template <class C>
inline constexpr bool kMapsCorners = kWatertight<C> && !kFast<C>;
template <class C>
inline constexpr bool kMapsBlocks = kWatertight<C> && kFast<C>;
/// Whether a pair of origin and direction is what the triangle test of a fast core gets.
template <class C>
inline constexpr bool kPairsUnitRays = kFast<C> && !kWatertight<C>;
/// Steps of the mantissa by which a plane's distance may be wrong: one for each operation before
/// the last and a half for that, rounded to nearest; twice as many truncated
/// (docs/explanation/watertight.md). 0: ignored.
template <class C>
inline constexpr unsigned kDistanceOperations = kFast<C> ? 3 : 2;
template <class C>
inline constexpr unsigned kWidening =
    !kWatertight<C>                                     ? 0
    : C::Real::kRounding == hls::Rounding::kNearestEven ? kDistanceOperations<C>
                                                        : 2 * kDistanceOperations<C> - 1;

/// Whether triangles are stored in three columns (thesis 5.1.1).
template <class C>
inline constexpr bool kThreeColumns = C::kTriangleMatrix == TriangleMatrix::kMemoryEfficient;

/// Whether tokens must name the primitive that a ray meets (thesis 5.2).
template <class C>
inline constexpr bool kHasKinds = C::kPrimitives.count() > 1;
/// Whether the scalar product in unit space is to be scaled to be the one with the unit normal.
template <class C>
inline constexpr bool kScalesCosine = kThreeColumns<C> || C::kPrimitives.sphere;

/// The kind of primitive; a core with one kind lacks the field.
template <class C>
using PrimitiveField = hls::OptionalField<kHasKinds<C>, Primitive>;
template <class C>
constexpr bool is_primitive(Primitive which, const PrimitiveField<C>& field) {
  constexpr Primitives kSome = C::kPrimitives;
  const bool some = which == Primitive::kTriangle ? kSome.triangle
                    : which == Primitive::kSphere ? kSome.sphere
                                                  : kSome.rectangle;
  return some && (!kHasKinds<C> || field.get() == which);
}

/// A field that nearly all configurations have; the others lack it (hls::OptionalField).
template <bool Present, class T>
using UsualField = std::conditional_t<Present, T, hls::OptionalField<false, T>>;

/// The colour of a surface, 0x00BBGGRR, where surfaces have colours of their own.
template <class C>
using SurfaceColour = UsualField<!C::kOneColour, uint<24>>;
/// The spare bits of a matrix: the root of an object's tree, or a primitive's colour.
template <class C>
using MatrixExtra =
    UsualField<kTwoLevels<C> || !C::kOneColour, uint<C::kOneColour ? C::kAddressBits : 24>>;
/// A field of an instance, in cores that have several.
template <class C, class T>
using OfInstance = UsualField<kTwoLevels<C>, T>;

/// Numbers as the core has them on their way, in as many bits as the configuration's scenes take:
/// where a node or a list's entry lies, a matrix, one of its columns. A pointer to a list has the
/// highest bit set, and the others are half its address, as such lists begin at even addresses.
template <class C>
using NodeAddress = uint<C::kAddressBits>;
template <class C>
using MatrixNumber = uint<C::kMatrixBits>;
template <class C>
using ColumnAddress = uint<C::kMatrixBits + 2>;

template <class C>
constexpr bool is_list(NodeAddress<C> pointer) {
  return kFast<C> && pointer.template bit<C::kAddressBits - 1>();
}
template <class C>
constexpr NodeAddress<C> list_address(NodeAddress<C> pointer) {
  return hls::concat(pointer.template trunc<C::kAddressBits - 1>(), uint<1>(0));
}

template <class C>
using CoreNode = Node<typename C::Real, C::kAddressBits>;

/// The part of a list's entry that a core reads: kept where it has fewer bits for matrices than the
/// memory, or lines of several entries.
template <class C>
struct NarrowListEntry {
  MatrixNumber<C> matrix;
  PrimitiveField<C> kind{};
  bool last = false;
  HLS_FIELDS(matrix, kind, last)

  constexpr Primitive primitive() const { return kind.get(); }
};
template <class C>
inline constexpr bool kWholeEntries = C::kMatrixBits == kMatrixBits && C::kLineNodes == 1;
template <class C>
using CoreListEntry = std::conditional_t<kWholeEntries<C>, ListEntry, NarrowListEntry<C>>;
template <class C>
constexpr CoreListEntry<C> core_entry(const ListEntry& entry) {
  if constexpr (kWholeEntries<C>) {
    return entry;
  } else {
    return {entry.matrix.trunc<C::kMatrixBits>(), entry.primitive(), entry.last};
  }
}

template <class C>
using PacketId = uint<hls::index_width(C::kPackets)>;
using Level = uint<1>;
template <class C>
using RayMask = uint<kRays<C>>;
/// Bits of a ray's number in its packet, row by row.
template <class C>
inline constexpr unsigned kRayBits = hls::index_width(kRays<C>);
template <class C>
using RayIndex = uint<kRayBits<C>>;

/// The rays that are in a leaf, where the others are left out, and whether a token is of the last
/// of them. Where all are sent the last is the highest.
template <class C>
using LeafRays = hls::OptionalField<kFast<C>, RayMask<C>>;
template <class C>
using LastRay = hls::OptionalField<kFast<C>, bool>;
template <class C>
constexpr bool is_last_ray(RayIndex<C> ray, const LastRay<C>& last) {
  return kFast<C> ? last.get() : ray == RayIndex<C>(kRays<C> - 1);
}

/// Row of a RAM with one row for every ray.
template <class C>
using RayRow = uint<PacketId<C>::kWidth + kRayBits<C>>;
template <class C>
constexpr RayRow<C> ray_row(PacketId<C> packet, RayIndex<C> ray) {
  return hls::concat(packet, ray);
}
template <class C>
inline constexpr unsigned kRayRows = 1u << RayRow<C>::kWidth;

/// The level in a token, where there are two.
template <class C>
using LevelField = UsualField<kTwoLevels<C>, Level>;
/// Whether it is the tree of instances.
template <class C>
constexpr bool is_top(LevelField<C> level) {
  if constexpr (kTwoLevels<C>) {
    return level == Level{};
  } else {
    return false;
  }
}

/// Row of a RAM that is duplicated for the levels.
template <class C>
using LevelRow = uint<C::kLevels - 1 + PacketId<C>::kWidth>;
template <class C>
constexpr LevelRow<C> level_row(LevelField<C> level, PacketId<C> packet) {
  if constexpr (kTwoLevels<C>) {
    return hls::concat(level, packet);
  } else {
    return packet;
  }
}
template <class C>
inline constexpr unsigned kLevelRows = C::kLevels * (1u << PacketId<C>::kWidth);

/// Entries that each stack keeps, at most, the latest in a ring; to find the others a packet starts
/// again at the root (units/restart_trail.h). It finds its way by the order of a node's children,
/// which only rays of one origin share.
template <class C>
inline constexpr unsigned kStackEntries = kCommonOrigin<C> ? 4 : 64;
template <class C>
inline constexpr bool kRestarts = kStackEntries<C> < C::kStackDepth;
/// The number of an entry; without restarts, how many are in use.
template <class C>
using StackPointer = uint<hls::index_width(kRestarts<C> ? kStackEntries<C> : C::kStackDepth + 1)>;

/// Bits of the number of an entry in a packet's part of a RAM.
template <class C>
inline constexpr unsigned kStackBits = kRestarts<C> ? C::kLevels - 1 + StackPointer<C>::kWidth
                                                    : hls::index_width(C::kLevels * C::kStackDepth);
/// Whether a packet's stacks lie in one piece of that RAM. Those of two levels do where it takes
/// fewer rows than a piece for each; then they grow towards each other.
template <class C>
inline constexpr bool kOneStackPiece =
    !kTwoLevels<C> || kStackBits<C> < 1 + StackPointer<C>::kWidth;
/// Row of a RAM with one row for every entry of every stack.
template <class C>
using StackRow =
    uint<PacketId<C>::kWidth + (kOneStackPiece<C> ? kStackBits<C> : 1 + StackPointer<C>::kWidth)>;
template <class C>
constexpr StackRow<C> stack_row(LevelField<C> level, PacketId<C> packet, StackPointer<C> entry) {
  if constexpr (kOneStackPiece<C>) {
    const auto from_below = uint<kStackBits<C>>::from(entry.raw());
    return hls::concat(packet, is_top<C>(level) ? ~from_below : from_below);
  } else {
    return hls::concat(level_row<C>(level, packet), entry);
  }
}
template <class C>
inline constexpr unsigned kStackRows = 1u << StackRow<C>::kWidth;

template <class R>
struct Vector {
  R x, y, z;
  HLS_FIELDS(x, y, z)
};

template <class R>
struct Ray {
  Vector<R> origin;
  Vector<R> direction;
  HLS_FIELDS(origin, direction)
};

/// A ray as the traversal has it: what belongs to one axis side by side, since a step needs no
/// more.
template <class R>
struct RayAxis {
  R origin, direction;
  HLS_FIELDS(origin, direction)
};
template <class R>
using RayByAxis = std::array<RayAxis<R>, 3>;
template <class R>
constexpr RayByAxis<R> by_axis(const Ray<R>& ray) {
  return {{{ray.origin.x, ray.direction.x},
           {ray.origin.y, ray.direction.y},
           {ray.origin.z, ray.direction.z}}};
}

/// What a slice has of its ray along an axis: where the origin is common, the direction alone.
template <class C>
using SliceAxis = std::conditional_t<kCommonOrigin<C>, typename C::Real, RayAxis<typename C::Real>>;
template <class C>
using SliceRay = std::array<SliceAxis<C>, 3>;
template <class C>
constexpr SliceRay<C> slice_ray(const Ray<typename C::Real>& ray) {
  if constexpr (kCommonOrigin<C>) {
    return {ray.direction.x, ray.direction.y, ray.direction.z};
  } else {
    return by_axis(ray);
  }
}

/// Whether a slice reads one axis of its ray, whose axes are then written one after the other. A
/// slice's ray follows another after five clocks; after three where reciprocals are made, as rays
/// then wait for their lane (units/lane_spacing.h). Of rays that are transformed alone it may come
/// after two.
template <class C>
inline constexpr bool kReadsAxes = kFast<C> || !kHasSecondary<C>;
/// Row of such an axis, 0 to 2.
template <class C>
using AxisRow = uint<LevelRow<C>::kWidth + 2>;
template <class C>
constexpr AxisRow<C> axis_row(LevelRow<C> ray, uint<2> axis) {
  return hls::concat(axis, ray);
}
template <class C>
inline constexpr unsigned kAxisRows = 3 * kLevelRows<C>;

}  // namespace dynrt
