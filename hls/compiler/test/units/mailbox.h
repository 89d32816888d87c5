// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: a RAM row read, searched by a loop with break, changed at a variable place, written.
#pragma once

#include "hls/ports.h"

namespace samples {

using hls::sint;
using hls::uint;

struct Key {
  uint<4> packet;
  uint<5> matrix;
  HLS_FIELDS(packet, matrix)
};

struct Slots {
  std::array<uint<5>, 8> matrix;
  uint<3> next;
  uint<4> used;
  HLS_FIELDS(matrix, next, used)
};

struct Mailbox {
  hls::In<Key> entry;
  hls::Out<Key> fresh;
  hls::Out<Key> seen;
  hls::Ram1R1W<Slots, 16> slots;
  HLS_PORTS(entry, fresh, seen)

  void step() {
    const Key e = entry.read();
    Slots s = slots.read(e.packet);
    bool hit = false;
    for (unsigned i = 0; i < 8; ++i) {
      if (uint<4>::from(i) < s.used && s.matrix[i] == e.matrix) {
        hit = true;
        break;
      }
    }
    if (hit) {
      seen.write(e);
    } else {
      s.matrix[s.next.to_u64()] = e.matrix;
      s.next = hls::next(s.next);
      if (s.used < 8) s.used = hls::next(s.used);
      slots.write(e.packet, s);
      fresh.write(e);
    }
  }
};

}  // namespace samples
