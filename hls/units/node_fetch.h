// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Node fetch: the traversal's memory interface (thesis 6.1.1). It holds the node stack of each
// packet and level and turns what was decided about a packet into the next node's address. A full
// stack drops the push and goes on (thesis chapter 7); each drop is a token of `dropped`. A level
// ends when no ray of it is alive or its stack is empty. A stack may keep only its latest entries;
// then a packet comes back to the others from the root (units/restart_trail.h). Where rays meet the
// main object first, a level ends at once that they enter at the null node: there are no others.
//
// Of reflected rays that would traverse two children in different orders (thesis 3.1.3), a
// configuration may split the packet: rays whose directions' signs differ traverse the level one
// group after the other. Or it may remember the child: a crossing ray enters both children with the
// whole interval, in the order of the others, and ends no more in this level, because what it has
// hit in one child may lie behind a hit in the other.
#pragma once

#include "units/memory_tokens.h"
#include "units/shading_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct NodeFetch {
  using Stack = StackPointer<C>;
  /// The state of a packet in one level.
  struct State {
    Stack stack;       ///< entries in use; of a ring, the next one
    RayMask<C> alive;  ///< rays that entered the level and have not ended in it
    hls::OptionalField<kHasSecondary<C>, RayKind> rays{};         ///< level 0: their kind
    hls::OptionalField<kSplitsPackets<C>, RayMask<C>> waiting{};  ///< rays of the groups to come
    hls::OptionalField<kSplitsPackets<C> || kRestarts<C>, NodeAddress<C>>
        root{};  ///< node where they begin
    hls::OptionalField<kRemembersChild<C>, RayMask<C>>
        crossing{};  ///< rays that have crossed others
    [[no_unique_address]] hls::OptionalField<kRestarts<C>, RestartTrail<C>> trail{};
    HLS_FIELDS(stack, alive, rays, waiting, root, crossing, trail)
  };
  struct Entry {
    NodeAddress<C> node;
    RayMask<C> active;
    RayMask<C> both;
    hls::OptionalField<kRemembersChild<C>, RayMask<C>> crossing{};
    HLS_FIELDS(node, active, both, crossing)
  };

  hls::In<TraversalEvent<C>> event;
  hls::Out<NodeRequest<C>> request;
  hls::Out<TraversalEvent<C>> again;  ///< a popped node that no living ray enters: pop once more
  hls::Out<ShadeJob<C>> top_done;
  hls::OptionalPort<kTwoLevels<C>, hls::Out<ListJob<C>>> object_done;
  hls::Out<DroppedPush<C>> dropped;
  hls::OptionalPort<kSplitsPackets<C>, hls::RamRead<DirectionSigns, kLevelRows<C>>> signs[kRays<C>];
  hls::Ram1R1W<State, kLevelRows<C>> states;
  hls::Ram1R1W<Entry, kStackRows<C>> stack;
  HLS_PORTS(event, request, again, top_done, object_done, dropped, signs)

  void step() {
    const TraversalEvent<C> e = event.read();
    const LevelRow<C> row = level_row<C>(e.level, e.packet);
    State state = states.read(row);

    const bool enter = e.kind == TraversalKind::kEnter;
    const RayMask<C> entering = enter ? first_group(e, row) : RayMask<C>{};
    if (enter) {
      state.stack = 0;
      state.alive = entering;
      state.rays = e.rays;
      state.waiting = e.active & ~entering;
      state.root = e.next;
      state.crossing = RayMask<C>{};
      if constexpr (kRestarts<C>) state.trail = RestartTrail<C>{};
    }
    state.alive = state.alive & ~(e.terminated & ~state.crossing.get());

    const Stack below = Stack::from(state.stack.raw() - 1);
    const Entry popped = stack.read(stack_row<C>(e.level, e.packet, below));

    StepContext<C> context;
    context.packet = e.packet;
    context.level = e.level;
    context.both = e.both;
    context.active = e.active;
    context.stack = state.stack;
    context.update = e.kind == TraversalKind::kDescend && e.clip_near ? IntervalUpdate::kClipNear
                                                                      : IntervalUpdate::kClipFar;
    NodeAddress<C> address = e.next;
    if constexpr (kFast<C> && kRemembersChild<C>) {
      // After a leaf whose sibling did not go to the stack.
      if (e.kind == TraversalKind::kDescend) {
        state.crossing = state.crossing.get() | e.crossing.get();
      }
    }

    const bool is_lost = kRestarts<C> && state.trail.get().is_lost();
    bool fetch = true;
    if (kMainFirst<C> && enter && e.next == NodeAddress<C>{}) {
      fetch = false;
      finish(e, state);
    } else if (enter) {
      context.update = IntervalUpdate::kInit;
      context.active = entering;
    } else if (e.kind == TraversalKind::kPush) {
      const bool full = is_full(state);
      if (full) {
        dropped.write(DroppedPush<C>{e.packet});
      } else {
        stack.write(stack_row<C>(e.level, e.packet, state.stack),
                    Entry{e.pushed, e.pushed_active, e.both, e.crossing});
        context.update = IntervalUpdate::kClipFarPush;
        state.stack = hls::next(state.stack);
        state.crossing = state.crossing.get() | e.crossing.get();
      }
    } else if (e.kind == TraversalKind::kPop) {
      const bool finished = is_empty(state) || state.alive == RayMask<C>{};
      const RayMask<C> active = is_lost ? state.alive : popped.active & state.alive;
      fetch = !finished && active != RayMask<C>{};
      if (!finished && !is_lost) {
        state.stack = below;
      }
      if (!fetch) leave(e, state, finished);
      context.update = is_lost ? IntervalUpdate::kInit : IntervalUpdate::kPop;
      context.both = popped.both;
      context.crossing = popped.crossing;
      context.active = active;
      context.stack = below;
      address = is_lost ? state.root.get() : popped.node;
    }
    if constexpr (kRestarts<C>) {
      state.trail = followed(e, state.trail.get());
      context.way_back = state.trail.get().way_back();
    }
    states.write(row, state);
    if (fetch) request.write(NodeRequest<C>{context, address});
  }

 private:
  /// No ray goes on at the node that was popped: the level is done, or the next one is popped.
  void leave(const TraversalEvent<C>& e, const State& state, bool finished) {
    if (finished && state.waiting.get() != RayMask<C>{}) {
      again.write(next_group(e, state));
    } else if (finished) {
      finish(e, state);
    } else {
      TraversalEvent<C> once_more;
      once_more.packet = e.packet;
      once_more.level = e.level;
      again.write(once_more);
    }
  }
  static bool is_full(const State& state) {
    if constexpr (kRestarts<C>) {
      return state.trail.get().is_too_deep();
    } else {
      return state.stack == Stack::from(C::kStackDepth);
    }
  }
  static bool is_empty(const State& state) {
    if constexpr (kRestarts<C>) {
      return state.trail.get().is_done();
    } else {
      return state.stack == Stack{};
    }
  }
  /// The trail, once the event has happened.
  static RestartTrail<C> followed(const TraversalEvent<C>& e, RestartTrail<C> trail) {
    switch (e.kind) {
      case TraversalKind::kPush:
        if (!trail.is_too_deep()) trail.push();
        break;
      case TraversalKind::kDescend:
        trail.descend(e.is_fork.get(), e.clip_near);
        break;
      case TraversalKind::kPop:
        trail.pop();
        break;
      case TraversalKind::kEnter:
        break;
    }
    return trail;
  }
  /// The packet enters its level once more, with the rays that waited.
  static TraversalEvent<C> next_group(const TraversalEvent<C>& e, const State& state) {
    TraversalEvent<C> enter;
    enter.packet = e.packet;
    enter.level = e.level;
    enter.kind = TraversalKind::kEnter;
    enter.next = state.root.get();
    enter.active = state.waiting.get();
    enter.rays = state.rays;
    enter.distinct_origins = true;
    return enter;
  }
  /// The rays that enter a level first: all, or where the packet is split, the lowest and those
  /// whose directions have its signs.
  RayMask<C> first_group(const TraversalEvent<C>& e, LevelRow<C> row) {
    RayMask<C> group = e.active;
    if constexpr (kSplitsPackets<C>) {
      DirectionSigns of[kRays<C>];
      for (unsigned i = 0; i < kRays<C>; ++i) of[i] = signs[i].read(row);
      DirectionSigns lowest = of[kRays<C> - 1];
      for (unsigned i = kRays<C> - 1; i-- > 0;) {
        if (e.active.bit(i)) lowest = of[i];
      }
      for (unsigned i = 0; i < kRays<C>; ++i) {
        if (e.distinct_origins.get() && of[i] != lowest) group = group & ~RayMask<C>::from(1u << i);
      }
    }
    return group;
  }
  void finish(const TraversalEvent<C>& e, const State& state) {
    if (!kTwoLevels<C> || is_top<C>(e.level)) {
      ShadeJob<C> shade;
      shade.repeat = kHasSecondary<C> ? RepeatCount<C>(kRays<C> - 1) : kLastWrite<C>;
      shade.packet = e.packet;
      shade.kind = state.rays;
      top_done.write(shade);
    } else if constexpr (kTwoLevels<C>) {
      ListJob<C> go_on;
      go_on.packet = e.packet;
      object_done.write(go_on);
    }
  }
};

}  // namespace dynrt
