// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tokens of the traversal (thesis 6.1.1), and of the list and the mailbox that it leads to (6.1.2).
// C is a configuration (hls/configs).
#pragma once

#include <algorithm>
#include <type_traits>

#include "units/packet.h"
#include "units/repeated.h"
#include "units/restart_trail.h"
#include "units/shading_tokens.h"

namespace dynrt {

/// The next action of the node fetch unit for a packet.
enum class TraversalKind : unsigned char {
  kEnter,    ///< start at node `next` with the rays `active`
  kDescend,  ///< go on at node `next`
  kPush,     ///< go on at node `next` and remember node `pushed`
  kPop,      ///< go on at the node remembered last
};

/// One of the rays that enter an object.
template <class C>
struct ObjectRay {
  PacketId<C> packet;
  RayIndex<C> ray;
  RayMask<C> active;                   ///< of the packet's rays, those that are traced
  OfInstance<C, NodeAddress<C>> root;  ///< of the object's tree
  [[no_unique_address]] LastRay<C> last{};
  hls::OptionalField<kSplitsPackets<C>, bool> distinct_origins{};
  Ray<typename C::Real> in_object;
  HLS_FIELDS(packet, ray, active, root, last, distinct_origins, in_object)
};

/// A ray whose direction is yet to be inverted.
template <class C>
struct TracedRay {
  RepeatCount<C> repeat = 2;     ///< clocks that the ray waits for its lane
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

/// Distances along a ray in a core that tests boxes in the world: truncated numbers of so many bits
/// that the magnitudes of two fill a row of block RAM, 36, if the bounds of boxes have no more.
template <class R>
inline constexpr unsigned kDistanceMantissaBits =
    std::min(R::kMantissaBits, std::max(18u - R::kExponentBits, kBoundMantissaBits<R>));
template <class R>
using BoxDistance =
    hls::Float<R::kExponentBits, kDistanceMantissaBits<R>, hls::Rounding::kTruncate>;
/// Such an interval, by its ends' magnitudes. It is not negative.
template <class C>
struct CoarseInterval {
  using Distance = BoxDistance<typename C::Real>;
  using Magnitude = uint<Distance::kLeafWidth - 1>;
  Magnitude near, far;
  HLS_FIELDS(near, far)
};
template <class C>
constexpr BoxInterval<C> interval_of(const CoarseInterval<C>& coarse) {
  using Distance = BoxDistance<typename C::Real>;
  const auto end = [](auto magnitude) {
    return longer<typename C::Real>(Distance::from_bits(hls::concat(uint<1>(0), magnitude)));
  };
  return {end(coarse.near), end(coarse.far)};
}

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
  RayMask<C> active;       ///< rays that go to `next`
  bool clip_near = false;  ///< kDescend: the near child was empty, so near = d rather than far = d
  NodeAddress<C> pushed;
  RayMask<C> pushed_active;
  RayMask<C> both;                                       ///< rays that enter both children
  RayMask<C> terminated;                                 ///< rays found to have ended in this level
  hls::OptionalField<kHasSecondary<C>, RayKind> rays{};  ///< kEnter, level 0: what they are
  hls::OptionalField<kSplitsPackets<C>, bool>
      distinct_origins{};  ///< kEnter: the rays have no common origin
  /// Rays that enter both children in the other order; they are not in `both`.
  hls::OptionalField<kRemembersChild<C>, RayMask<C>> crossing{};
  [[no_unique_address]] hls::OptionalField<kRestarts<C>, bool>
      is_fork{};  ///< kDescend: out of a node with two children
  HLS_FIELDS(packet, level, kind, next, active, clip_near, pushed, pushed_active, both, terminated,
             rays, distinct_origins, crossing, is_fork)
};

/// Everything about a step but the node itself; travels with the node's address and data.
template <class C>
struct StepContext {
  PacketId<C> packet;
  LevelField<C> level;
  IntervalUpdate update = IntervalUpdate::kInit;
  RayMask<C> both;
  RayMask<C> active;
  StackPointer<C> stack;  ///< the far stack's entry to push to or to pop from
  /// kPop: rays that entered both children in the other order.
  hls::OptionalField<kRemembersChild<C>, RayMask<C>> crossing{};
  [[no_unique_address]] hls::OptionalField<kRestarts<C>, WayBack> way_back{};
  HLS_FIELDS(packet, level, update, both, active, stack, crossing, way_back)
};

/// Where a packet's rays start at one point, the node's plane is given to the slices as its
/// distance from there (units/plane_offset.h).
template <class C>
struct Step {
  StepContext<C> context;
  CoreNode<C> node;
  [[no_unique_address]] hls::OptionalField<kCommonOrigin<C> && kWatertight<C>, bool>
      in_plane{};  ///< the rays start in it
  HLS_FIELDS(context, node, in_plane)
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

/// What follows a leaf: where the nodes above know it, the other child need not go to the stack.
template <class C>
struct AfterLeaf {
  bool other_child = false;  ///< go on there; otherwise pop
  NodeAddress<C> next;
  RayMask<C> active;
  RayMask<C> both;
  hls::OptionalField<kRemembersChild<C>, RayMask<C>> crossing{};
  HLS_FIELDS(other_child, next, active, both, crossing)
};

// ---- List and mailbox (thesis 6.1.2) ----

template <class C>
struct ListJob {
  PacketId<C> packet;
  LevelField<C> level;
  bool first = false;  ///< start at `address`; otherwise go on after the last entry read
  NodeAddress<C> address;
  [[no_unique_address]] LeafRays<C> active{};  ///< of the first
  /// Of the first: whether the start node points to the list, and what its rays are.
  [[no_unique_address]] hls::OptionalField<kMainFirst<C>, bool> is_start{};
  [[no_unique_address]] hls::OptionalField<kMainFirst<C> && kHasSecondary<C>, RayKind> rays{};
  HLS_FIELDS(packet, level, first, address, active, is_start, rays)
};

template <class C>
struct ListContext {
  PacketId<C> packet;
  LevelField<C> level;
  [[no_unique_address]] LeafRays<C> active{};
  HLS_FIELDS(packet, level, active)
};

template <class C>
struct MailboxEntry {
  PacketId<C> packet;
  LevelField<C> level;
  bool clear = false;  ///< new rays: forget the packet's objects and start the traversal
  RayMask<C> active;   ///< of new rays: those that are to be traced; else those in the leaf
  hls::OptionalField<kHasSecondary<C>, RayKind> kind{};  ///< of new rays
  CoreListEntry<C> entry;
  [[no_unique_address]] hls::OptionalField<kTestsBoxOfLight<C>, Viewpoint<C>>
      viewpoint{};  ///< of new rays
  HLS_FIELDS(packet, level, clear, active, kind, entry, viewpoint)
};

}  // namespace dynrt

template <>
inline constexpr unsigned hls::enum_width<dynrt::TraversalKind> = 2;
template <>
inline constexpr unsigned hls::enum_width<dynrt::IntervalUpdate> = 3;
