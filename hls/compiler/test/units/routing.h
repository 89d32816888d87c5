// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: two Outs and an array of Outs, written under conditions that exclude each other.
#pragma once

#include "hls/ports.h"

namespace samples {

using hls::uint;

struct Packet {
  uint<2> kind;
  uint<2> lane;
  uint<10> load;
  HLS_FIELDS(kind, lane, load)
};

struct Routing {
  hls::In<Packet> left;
  hls::In<uint<5>> right;
  hls::Out<Packet> small;
  hls::Out<Packet> large;
  hls::Out<uint<10>> lane[3];
  HLS_PORTS(left, right, small, large, lane)

  void step() {
    Packet p = left.read();
    const uint<5> r = right.read();
    const bool is_small = p.load < uint<10>(100);
    // Three writes of one Out, of which at most one is reached.
    if (p.kind == uint<2>(0)) {
      small.write(p);
    } else if (p.kind == uint<2>(1)) {
      p.load = (p.load + r).trunc<10>();
      small.write(p);
    } else if (is_small) {
      p.lane = 0;
      small.write(p);
    }
    if (is_small) large.write({0, 1, uint<10>(r)});
    if (!is_small) large.write({3, 2, p.load});
    for (unsigned i = 0; i < 3; ++i) {
      if (p.lane == uint<2>::from(i) || r.bit(i)) lane[i].write(hls::next(p.load));
    }
    if (p.kind == uint<2>(3)) return;
  }
};

}  // namespace samples
