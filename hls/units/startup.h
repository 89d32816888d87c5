// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Start-up: the tokens that the board sends before a frame (units/start.h). A number below
// kFirstPacket invalidates that line of every cache, and 0 the whole second level, which meanwhile
// takes no other request; from kFirstPacket on the numbers free packets, in each pipeline one. The
// board leaves the caches time to empty in between, so that no packet meets a line of an earlier
// frame.
#pragma once

#include "units/memory_port.h"
#include "units/ray_generation.h"
#include "units/start.h"

namespace dynrt {

/// Clocks that the last set takes until it is seen to be invalid: as many sets are once more.
inline constexpr unsigned kSetsWritten = 32;

static_assert(kFirstPacket == 1u << 9, "the highest bit of a token tells packets from lines");

/// A part of the start-up: the order to invalidate the second level of cache, if there is one.
template <class C>
struct NoSecondLevel {
  HLS_NO_PORTS
  void empty_second_level(uint<10> /*number*/) {}
};
template <class C>
struct SecondLevelStart {
  hls::Out<MemoryRequest<C>> second;
  HLS_PORTS(second)
  void empty_second_level(uint<10> n) {
    MemoryRequest<C> all;
    all.repeat = kSecondSets<C> - 1 + kSetsWritten;
    all.invalidate = true;
    if (n == uint<10>(0)) second.write(all);
  }
};
template <class C>
using StartOfSecondLevel =
    std::conditional_t<kHasSecondLevel<C>, SecondLevelStart<C>, NoSecondLevel<C>>;

template <class C>
struct Startup : StartOfSecondLevel<C> {
  hls::In<uint<10>> number;
  PortOfEach<kPipelines<C>, hls::Out<FreePacket<C>>> free;
  PortOfEach<kPipelines<C>, hls::Out<NodeLine<C>>> node;
  PortOfEach<kPipelines<C>, hls::Out<ListLine<C>>> list;
  PortOfEach<kPipelines<C>, hls::Out<ColumnLine<C>>> column;
  using PortsOfParts = hls::Parts<StartOfSecondLevel<C>>;
  HLS_PORTS(number, free, node, list, column)

  void step() {
    const uint<10> n = number.read();
    for (unsigned i = 0; i < kPipelines<C>; ++i) {
      if (n.template bit<9>()) {
        FreePacket<C> packet{PacketId<C>::from(n.raw())};
        packet.pipeline = PipelineId<C>::from(i);
        port_of<kPipelines<C>>(free, i).write(packet);
      } else {
        port_of<kPipelines<C>>(node, i).write({true, {}, NodeAddress<C>::from(n.raw()), {}});
        port_of<kPipelines<C>>(list, i).write({true, {}, NodeAddress<C>::from(n.raw()), {}});
        port_of<kPipelines<C>>(column, i).write({true, {}, ColumnAddress<C>::from(n.raw()), {}});
      }
    }
    this->empty_second_level(n);
  }
};

}  // namespace dynrt
