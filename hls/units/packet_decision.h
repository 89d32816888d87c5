// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Packet decision: joins the rays' decisions into the packet's (thesis 3.1.3). A child is
// entered if one active ray enters it and it is not empty; the order is that of the first ray that
// enters both children, or of the first active one. Rays with a common origin never disagree; of
// reflected rays some may, and these cross the others (thesis 3.1.3). A leaf that its parent knows
// costs no step: the packet goes from the step of the parent to the list.
#pragma once

#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct PacketDecision {
  static constexpr unsigned kRoom = kRoomForBursts<C>;

  hls::In<Step<C>> step_in;
  hls::In<SliceDecision> slice[kRays<C>];
  hls::Out<TraversalEvent<C>> event;
  hls::Out<ListJob<C>> leaf;
  hls::OptionalPort<kFast<C>, hls::RamWrite<AfterLeaf<C>, kLevelRows<C>>> after;
  HLS_PORTS(step_in, slice, event, leaf, after)

  void step() {
    const Step<C> s = step_in.read();
    RayMask<C> terminated, go_left, go_right, left_first;
    for (unsigned i = 0; i < kRays<C>; ++i) {
      const SliceDecision d = slice[i].read();
      set(terminated, i, d.terminated);
      set(go_left, i, d.go_left);
      set(go_right, i, d.go_right);
      set(left_first, i, d.left_first);
    }
    const RayMask<C> active = s.context.active & ~terminated;
    const RayMask<C> left = active & go_left;
    const RayMask<C> right = active & go_right;
    const RayMask<C> both = left & right;

    // Which child is near is known late: what does not need it is computed for left and right.
    const bool enter_left = left != RayMask<C>{} && s.node.left != NodeAddress<C>{};
    const bool enter_right = right != RayMask<C>{} && s.node.right != NodeAddress<C>{};
    const bool left_is_near =
        both == RayMask<C>{} ? first(active, left_first) : first(both, left_first);
    // A near child may have been traversed before the packet came back.
    const bool enter_left_near = enter_left && !is_done(s, enter_right);
    const bool enter_right_near = enter_right && !is_done(s, enter_left);
    const bool enter_near = left_is_near ? enter_left_near : enter_right_near;
    const bool next_is_left = left_is_near ? enter_left_near : !enter_right_near;

    const bool is_leaf = s.node.kind == NodeKind::kLeaf;
    if (is_leaf && active != RayMask<C>{}) {
      read_list(s, active);
    } else {
      TraversalEvent<C> e;
      e.packet = s.context.packet;
      e.level = s.context.level;
      const bool left_now = left_is_near ? enter_left_near : enter_left;
      const bool right_now = left_is_near ? enter_right : enter_right_near;
      e.kind = is_leaf || !(left_now || right_now) ? TraversalKind::kPop
               : left_now && right_now             ? TraversalKind::kPush
                                                   : TraversalKind::kDescend;
      e.is_fork = is_fork(s);
      e.next = next_is_left ? s.node.left : s.node.right;
      e.active = next_is_left ? left : right;
      e.clip_near = !enter_near;
      e.pushed = left_is_near ? s.node.right : s.node.left;
      e.pushed_active = left_is_near ? right : left;
      if constexpr (kRemembersChild<C>) {
        const RayMask<C> order = left_is_near ? left_first : ~left_first;
        e.both = both & order;
        e.crossing = both & ~order;
      } else {
        e.both = both;
      }
      e.terminated = s.context.active & terminated;
      if constexpr (kFast<C>) {
        const bool left_is_leaf = enter_left && is_list<C>(s.node.left);
        const bool right_is_leaf = enter_right && is_list<C>(s.node.right);
        go_on(e, !is_leaf && (next_is_left ? left_is_leaf : right_is_leaf));
      } else {
        event.write(e);
      }
    }
  }

 private:
  /// The node is a leaf: its list is read.
  void read_list(const Step<C>& s, RayMask<C> active) {
    ListJob<C> job;
    job.packet = s.context.packet;
    job.level = s.context.level;
    job.first = true;
    job.address = s.node.left;
    job.active = active;
    leaf.write(job);
    if constexpr (kFast<C>) {
      after.write(level_row<C>(job.level, job.packet), AfterLeaf<C>{});
    }
  }
  static bool is_fork(const Step<C>& s) {
    return s.node.left != NodeAddress<C>{} && s.node.right != NodeAddress<C>{};
  }
  /// Whether a child that is the near one has been traversed before the packet came back.
  static bool is_done(const Step<C>& s, bool enter_other) {
    const WayBack way = s.context.way_back.get();
    return kRestarts<C> && is_fork(s) && (way.near_done || (way.in_far && enter_other));
  }
  /// Where the nodes above know the leaves: a leaf's list is read at once, and the other child
  /// waits beside the stack.
  void go_on(TraversalEvent<C> e, bool next_is_leaf) {
    const bool push = e.kind == TraversalKind::kPush;
    if (!push) e.crossing = hls::OptionalField<kRemembersChild<C>, RayMask<C>>{};
    if (next_is_leaf) {
      ListJob<C> job;
      job.packet = e.packet;
      job.level = e.level;
      job.first = true;
      job.address = list_address<C>(e.next);
      job.active = e.active;
      leaf.write(job);
      after.write(level_row<C>(e.level, e.packet),
                  AfterLeaf<C>{push, e.pushed, e.pushed_active, e.both, e.crossing});
    } else {
      event.write(e);
    }
  }
  static void set(RayMask<C>& mask, unsigned i, bool value) {
    if (value) mask = mask | RayMask<C>::from(1u << i);
  }
  /// The bit of `values` at the lowest set bit of `mask`, from bit I on.
  template <unsigned I = 0>
  static bool first(RayMask<C> mask, RayMask<C> values) {
    if constexpr (I == kRays<C> - 1) {
      return values.template bit<I>();
    } else {
      return mask.template bit<I>() ? values.template bit<I>() : first<I + 1>(mask, values);
    }
  }
};

}  // namespace dynrt
