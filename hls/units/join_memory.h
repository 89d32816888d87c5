// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joins of caches, memory interface and memory banks.
#pragma once

#include "units/core.h"

namespace dynrt {

template <class C>
void Core<C>::join_memory(hls::Join& join, const Banks<C>& banks) {
  join.channel<MemoryRequest<C>>("memory_request",
                                 {&node_lookup.miss, &list_lookup.miss, &matrix_lookup.miss},
                                 {&memory_interface.request});
  join.channel<NodeLine<C>>("node_line", {&memory_interface.node, &startup.node},
                            {&node_fill.fill});
  join.channel<ListLine<C>>("list_line", {&memory_interface.list, &startup.list},
                            {&list_fill.fill});
  join.channel<ColumnLine<C>>("column_line", {&memory_interface.column, &startup.column},
                              {&matrix_fill.fill});
  join_cache(join, "node", node_lookup, node_fill);
  join_cache(join, "list", list_lookup, list_fill);
  join_cache(join, "matrix", matrix_lookup, matrix_fill);
  for (unsigned i = 0; i < kSceneBanks; ++i) {
    join.bank("bank" + std::to_string(i), memory_interface.bank[i], banks.scene[i]);
  }
  for (unsigned i = 0; i < banks.out.size(); ++i) {
    join.bank("bank" + std::to_string(kFrameBank + i), shading.bank[i], banks.out[i]);
  }
  // The misses of a cache depend on the order of the packets, and so do the fetches that follow.
  join.depends_on_order({"memory_request", "memory_interface", "node_line", "node_fill",
                         "list_line", "list_fill", "column_line", "matrix_fill"});
}

template <class C>
template <class Lookup, class Fill>
void Core<C>::join_cache(hls::Join& join, const std::string& name, Lookup& lookup, Fill& fill) {
  join.ram<hls::Hazard::kTorn>(name + "_lines", fill.lines, std::array{&lookup.lines});
  join.ram(name + "_waiting", lookup.waiting, std::array{&fill.waiting});
}

}  // namespace dynrt
