// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Traversal slice: one ray's half of a traversal step (thesis 6.1.1, figure 3.5 and section 3.1.2).
// It holds the ray's interval [near, far] and far stack for both levels, applies the decision of
// the previous step, and finds the distance d of the node's plane and the children that the ray
// enters. A slice for each ray of a packet works beside the others.
//
// Where a packet's rays start at one point, the plane comes as its distance from there.
//
// Where no triangle may be lost, d counts as a range of numbers that holds the exact distance:
// kWidening steps of the mantissa up and down. The interval is kept as much wider, so that d itself
// is compared with its ends; a child that both ends of d bound is twice as much wider.
#pragma once

#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct TraversalSlice {
  using Real = typename C::Real;
  /// A ray's interval within the node entered last, and the distance of that node's plane.
  struct Interval {
    Real near, far, plane;
    HLS_FIELDS(near, far, plane)
  };
  /// The part that is kept while the near child is traversed.
  struct Pushed {
    Real far;
    hls::OptionalField<kRemembersChild<C>, Real> near;
    HLS_FIELDS(far, near)
  };

  hls::In<Step<C>> step_in;
  hls::Config<RayIndex<C>> lane;  ///< which ray of the packet this slice serves
  hls::Out<SliceDecision> decision;
  /// With its direction's reciprocals, if there are such.
  std::conditional_t<kReadsAxes<C>, hls::RamRead<SliceAxis<C>, kAxisRows<C>>,
                     hls::RamRead<SliceRay<C>, kLevelRows<C>>>
      ray;
  hls::RamRead<Real, (1u << PacketId<C>::kWidth)> hit_distance;
  hls::OptionalPort<kHasMirrors<C>, hls::RamRead<Real, (1u << PacketId<C>::kWidth)>> start_distance;
  hls::OptionalPort<kTestsWorldBox<C>, hls::RamRead<CoarseInterval<C>, (1u << PacketId<C>::kWidth)>>
      box;
  hls::Ram1R1W<Interval, kLevelRows<C>> interval;
  hls::Ram1R1W<Pushed, kStackRows<C>> far_stack;
  HLS_PORTS(step_in, lane, decision, ray, hit_distance, start_distance, box)

  void step() {
    const Step<C> s = step_in.read();
    const StepContext<C>& c = s.context;
    const LevelRow<C> row = level_row<C>(c.level, c.packet);
    const bool both = c.both.bit(static_cast<unsigned>(lane.get().raw()));

    const Interval before = interval.read(row);
    const Real hit = hit_distance.read(c.packet);
    const StackRow<C> entry = stack_row<C>(c.level, c.packet, c.stack);
    const Pushed popped = far_stack.read(entry);
    if (c.update == IntervalUpdate::kClipFarPush) {
      far_stack.write(entry, Pushed{before.far, before.near});
    }

    Real near = before.near;
    Real far = before.far;
    Real end;
    if constexpr (kWidening<C> > 0) end = widened_end(c.update, before);
    if (c.update == IntervalUpdate::kInit) {
      if constexpr (kHasMirrors<C>) {
        near = start_distance.read(c.packet);
      } else {
        near = Real{};
      }
      far = hit;
      if constexpr (kTestsWorldBox<C>) {
        const BoxInterval<C> inside = interval_of<C>(box.read(c.packet));
        if (c.level == Level(1)) {
          near = inside.near;
          far = inside.far;
        }
      }
    } else if (both) {
      switch (c.update) {
        case IntervalUpdate::kClipNear:
          near = kWidening<C> > 0 ? end : before.plane;
          break;
        case IntervalUpdate::kPop:
          near = kWidening<C> > 0 ? end : before.far;
          far = popped.far;
          break;
        default:
          far = kWidening<C> > 0 ? end : before.plane;
          break;
      }
    } else if (kRemembersChild<C> && c.update == IntervalUpdate::kPop && is_crossing(c)) {
      // It enters both children with the whole interval of their parent.
      near = popped.near.get();
      far = popped.far;
    }

    const SliceAxis<C> r = along_axis(s.node.kind, row);
    const Real offset = offset_of(s, r);
    const Real d = distance(offset, direction_of(r), starts_in_plane(s, r));
    const bool left_first = !offset.sign();
    const bool behind = d.sign();
    const bool go_near = behind || !(d < near);
    const bool go_far = !behind && !(far < d);

    SliceDecision out;
    out.left_first = left_first;
    out.go_left = left_first ? go_near : go_far;
    out.go_right = left_first ? go_far : go_near;
    out.terminated = c.update != IntervalUpdate::kInit && hit < near;
    decision.write(out);
    interval.write(row, Interval{near, far, d});
  }

 private:
  /// Where both children are entered: the far end of the near one, or the near end of the far one,
  /// which after a pop is known by the far end that the near one had. One addition for all.
  static Real widened_end(IntervalUpdate update, const Interval& before) {
    constexpr int kWider = 2 * kWidening<C>;
    using Steps = sint<hls::index_width(2 * kWider + 1) + 1>;
    const bool pops = update == IntervalUpdate::kPop;
    const Real end = pops ? before.far : before.plane;
    return end.moved(pops                                  ? Steps(-2 * kWider)
                     : update == IntervalUpdate::kClipNear ? Steps(-kWider)
                                                           : Steps(kWider));
  }
  /// From an origin in the plane no offset but zero is right, and no number is zero.
  static Real distance(Real offset, Real direction, bool in_plane) {
    if (kWidening<C> > 0 && in_plane) return direction.sign() ? -Real{} : Real{};
    return kFast<C> ? offset * direction : offset / direction;
  }
  static Real offset_of(const Step<C>& s, const SliceAxis<C>& r) {
    if constexpr (kCommonOrigin<C>) {
      return s.node.split;
    } else {
      return s.node.split - r.origin;
    }
  }
  static bool starts_in_plane(const Step<C>& s, const SliceAxis<C>& r) {
    if constexpr (kCommonOrigin<C>) {
      return s.in_plane.get();
    } else {
      return s.node.split == r.origin;
    }
  }
  static Real direction_of(const SliceAxis<C>& r) {
    if constexpr (kCommonOrigin<C>) {
      return r;
    } else {
      return r.direction;
    }
  }
  bool is_crossing(const StepContext<C>& c) const {
    return c.crossing.get().bit(static_cast<unsigned>(lane.get().raw()));
  }
  /// The ray along the axis that a node splits.
  SliceAxis<C> along_axis(NodeKind kind, LevelRow<C> row) const {
    const uint<2> axis = kind == NodeKind::kSplitX   ? uint<2>(0)
                         : kind == NodeKind::kSplitY ? uint<2>(1)
                                                     : uint<2>(2);
    if constexpr (kReadsAxes<C>) {
      return ray.read(axis_row<C>(row, axis));
    } else {
      const RayByAxis<Real> r = ray.read(row);
      return {of_split_axis(kind, r[0].origin, r[1].origin, r[2].origin),
              of_split_axis(kind, r[0].direction, r[1].direction, r[2].direction)};
    }
  }
};

}  // namespace dynrt
