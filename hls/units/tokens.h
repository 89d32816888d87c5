// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The tokens that travel between the units of the core, by purpose. C is a configuration
// (hls/configs).
#pragma once

#include <algorithm>
#include <type_traits>

#include "units/packet.h"
#include "units/watertight.h"

namespace dynrt {

// ---- Rays beyond the primary ones (thesis 6.2) ----

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
struct DerivedRay {
  Derivation pass = Derivation::kLight;
  RayIndex ray;
  HLS_FIELDS(pass, ray)
};

/// To the unit that makes such rays: a packet is shaded, or one ray's pass is done.
template <class C>
struct DerivationEvent {
  PacketId<C> packet;
  bool shaded = false;
  RayKind kind = RayKind::kPrimary;  ///< of the shaded rays
  RayMask surfaces;                  ///< of the shaded rays, those that have hit something
  RayMask mirrors;                   ///< of them, those that are reflected
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
  hls::FieldIf<kHasMirrors<C>, uint<8>>
      mirror{};  ///< part of the light that is reflected, in 256ths
  HLS_FIELDS(hit, cosine, t, object, triangle, colour, mirror)
};

// ---- Traversal (thesis 6.1.1) ----

/// The next action of the node fetch unit for a packet.
enum class TraversalKind : unsigned char {
  kEnter,    ///< start at node `next` with the rays `active`
  kDescend,  ///< go on at node `next`
  kPush,     ///< go on at node `next` and remember node `pushed`
  kPop,      ///< go on at the node remembered last
};

/// A repeated job has its number of repetitions, less one, in its lowest field.
using RepeatCount = uint<4>;

/// One of four rays that enter an object.
template <class C>
struct ObjectRay {
  PacketId<C> packet;
  RayIndex ray;
  RayMask active;                      ///< of the packet's rays, those that are traced
  OfInstance<C, NodeAddress<C>> root;  ///< of the object's tree
  hls::FieldIf<kSplitsPackets<C>, bool> distinct_origins{};
  Ray<typename C::Real> in_object;
  HLS_FIELDS(packet, ray, active, root, distinct_origins, in_object)
};

/// A ray whose direction is yet to be inverted, one axis at a time.
template <class C>
struct TracedRay {
  RepeatCount repeat = 2;        ///< axes less one
  OfInstance<C, bool> is_new{};  ///< it enters the top level, not an object
  ObjectRay<C> ray;
  HLS_FIELDS(repeat, is_new, ray)
};

/// The interval of a ray within an object's box, where it may hit something.
template <class C>
struct BoxInterval {
  typename C::Real near, far;
  HLS_FIELDS(near, far)
};

/// The change that a slice makes to a ray's interval [near, far] before the step.
enum class IntervalUpdate : unsigned char {
  kInit,         ///< near = where the ray starts, far = its hit distance so far
  kClipFar,      ///< far = d where both children are entered
  kClipFarPush,  ///< the same, after pushing far
  kClipNear,     ///< near = d where both are entered and the near child is empty
  kPop,          ///< near = far and far = popped where both were entered
};

template <class C>
struct TraversalEvent {
  PacketId<C> packet;
  LevelField<C> level;
  TraversalKind kind = TraversalKind::kPop;
  NodeAddress<C> next;
  RayMask active;          ///< rays that go to `next`
  bool clip_near = false;  ///< kDescend: the near child was empty, so near = d rather than far = d
  NodeAddress<C> pushed;
  RayMask pushed_active;
  RayMask both;                                    ///< rays that enter both children
  RayMask terminated;                              ///< rays found to have ended in this level
  hls::FieldIf<kHasSecondary<C>, RayKind> rays{};  ///< kEnter, level 0: what they are
  hls::FieldIf<kSplitsPackets<C>, bool>
      distinct_origins{};  ///< kEnter: the rays have no common origin
  /// Rays that enter both children in the other order; they are not in `both`.
  hls::FieldIf<kRemembersChild<C>, RayMask> crossing{};
  HLS_FIELDS(packet, level, kind, next, active, clip_near, pushed, pushed_active, both, terminated,
             rays, distinct_origins, crossing)
};

/// Everything about a step but the node itself; travels with the node's address and data.
template <class C>
struct StepContext {
  PacketId<C> packet;
  LevelField<C> level;
  IntervalUpdate update = IntervalUpdate::kInit;
  RayMask both;
  RayMask active;
  StackPointer<C> stack;  ///< the far stack's entry to push to or to pop from
  /// kPop: rays that entered both children in the other order.
  hls::FieldIf<kRemembersChild<C>, RayMask> crossing{};
  HLS_FIELDS(packet, level, update, both, active, stack, crossing)
};

template <class C>
struct Step {
  StepContext<C> context;
  CoreNode<C> node;
  HLS_FIELDS(context, node)
};

/// The signs of a ray's direction along x, y and z.
using DirectionSigns = uint<3>;

/// One ray's traversal decision (thesis 3.1.2).
struct SliceDecision {
  bool left_first = false;
  bool go_left = false;
  bool go_right = false;
  bool terminated = false;  ///< its hit lies before the node's interval
  HLS_FIELDS(left_first, go_left, go_right, terminated)
};

/// A packet's stack is full: its push is dropped (thesis 7).
template <class C>
struct DroppedPush {
  PacketId<C> packet;
  HLS_FIELDS(packet)
};

// ---- List and mailbox (thesis 6.1.2) ----

template <class C>
struct ListJob {
  PacketId<C> packet;
  LevelField<C> level;
  bool first = false;  ///< start at `address`; otherwise go on after the last entry read
  NodeAddress<C> address;
  HLS_FIELDS(packet, level, first, address)
};

template <class C>
struct ListContext {
  PacketId<C> packet;
  LevelField<C> level;
  HLS_FIELDS(packet, level)
};

template <class C>
struct MailboxEntry {
  PacketId<C> packet;
  LevelField<C> level;
  bool clear = false;  ///< new rays: forget the packet's objects and start the traversal
  RayMask active;      ///< of new rays: those that are to be traced
  hls::FieldIf<kHasSecondary<C>, RayKind> kind{};  ///< of new rays
  CoreListEntry<C> entry;
  HLS_FIELDS(packet, level, clear, active, kind, entry)
};

// ---- Transformation (thesis 6.1.3) ----

enum class TransformKind : unsigned char { kCamera, kObject, kTriangle, kDerive };

/// Fields of a transformation in configurations with rays beyond the primary ones or with several
/// primitives.
template <class C>
struct TransformExtras {
  hls::FieldIf<kHasSecondary<C>, DerivedRay> derived{};  ///< of kDerive
  hls::FieldIf<kHasMirrors<C>, bool>
      distinct_origins{};         ///< the packet's rays have no common origin
  PrimitiveField<C> primitive{};  ///< of kTriangle
  HLS_FIELDS(derived, distinct_origins, primitive)
};

template <class C>
struct TransformJob {
  RepeatCount repeat = 3;  ///< columns of the matrix in the memory, less one
  PacketId<C> packet;
  TransformKind kind = TransformKind::kCamera;
  RayMask active;
  MatrixNumber<C> matrix;
  TransformExtras<C> extras{};
  HLS_FIELDS(repeat, packet, kind, active, matrix, extras)
};

/// Job number `index` of a job that is repeated; the last one says so.
template <class Job>
struct Repeated {
  RepeatCount index;
  bool last = false;
  Job job;
  HLS_FIELDS(index, last, job)
};

template <class C>
struct ColumnContext {
  PacketId<C> packet;
  TransformKind kind = TransformKind::kCamera;
  RayMask active;
  uint<2> column;  ///< as it is stored
  TransformExtras<C> extras{};
  hls::FieldIf<kThreeColumns<C>, MatrixNumber<C>> matrix{};  ///< otherwise the address has it
  HLS_FIELDS(packet, kind, active, column, extras, matrix)
};

/// The state of a packet's transformation in progress.
template <class C>
struct JobRecord {
  TransformKind kind = TransformKind::kCamera;
  RayMask active;
  MatrixNumber<C> matrix;
  MatrixExtra<C> extra;
  hls::FieldIf<kHasSecondary<C>, DerivedRay> derived{};
  hls::FieldIf<kHasMirrors<C>, uint<8>> mirror{};  ///< of a triangle
  hls::FieldIf<kSplitsPackets<C>, bool>
      distinct_origins{};  ///< the packet's rays have no common origin
  PrimitiveField<C> primitive{};
  hls::FieldIf<kScalesCosine<C>, typename C::Real> cosine_factor{};
  HLS_FIELDS(kind, active, matrix, extra, derived, mirror, distinct_origins, primitive,
             cosine_factor)
};

template <class C>
struct SendJob {
  /// Vectors less one: 4 of a compressed packet, 7 of another, 1 of one ray, 11 of all corners.
  RepeatCount repeat;
  PacketId<C> packet;
  TransformKind kind = TransformKind::kCamera;
  hls::FieldIf<kHasSecondary<C>, DerivedRay> derived{};
  HLS_FIELDS(repeat, packet, kind, derived)
};

/// A corner of a triangle, or kNoCorner.
using Corner = uint<2>;
inline constexpr unsigned kNoCorner = 3;

/// One vector on its way through the transformation. Compressed packets send the common origin and
/// four directions, others four pairs of origin and direction. To map a triangle's corners a ray's
/// direction is sent once for each (units/watertight.h).
template <class C>
struct PacketVector {
  PacketId<C> packet;
  bool point = false;  ///< a point is translated, a direction is not (thesis 4.4)
  RayIndex ray;        ///< 0 for a common origin
  Vector<typename C::Real> vector;
  hls::FieldIf<kWatertight<C>, Corner> corner = Corner(kNoCorner);
  hls::FieldIf<kWatertight<C>, typename C::Real> cosine{};  ///< with a corner that is mapped
  HLS_FIELDS(packet, point, ray, vector, corner, cosine)
};

// ---- Intersection and hits (thesis 6.1.4, 5.2) ----

template <class C>
struct UnitRay {
  PacketId<C> packet;
  RayIndex ray;
  bool reset = false;  ///< not a test: the ray is new and has no hit yet
  /// The ray in unit space, or the triangle in the ray's.
  std::conditional_t<kWatertight<C>, MappedTriangle<typename C::Real>, Ray<typename C::Real>> unit;
  PrimitiveField<C> primitive{};
  hls::FieldIf<kScalesCosine<C>, typename C::Real> cosine_factor{};
  HLS_FIELDS(packet, ray, reset, unit, primitive, cosine_factor)
};

template <class C>
struct HitCandidate {
  PacketId<C> packet;
  RayIndex ray;
  bool reset = false;
  bool hit = false;
  typename C::Real t, u, v, cosine;
  HLS_FIELDS(packet, ray, reset, hit, t, u, v, cosine)
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

// ---- Ray generation and shading (thesis 6.2) ----

/// A packet's place in the image: the pixel of ray 0; ray r is at (x + (r & 1), y + (r >> 1)).
struct PixelPosition {
  uint<10> x;
  uint<10> y;
  HLS_FIELDS(x, y)
};

template <class C>
struct ShadeJob {
  RepeatCount repeat;  ///< steps less one: 3 to shade four rays, 15 to write their pixels and hits
  PacketId<C> packet;
  hls::FieldIf<kHasSecondary<C>, RayKind> kind{};
  HLS_FIELDS(repeat, packet, kind)
};

// ---- Caches and memory (thesis 7) ----

/// `AddressBits` are those of the core's nodes or columns.
template <class Context, unsigned AddressBits = kAddressBits>
struct CacheRequest {
  Context context;
  uint<AddressBits> address;
  HLS_FIELDS(context, address)
};

/// Data is Line, the bits of a node, a list entry or a matrix column.
template <class Context, class Line, unsigned AddressBits = kAddressBits>
struct CacheReply {
  Context context;
  uint<AddressBits> address;
  Line line;
  HLS_FIELDS(context, address, line)
};

template <class Line, unsigned AddressBits = kAddressBits>
struct CacheRow {
  bool valid = false;
  uint<AddressBits> tag;
  Line line;
  HLS_FIELDS(valid, tag, line)
};

enum class MemoryKind : unsigned char { kNode, kList, kColumn };

/// `key` names the request within its cache: the packet, or packet and column.
template <class C>
struct MemoryRequest {
  MemoryKind kind = MemoryKind::kNode;
  uint<2 + PacketId<C>::kWidth> key;
  uint<std::max(NodeAddress<C>::kWidth, ColumnAddress<C>::kWidth)> address;
  HLS_FIELDS(kind, key, address)
};

/// A line for a cache: the answer to a request, or the order to invalidate a line.
template <class C, class Line, unsigned AddressBits = kAddressBits>
struct CacheLine {
  bool invalidate = false;
  uint<2 + PacketId<C>::kWidth> key;
  uint<AddressBits> address;
  Line line;
  HLS_FIELDS(invalidate, key, address, line)
};
template <class C>
using NodeLine = CacheLine<C, CoreNode<C>, NodeAddress<C>::kWidth>;
template <class C>
using ListLine = CacheLine<C, CoreListEntry<C>, NodeAddress<C>::kWidth>;
template <class C>
using ColumnLine = CacheLine<C, MatrixColumn<typename C::Real>, ColumnAddress<C>::kWidth>;

template <class C>
using NodeRequest = CacheRequest<StepContext<C>, NodeAddress<C>::kWidth>;
template <class C>
using ListRequest = CacheRequest<ListContext<C>, NodeAddress<C>::kWidth>;
template <class C>
using ColumnRequest = CacheRequest<ColumnContext<C>, ColumnAddress<C>::kWidth>;
template <class C>
using ColumnReply =
    CacheReply<ColumnContext<C>, MatrixColumn<typename C::Real>, ColumnAddress<C>::kWidth>;

}  // namespace dynrt

template <>
inline constexpr unsigned hls::enum_width<dynrt::TraversalKind> = 2;
template <>
inline constexpr unsigned hls::enum_width<dynrt::IntervalUpdate> = 3;
template <>
inline constexpr unsigned hls::enum_width<dynrt::RayKind> = 2;
template <>
inline constexpr unsigned hls::enum_width<dynrt::Derivation> = 2;
template <>
inline constexpr unsigned hls::enum_width<dynrt::TransformKind> = 2;
template <>
inline constexpr unsigned hls::enum_width<dynrt::MemoryKind> = 2;
