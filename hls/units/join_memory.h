// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joins of the caches with the memory behind them: banks of SRAM, or the port.
#pragma once

#include "units/core.h"

namespace dynrt {

template <class C>
void Core<C>::join_memory(hls::Join& join, const Banks<C>& banks) {
  constexpr auto kFifo = MemoryPathOf<C>::kMissFifo;
  hls::Writers<MemoryRequest<C>> misses = {};
  for (Pipeline<C>& p : pipeline) {
    misses.push_back(&p.node_lookup.miss, kFifo);
    misses.push_back(&p.list_lookup.miss, kFifo);
    misses.push_back(&p.matrix_lookup.miss, kFifo);
  }
  memory.join_misses(join, misses, banks, pipeline, startup);
  auto& lines = memory.line_writer();
  for_each_pipeline(join, [&](Pipeline<C>& p, unsigned i) {
    join.channel<NodeLine<C>>(
        "node_line",
        {&port_of<kPipelines<C>>(lines.node, i), &port_of<kPipelines<C>>(startup.node, i)},
        {&p.node_fill.fill});
    join.channel<ListLine<C>>(
        "list_line",
        {&port_of<kPipelines<C>>(lines.list, i), &port_of<kPipelines<C>>(startup.list, i)},
        {&p.list_fill.fill});
    join.channel<ColumnLine<C>>(
        "column_line",
        {&port_of<kPipelines<C>>(lines.column, i), &port_of<kPipelines<C>>(startup.column, i)},
        {&p.matrix_fill.fill});
    p.join_caches(join);
  });
  memory.join_frame_banks(join, banks, pipeline);
  // The misses of a cache depend on the order of the packets, and so do the fetches that follow. Of
  // what does not, each pipeline counts its share, which depends on the order; the sum does not.
  for_each_pipeline(join, [&](Pipeline<C>&, unsigned) {
    join.depends_on_order(
        {"node_line", "node_fill", "list_line", "list_fill", "column_line", "matrix_fill"});
  });
}

}  // namespace dynrt
