// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Port path: the way of a core to any memory behind one port, which answers late and in any order
// (units/memory_port.h), with a second level of cache before it if the configuration has one. All
// pipelines share it.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "units/bank_path.h"
#include "units/memory_answer.h"
#include "units/memory_fill.h"
#include "units/memory_gather.h"
#include "units/memory_lookup.h"
#include "units/memory_write.h"

namespace dynrt {

template <class C>
struct PortPath {
  MemoryLookup<C> memory_lookup;
  MemoryGather<C> memory_gather;
  MemoryFill<C> memory_fill;
  MemoryAnswer<C> memory_answer;
  MemoryWrite<C> memory_write;

  /// The port.
  std::shared_ptr<hls::Fifo<PortRead<C>>> read;
  std::shared_ptr<hls::Fifo<PortBeat<C>>> beat;
  std::shared_ptr<hls::Fifo<PortWrite<C>>> write;

  static constexpr auto kMissFifo =
      kHasSecondLevel<C> ? hls::WriterFifo::kShort : hls::WriterFifo::kHoldsAll;

  template <class J>
  void name_frame_units(J& /*join*/) {}
  template <class J>
  void name_units(J& join) {
    join.unit("memory_lookup", "memory_lookup", memory_lookup);
    join.unit("memory_gather", "memory_gather", memory_gather);
    join.unit("memory_fill", "memory_fill", memory_fill);
    join.unit("memory_answer", "memory_answer", memory_answer);
    join.unit("memory_write", "memory_write", memory_write);
  }
  auto& line_writer() { return memory_answer; }
  auto& frame_end(PipelinesOf<C>& /*pipelines*/) { return memory_write; }

  void join_frame_writes(hls::Join& /*join*/, PipelinesOf<C>& /*pipelines*/) {}
  void join_misses(hls::Join& join, const hls::Writers<MemoryRequest<C>>& misses,
                   const Banks<C>& /*banks*/, PipelinesOf<C>& pipelines, Startup<C>& startup) {
    read = join.output("memory_read", memory_lookup.read);
    beat = join.input("memory_beat", memory_gather.beat);
    write = join.output("memory_write", memory_write.write);
    hls::Writers<WriteBurst<C>> bursts = {};
    for (Pipeline<C>& p : pipelines) bursts.push_back(&p.shading.burst);
    join.repeat("write_burst", bursts, memory_write.burst);
    join.ram("in_flight", memory_lookup.in_flight, std::array{&memory_fill.in_flight});
    if constexpr (kHasSecondLevel<C>) {
      join_second_level(join, misses, startup);
    } else {
      join.channel<MemoryRequest<C>>("memory_request", misses, {&memory_lookup.request});
      join.channel<PortLine<C>>("port_line", {&memory_gather.line}, {&memory_fill.fill});
      join.channel<MemoryLine<C>>("memory_line", {&memory_fill.line}, {&memory_answer.line});
    }
    join.depends_on_order({"memory_request", "port_line", "memory_line", "memory_lookup",
                           "memory_gather", "memory_fill", "memory_answer"});
  }
  void join_frame_banks(hls::Join& /*join*/, const Banks<C>& /*banks*/,
                        PipelinesOf<C>& /*pipelines*/) {}

 private:
  void join_second_level(hls::Join& join, hls::Writers<MemoryRequest<C>> requests,
                         Startup<C>& startup) {
    // A packet has as many requests on their way as a matrix has columns.
    requests.push_back(&memory_lookup.again);
    requests.push_back(&startup.second, hls::WriterFifo::kShort);
    join.repeat("memory_request", requests, memory_lookup.request, 4 * kPipelines<C> * C::kPackets);
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
  }
};

}  // namespace dynrt
