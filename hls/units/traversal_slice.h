// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Traversal slice: one ray's half of a traversal step (thesis 6.1.1, figure 3.5 and section 3.1.2).
// It holds the ray's interval [near, far] and far stack for both levels, applies what was decided
// in the step before, and finds the distance d of the node's plane and which children the ray
// enters. Four slices work side by side on the four rays of a packet.
#pragma once

#include "units/tokens.h"

namespace dynrt {

template <class C>
struct TraversalSlice {
  using Real = typename C::Real;
  /// A ray's interval within the node entered last, and the distance of that node's plane.
  struct Interval {
    Real near, far, plane;
    HLS_FIELDS(near, far, plane)
  };
  /// What is kept of it while the near child is traversed.
  struct Pushed {
    Real far;
    hls::FieldIf<kRemembersChild<C>, Real> near;
    HLS_FIELDS(far, near)
  };
  static constexpr unsigned kStackRows = kLevelRows<C> * (1u << StackPointer<C>::kWidth);

  hls::In<Step<C>> step_in;
  hls::Config<RayIndex> lane;  ///< which ray of the packet this slice serves
  hls::Out<SliceDecision> decision;
  hls::RamRead<Ray<Real>, kLevelRows<C>> ray;  ///< its direction's reciprocals, if there are such
  hls::RamRead<Real, (1u << PacketId<C>::kWidth)> hit_distance;
  hls::PortIf<kHasMirrors<C>, hls::RamRead<Real, (1u << PacketId<C>::kWidth)>> start_distance;
  hls::PortIf<kClipsToBox<C>, hls::RamRead<BoxInterval<C>, (1u << PacketId<C>::kWidth)>> box;
  hls::Ram1R1W<Interval, kLevelRows<C>> interval;
  hls::Ram1R1W<Pushed, kStackRows> far_stack;
  HLS_PORTS(step_in, lane, decision, ray, hit_distance, start_distance, box)

  void step() {
    const Step<C> s = step_in.read();
    const StepContext<C>& c = s.context;
    const LevelRow<C> row = level_row<C>(c.level, c.packet);
    const bool both = c.both.bit(static_cast<unsigned>(lane.get().raw()));

    const Interval before = interval.read(row);
    const Real hit = hit_distance.read(c.packet);
    const auto stack_row = hls::concat(row, c.stack);
    const Pushed popped = far_stack.read(stack_row);
    if (c.update == IntervalUpdate::kClipFarPush) {
      far_stack.write(stack_row, Pushed{before.far, before.near});
    }

    Real near = before.near;
    Real far = before.far;
    if (c.update == IntervalUpdate::kInit) {
      if constexpr (kHasMirrors<C>) {
        near = start_distance.read(c.packet);
      } else {
        near = Real{};
      }
      far = hit;
      if constexpr (kClipsToBox<C>) {
        const BoxInterval<C> inside = box.read(c.packet);
        if (c.level == Level(1)) {
          near = inside.near;
          far = inside.far;
        }
      }
    } else if (both) {
      switch (c.update) {
        case IntervalUpdate::kClipNear:
          near = before.plane;
          break;
        case IntervalUpdate::kPop:
          near = before.far;
          far = popped.far;
          break;
        default:
          far = before.plane;
          break;
      }
    } else if (kRemembersChild<C> && c.update == IntervalUpdate::kPop && is_crossing(c)) {
      // It enters both children with the whole interval of their parent.
      near = popped.near.get();
      far = popped.far;
    }

    const Ray<Real> r = ray.read(row);
    const Real origin = select_axis(s.node.kind, r.origin);
    const Real direction = select_axis(s.node.kind, r.direction);
    const Real offset = s.node.split - origin;
    const Real d = kHasReciprocals<C> ? offset * direction : offset / direction;

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
  bool is_crossing(const StepContext<C>& c) const {
    return c.crossing.get().bit(static_cast<unsigned>(lane.get().raw()));
  }
  static Real select_axis(NodeKind kind, const Vector<Real>& v) {
    return kind == NodeKind::kSplitX ? v.x : kind == NodeKind::kSplitY ? v.y : v.z;
  }
};

}  // namespace dynrt
