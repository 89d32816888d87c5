// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// List: an address counter per packet and level (thesis 6.1.2). It reads the entries of a leaf's
// list one by one; after the last one the packet goes back to the traversal: it pops, or where a
// leaf has no node, it goes on to the other child of the node above. Where the start node is a
// list, that of the main object (thesis 4.3.3) or the only one, rays enter the tree over the other
// objects after it.
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
    [[no_unique_address]] hls::OptionalField<kMainFirst<C>, bool> is_start{};
    hls::OptionalField<kMainFirst<C> && kHasSecondary<C>, RayKind> rays{};
    HLS_FIELDS(active, is_start, rays)
  };

  struct Place {
    NodeAddress<C> next;  ///< entry of the list
    [[no_unique_address]] hls::OptionalField<kFast<C>, Leaf> leaf{};
    HLS_FIELDS(next, leaf)
  };

  hls::In<ListJob<C>> job;
  hls::Out<ListRequest<C>> request;
  hls::Out<TraversalEvent<C>> finished;
  hls::RamRead<bool, kLevelRows<C>> last;  ///< whether the entry read last was the list's last
  hls::OptionalPort<kFast<C>, hls::RamRead<AfterLeaf<C>, kLevelRows<C>>> after;
  hls::Ram1R1W<Place, kLevelRows<C>> place;
  hls::OptionalPort<kMainFirst<C>, hls::Config<FrameRegisters<C>>> frame;
  HLS_PORTS(job, request, finished, last, after, frame)

  void step() {
    const ListJob<C> j = job.read();
    const LevelRow<C> row = level_row<C>(j.level, j.packet);
    const Place before = place.read(row);
    const bool at_end = !j.first && last.read(row);
    const NodeAddress<C> address = j.first ? j.address : before.next;
    Leaf here;
    if constexpr (kFast<C>) {
      here = j.first ? Leaf{j.active.get(), j.is_start, j.rays} : before.leaf.get();
    }
    place.write(row, Place{hls::next(address), here});

    if (at_end) {
      TraversalEvent<C> go_on;
      go_on.packet = j.packet;
      go_on.level = j.level;
      bool is_start = false;
      if constexpr (kMainFirst<C>) {
        is_start = here.is_start.get();
        if (is_start) enter_others(here, go_on);
      }
      if constexpr (kFast<C>) {
        if (!is_start) go_on_after(after.read(row), go_on);
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
  /// From the list where rays start: the main object's, or the only leaf of the tree.
  void enter_others(const Leaf& start, TraversalEvent<C>& e) const {
    e.kind = TraversalKind::kEnter;
    e.next = NodeAddress<C>::from(frame.get().others_node.get().raw());
    e.active = start.active;
    e.rays = start.rays.get();
  }
};

}  // namespace dynrt
