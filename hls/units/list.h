// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// List: an address counter per packet and level (thesis 6.1.2). It reads the entries of a leaf's
// list one by one; after the last one the packet goes back to the traversal.
#pragma once

#include "units/tokens.h"

namespace dynrt {

template <class C>
struct List {
  struct State {
    Address next;
    RayMask active;
    HLS_FIELDS(next, active)
  };

  hls::In<ListJob<C>> job;
  hls::Out<CacheRequest<ListContext<C>>> request;
  hls::Out<TraversalEvent<C>> finished;
  hls::RamRead<bool, kLevelRows<C>> last;  ///< whether the entry read last was the list's last
  hls::Ram1R1W<State, kLevelRows<C>> states;
  HLS_PORTS(job, request, finished, last)

  void step() {
    const ListJob<C> j = job.read();
    const LevelRow<C> row = level_row<C>(j.level, j.packet);
    State state = states.read(row);
    const bool at_end = !j.first && last.read(row);

    const Address address = j.first ? j.address : state.next;
    const RayMask active = j.first ? j.active : state.active;
    state.next = hls::next(address);
    state.active = active;
    states.write(row, state);

    if (at_end) {
      TraversalEvent<C> pop;
      pop.packet = j.packet;
      pop.level = j.level;
      finished.write(pop);
    } else {
      request.write(
          CacheRequest<ListContext<C>>{ListContext<C>{j.packet, j.level, active}, address});
    }
  }
};

}  // namespace dynrt
