// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// List: an address counter per packet and level (thesis 6.1.2). It reads the entries of a leaf's
// list one by one; after the last one the packet goes back to the traversal: it pops, or where a
// leaf has no node, it goes on to the other child of the node above.
#pragma once

#include "units/memory_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct List {
  hls::In<ListJob<C>> job;
  hls::Out<ListRequest<C>> request;
  hls::Out<TraversalEvent<C>> finished;
  hls::RamRead<bool, kLevelRows<C>> last;  ///< whether the entry read last was the list's last
  hls::OptionalPort<kPointsToLists<C>, hls::RamRead<AfterLeaf<C>, kLevelRows<C>>> after;
  hls::Ram1R1W<NodeAddress<C>, kLevelRows<C>> next;
  hls::OptionalPort<kSendsActive<C>, hls::Ram1R1W<RayMask<C>, kLevelRows<C>>> leaf_rays;
  HLS_PORTS(job, request, finished, last, after)

  void step() {
    const ListJob<C> j = job.read();
    const LevelRow<C> row = level_row<C>(j.level, j.packet);
    const NodeAddress<C> following = next.read(row);
    const bool at_end = !j.first && last.read(row);
    const NodeAddress<C> address = j.first ? j.address : following;
    next.write(row, hls::next(address));

    if (at_end) {
      TraversalEvent<C> go_on;
      go_on.packet = j.packet;
      go_on.level = j.level;
      if constexpr (kPointsToLists<C>) go_on_after(after.read(row), go_on);
      finished.write(go_on);
    } else {
      ListContext<C> context{j.packet, j.level};
      if constexpr (kSendsActive<C>) {
        context.active = j.first ? j.active.get() : leaf_rays.read(row);
        if (j.first) leaf_rays.write(row, j.active.get());
      }
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
};

}  // namespace dynrt
