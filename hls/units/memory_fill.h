// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The answering half of the memory port: finds what a read was for, sends it on to its cache, and
// writes the line to the second level if there is one. Before a frame it invalidates set after set.
#pragma once

#include "units/memory_lookup.h"

namespace dynrt {

template <class C>
struct MemoryFill {
  using Row = SecondRow<C>;
  using Rows = hls::RamWrite<Row, kSecondSets<C>>;

  hls::In<PortLine<C>> fill;
  hls::RamRead<ReadInFlight<C>, kPortIds<C>> in_flight;
  hls::Out<MemoryLine<C>> line;
  std::conditional_t<kHasSecondLevel<C>, Rows[kSecondWays], hls::Absent> rows;
  HLS_PORTS(fill, in_flight, line, rows)

  void step() {
    const PortLine<C> f = fill.read();
    const ReadInFlight<C> asked = in_flight.read(hls::to_bits(f.id));
    if constexpr (kHasSecondLevel<C>) {
      const SecondLineNumber<C> number = second_line_of<C>(f.id.kind, asked.address);
      const SecondSet<C> set = f.invalidate ? f.set : SecondSet<C>::from(number.raw());
      for (unsigned w = 0; w < kSecondWays; ++w) {
        if (f.invalidate || asked.way == uint<2>::from(w)) {
          rows[w].write(set, Row{false, !f.invalidate, number, f.data});
        }
      }
      if (!f.invalidate) line.write(MemoryLine<C>{f.id, asked.address, f.data});
    } else {
      line.write(MemoryLine<C>{f.id, asked.address, f.data});
    }
  }
};

}  // namespace dynrt
