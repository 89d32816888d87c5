// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Start-up: before a frame the board sends the numbers 0 to N - 1; each frees the packet and
// invalidates the cache lines of that number, as far as the frame uses them.
#pragma once

#include "units/frame.h"
#include "units/ray_generation.h"
#include "units/tokens.h"

namespace dynrt {

template <class C>
struct Startup {
  hls::In<uint<10>> number;
  hls::Config<FrameConfig> frame;
  hls::Out<FreePacket<C>> free;
  hls::Out<CacheFill<C, Node>> node;
  hls::Out<CacheFill<C, ListEntry>> list;
  hls::Out<CacheFill<C, MatrixColumn>> column;
  HLS_PORTS(number, frame, free, node, list, column)

  void step() {
    const uint<10> n = number.read();
    const FrameConfig config = frame.get();
    const Word wide = n;
    if (wide < config.packets) free.write({PacketId<C>::from(n.raw())});
    if (wide <= config.line_mask) {
      node.write({true, {}, n, {}});
      list.write({true, {}, n, {}});
      column.write({true, {}, n, {}});
    }
  }
};

}  // namespace dynrt
