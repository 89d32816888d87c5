// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Node fetch: the traversal's memory interface (thesis 6.1.1). It holds the node stack of each
// packet and level and turns what was decided about a packet into the next node's address. A full
// stack drops the push and goes on (thesis chapter 7); each drop is a token of `dropped`. A level
// ends when no ray of it is alive or its stack is empty.
#pragma once

#include "units/tokens.h"

namespace dynrt {

template <class C>
struct NodeFetch {
  using Stack = StackPointer<C>;
  /// What is known of a packet in one level.
  struct State {
    Stack stack;    ///< entries in use
    RayMask alive;  ///< rays that entered the level and have not ended in it
    hls::FieldIf<kHasSecondary<C>, RayKind> rays{};  ///< level 0: what they are
    HLS_FIELDS(stack, alive, rays)
  };
  struct Entry {
    Address node;
    RayMask active;
    RayMask both;
    HLS_FIELDS(node, active, both)
  };
  static constexpr unsigned kStackRows = kLevelRows<C> * (1u << Stack::kWidth);

  hls::In<TraversalEvent<C>> event;
  hls::Out<CacheRequest<StepContext<C>>> request;
  hls::Out<TraversalEvent<C>> again;  ///< a popped node that no living ray enters: pop once more
  hls::Out<ShadeJob<C>> top_done;
  hls::Out<ListJob<C>> object_done;
  hls::Out<LevelDone<C>> dropped;
  hls::Ram1R1W<State, kLevelRows<C>> states;
  hls::Ram1R1W<Entry, kStackRows> stack;
  HLS_PORTS(event, request, again, top_done, object_done, dropped)

  void step() {
    const TraversalEvent<C> e = event.read();
    const LevelRow<C> row = level_row<C>(e.level, e.packet);
    State state = states.read(row);

    const bool enter = e.kind == TraversalKind::kEnter;
    if (enter) {
      state.stack = 0;
      state.alive = e.active;
      state.rays = e.rays;
    }
    state.alive = state.alive & ~e.terminated;

    const Stack below = Stack::from(state.stack.raw() - 1);
    const Entry popped = stack.read(hls::concat(row, below));

    StepContext<C> context;
    context.packet = e.packet;
    context.level = e.level;
    context.both = e.both;
    context.active = e.active;
    context.stack = state.stack;
    context.update = e.kind == TraversalKind::kGo && e.clip_near ? IntervalUpdate::kClipNear
                                                                 : IntervalUpdate::kClipFar;
    Address address = e.next;

    bool fetch = true;
    if (enter) {
      context.update = IntervalUpdate::kInit;
    } else if (e.kind == TraversalKind::kPush) {
      const bool full = state.stack == Stack::from(C::kStackDepth);
      if (full) {
        dropped.write(LevelDone<C>{e.packet});
      } else {
        stack.write(hls::concat(row, state.stack), Entry{e.pushed, e.pushed_active, e.both});
        context.update = IntervalUpdate::kClipFarPush;
        state.stack = hls::next(state.stack);
      }
    } else if (e.kind == TraversalKind::kPop) {
      const bool finished = state.stack == Stack{} || state.alive == RayMask{};
      const RayMask active = popped.active & state.alive;
      fetch = !finished && active != RayMask{};
      if (finished) {
        if (e.level == Level{}) {
          ShadeJob<C> shade;
          shade.repeat = kHasSecondary<C> ? RepeatCount(3) : RepeatCount(15);
          shade.packet = e.packet;
          shade.kind = state.rays;
          top_done.write(shade);
        } else {
          ListJob<C> go_on;
          go_on.packet = e.packet;
          object_done.write(go_on);
        }
      } else {
        state.stack = below;
        if (!fetch) {
          TraversalEvent<C> once_more;
          once_more.packet = e.packet;
          once_more.level = e.level;
          again.write(once_more);
        }
      }
      context.update = IntervalUpdate::kPop;
      context.both = popped.both;
      context.active = active;
      context.stack = below;
      address = popped.node;
    }
    states.write(row, state);
    if (fetch) request.write(CacheRequest<StepContext<C>>{context, address});
  }
};

}  // namespace dynrt
