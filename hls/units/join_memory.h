// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joins of memory interface and memory banks.
#pragma once

#include "units/core.h"

namespace dynrt {

template <class C>
void Core<C>::join_memory(hls::Join& join, const Banks<C>& banks) {
  hls::Writers<MemoryRequest<C>> misses = {};
  for (Pipeline<C>& p : pipeline) {
    misses.push_back(&p.node_lookup.miss);
    misses.push_back(&p.list_lookup.miss);
    misses.push_back(&p.matrix_lookup.miss);
  }
  if constexpr (kSlowMemory<C>) {
    join.repeat("memory_request", misses, memory_interface.request);
  } else {
    join.channel<MemoryRequest<C>>("memory_request", misses, {&memory_interface.request});
  }
  for_each_pipeline(join, [&](Pipeline<C>& p, unsigned i) {
    join.channel<NodeLine<C>>("node_line",
                              {&port_of<kPipelines<C>>(memory_interface.node, i),
                               &port_of<kPipelines<C>>(startup.node, i)},
                              {&p.node_fill.fill});
    join.channel<ListLine<C>>("list_line",
                              {&port_of<kPipelines<C>>(memory_interface.list, i),
                               &port_of<kPipelines<C>>(startup.list, i)},
                              {&p.list_fill.fill});
    join.channel<ColumnLine<C>>("column_line",
                                {&port_of<kPipelines<C>>(memory_interface.column, i),
                                 &port_of<kPipelines<C>>(startup.column, i)},
                                {&p.matrix_fill.fill});
    p.join_caches(join);
  });
  for (unsigned i = 0; i < kSceneBanks; ++i) {
    join.bank("bank" + std::to_string(i), memory_interface.bank[i], banks.scene[i]);
  }
  for (unsigned i = 0; i < banks.out.size(); ++i) {
    join.bank("bank" + std::to_string(kFrameBank + i), bank_writer().bank[i], banks.out[i]);
  }
  // The misses of a cache depend on the order of the packets, and so do the fetches that follow. Of
  // what does not, each pipeline counts its share, which depends on the order; the sum does not.
  join.depends_on_order({"memory_request", "memory_interface"});
  for_each_pipeline(join, [&](Pipeline<C>&, unsigned) {
    join.depends_on_order(
        {"node_line", "node_fill", "list_line", "list_fill", "column_line", "matrix_fill"});
  });
}

}  // namespace dynrt
