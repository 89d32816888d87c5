// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// List: an address counter per packet and level (thesis 6.1.2). It reads the entries of a leaf's
// list one by one; after the last one the packet goes back to the traversal: it pops, or where a
// leaf has no node, it goes on to the other child of the node above. Where rays meet the main
// object first, its list is no part of a tree (thesis 4.3.3): they enter the tree over the others
// then.
#pragma once

#include "units/frame.h"
#include "units/memory_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct List {
  /// The rays that are in a leaf, and what its list is.
  struct Leaf {
    RayMask<C> active;
    [[no_unique_address]] hls::OptionalField<kMainFirst<C>, bool> main{};
    hls::OptionalField<kMainFirst<C> && kHasSecondary<C>, RayKind> rays{};
    HLS_FIELDS(active, main, rays)
  };

  hls::In<ListJob<C>> job;
  hls::Out<ListRequest<C>> request;
  hls::Out<TraversalEvent<C>> finished;
  hls::RamRead<bool, kLevelRows<C>> last;  ///< whether the entry read last was the list's last
  hls::OptionalPort<kPointsToLists<C>, hls::RamRead<AfterLeaf<C>, kLevelRows<C>>> after;
  hls::Ram1R1W<NodeAddress<C>, kLevelRows<C>> next;
  hls::OptionalPort<kMainFirst<C>, hls::Config<FrameRegisters<C>>> frame;
  hls::OptionalPort<kSendsActive<C>, hls::Ram1R1W<Leaf, kLevelRows<C>>> leaf;
  HLS_PORTS(job, request, finished, last, after, frame)

  void step() {
    const ListJob<C> j = job.read();
    const LevelRow<C> row = level_row<C>(j.level, j.packet);
    const NodeAddress<C> following = next.read(row);
    const bool at_end = !j.first && last.read(row);
    const NodeAddress<C> address = j.first ? j.address : following;
    next.write(row, hls::next(address));
    Leaf here;
    if constexpr (kSendsActive<C>) {
      const Leaf begins{j.active.get(), j.main, j.rays};
      here = j.first ? begins : leaf.read(row);
      if (j.first) leaf.write(row, begins);
    }

    if (at_end) {
      TraversalEvent<C> go_on;
      go_on.packet = j.packet;
      go_on.level = j.level;
      bool main = false;
      if constexpr (kMainFirst<C>) {
        main = here.main.get();
        if (main) enter_others(here, go_on);
      }
      if constexpr (kPointsToLists<C>) {
        if (!main) go_on_after(after.read(row), go_on);
      }
      finished.write(go_on);
    } else {
      ListContext<C> context{j.packet, j.level};
      context.active = here.active;
      request.write(ListRequest<C>{context, address});
    }
  }

 private:
  /// The near child was the leaf, so the other child is entered as if it had been empty.
  static void go_on_after(const AfterLeaf<C>& leaf, TraversalEvent<C>& e) {
    e.kind = leaf.other_child ? TraversalKind::kDescend : TraversalKind::kPop;
    e.clip_near = true;
    e.is_fork = leaf.other_child;
    e.next = leaf.next;
    e.active = leaf.active;
    e.both = leaf.both;
    e.crossing = leaf.crossing;
  }
  void enter_others(const Leaf& main, TraversalEvent<C>& e) const {
    e.kind = TraversalKind::kEnter;
    e.next = NodeAddress<C>::from(frame.get().others_node.get().raw());
    e.active = main.active;
    e.rays = main.rays.get();
  }
};

}  // namespace dynrt
