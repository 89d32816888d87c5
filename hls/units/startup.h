// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Start-up: the tokens that the board sends before a frame (units/start.h). A number below
// kFirstPacket invalidates that line of every cache; from kFirstPacket on the numbers free packets.
// The board leaves the caches time to empty in between, so that no packet meets a line of an
// earlier frame.
#pragma once

#include "units/memory_tokens.h"
#include "units/ray_generation.h"
#include "units/start.h"

namespace dynrt {

static_assert(kFirstPacket == 1u << 9, "the highest bit of a token tells packets from lines");

template <class C>
struct Startup {
  hls::In<uint<10>> number;
  hls::Out<FreePacket<C>> free;
  hls::Out<NodeLine<C>> node;
  hls::Out<ListLine<C>> list;
  hls::Out<ColumnLine<C>> column;
  HLS_PORTS(number, free, node, list, column)

  void step() {
    const uint<10> n = number.read();
    if (n.template bit<9>()) {
      free.write({PacketId<C>::from(n.raw())});
    } else {
      node.write({true, {}, NodeAddress<C>::from(n.raw()), {}});
      list.write({true, {}, NodeAddress<C>::from(n.raw()), {}});
      column.write({true, {}, ColumnAddress<C>::from(n.raw()), {}});
    }
  }
};

}  // namespace dynrt
