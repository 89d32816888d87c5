// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joins of the caches with the memory behind them: banks of SRAM, or the port.
#pragma once

#include "units/core.h"

namespace dynrt {

template <class C>
void Core<C>::join_banks(hls::Join& join, const hls::Writers<MemoryRequest<C>>& misses,
                         const Banks<C>& banks) {
  if constexpr (kSlowMemory<C>) {
    join.repeat("memory_request", misses, memory_interface.request);
  } else {
    join.channel<MemoryRequest<C>>("memory_request", misses, {&memory_interface.request});
  }
  for (unsigned i = 0; i < kSceneBanks; ++i) {
    join.bank("bank" + std::to_string(i), memory_interface.bank[i], banks.scene[i]);
  }
  join.depends_on_order({"memory_request", "memory_interface"});
}

template <class C>
void Core<C>::join_port(hls::Join& join, hls::Writers<MemoryRequest<C>> misses) {
  read = join.output("memory_read", memory_lookup.read);
  beat = join.input("memory_beat", memory_gather.beat);
  write = join.output("memory_write", memory_write.write);
  join.repeat("write_burst", writes(&Shading<C>::burst), memory_write.burst);
  join.ram("in_flight", memory_lookup.in_flight, std::array{&memory_fill.in_flight});
  if constexpr (kHasSecondLevel<C>) {
    // A packet has as many requests on their way as a matrix has columns.
    misses.push_back(&memory_lookup.again);
    misses.push_back(&startup.second, hls::WriterFifo::kShort);
    join.repeat("memory_request", misses, memory_lookup.request, 4 * kPipelines<C> * C::kPackets);
    join.channel<PortLine<C>>("port_line", {&memory_gather.line, &memory_lookup.invalidate},
                              {&memory_fill.fill});
    join.channel<MemoryLine<C>>("memory_line", {&memory_fill.line, &memory_lookup.hit},
                                {&memory_answer.line});
    join.ram<hls::Hazard::kTorn>("last_miss", memory_lookup.missed,
                                 std::array{&memory_lookup.last_miss});
    for (unsigned w = 0; w < kSecondWays; ++w) {
      join.ram<hls::Hazard::kTorn>("second_rows" + std::to_string(w), memory_fill.rows[w],
                                   std::array{&memory_lookup.rows[w]});
    }
  } else {
    join.channel<MemoryRequest<C>>("memory_request", misses, {&memory_lookup.request});
    join.channel<PortLine<C>>("port_line", {&memory_gather.line}, {&memory_fill.fill});
    join.channel<MemoryLine<C>>("memory_line", {&memory_fill.line}, {&memory_answer.line});
  }
  join.depends_on_order({"memory_request", "port_line", "memory_line", "memory_lookup",
                         "memory_gather", "memory_fill", "memory_answer"});
}

template <class C>
void Core<C>::join_memory(hls::Join& join, const Banks<C>& banks) {
  constexpr auto kFifo = kHasSecondLevel<C> ? hls::WriterFifo::kShort : hls::WriterFifo::kHoldsAll;
  hls::Writers<MemoryRequest<C>> misses = {};
  for (Pipeline<C>& p : pipeline) {
    misses.push_back(&p.node_lookup.miss, kFifo);
    misses.push_back(&p.list_lookup.miss, kFifo);
    misses.push_back(&p.matrix_lookup.miss, kFifo);
  }
  if constexpr (kHasPort<C>) {
    join_port(join, misses);
  } else {
    join_banks(join, misses, banks);
  }
  auto& lines = line_writer();
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
  if constexpr (!kHasPort<C>) {
    for (unsigned i = 0; i < banks.out.size(); ++i) {
      join.bank("bank" + std::to_string(kFrameBank + i), frame_end().bank[i], banks.out[i]);
    }
  }
  // The misses of a cache depend on the order of the packets, and so do the fetches that follow. Of
  // what does not, each pipeline counts its share, which depends on the order; the sum does not.
  for_each_pipeline(join, [&](Pipeline<C>&, unsigned) {
    join.depends_on_order(
        {"node_line", "node_fill", "list_line", "list_fill", "column_line", "matrix_fill"});
  });
}

}  // namespace dynrt
