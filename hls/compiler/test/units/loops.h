// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: loops with break, continue, two levels, bounds of few bits, and an early return.
#pragma once

#include "hls/ports.h"

namespace samples {

using hls::uint;

struct Work {
  uint<3> count;
  uint<16> bits;
  HLS_FIELDS(count, bits)
};
struct Found {
  uint<5> first;
  uint<8> sum;
  uint<8> pairs;
  uint<16> gray;
  HLS_FIELDS(first, sum, pairs, gray)
};

struct Loops {
  hls::In<Work> work;
  hls::Out<Found> found;
  hls::Out<uint<3>> nothing;
  HLS_PORTS(work, found, nothing)

  static uint<5> first_set(uint<16> bits) {
    for (unsigned i = 0; i < 16; ++i) {
      if (bits.bit(i)) return uint<5>::from(i);
    }
    return 16;
  }

  void step() {
    const Work w = work.read();
    if (w.bits == uint<16>(0)) {
      nothing.write(w.count);
      return;
    }
    unsigned sum = 0;
    for (unsigned i = 0; i < static_cast<unsigned>(w.count.to_u64()); ++i) {
      if (!w.bits.bit(i)) continue;
      sum += i + 1;
    }
    unsigned pairs = 0;
    for (unsigned i = 0; i < 6; ++i) {
      for (unsigned j = i + 1; j < 6; ++j) {
        if (w.bits.bit(i) && w.bits.bit(j)) ++pairs;
        if (pairs > 9) break;
      }
    }
    uint<16> gray = w.bits;
    int left = 15;
    while (left > 0 && gray.bit(15)) {
      gray = gray ^ (gray >> uint<1>(1));
      left -= 4;
    }
    found.write({first_set(w.bits), uint<8>::from(sum), uint<8>::from(pairs), gray});
  }
};

}  // namespace samples
