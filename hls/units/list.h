// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// List: an address counter per packet and level (thesis 6.1.2). It reads the entries of a leaf's
// list one by one; after the last one the packet goes back to the traversal.
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
  hls::Ram1R1W<NodeAddress<C>, kLevelRows<C>> next;
  hls::OptionalPort<kSendsActive<C>, hls::Ram1R1W<RayMask<C>, kLevelRows<C>>> leaf_rays;
  HLS_PORTS(job, request, finished, last)

  void step() {
    const ListJob<C> j = job.read();
    const LevelRow<C> row = level_row<C>(j.level, j.packet);
    const NodeAddress<C> following = next.read(row);
    const bool at_end = !j.first && last.read(row);
    const NodeAddress<C> address = j.first ? j.address : following;
    next.write(row, hls::next(address));

    if (at_end) {
      TraversalEvent<C> pop;
      pop.packet = j.packet;
      pop.level = j.level;
      finished.write(pop);
    } else {
      ListContext<C> context{j.packet, j.level};
      if constexpr (kSendsActive<C>) {
        context.active = j.first ? j.active.get() : leaf_rays.read(row);
        if (j.first) leaf_rays.write(row, j.active.get());
      }
      request.write(ListRequest<C>{context, address});
    }
  }
};

}  // namespace dynrt
