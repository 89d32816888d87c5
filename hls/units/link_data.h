// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What memory and registers answer, as data of the link's answers.
#pragma once

#include "hls/ports.h"
#include "units/link_tokens.h"

namespace dynrt {

template <unsigned Bytes>
struct LinkBeats {
  hls::In<LinkBeat<Bytes>> beat;
  hls::Out<LinkData<Bytes>> data;
  HLS_PORTS(beat, data)

  void step() {
    const LinkBeat<Bytes> b = beat.read();
    LinkData<Bytes> d;
    for (unsigned i = 0; i < Bytes; ++i) {
      d.bytes[i] = uint<8>::from(b.data[i / 2].raw() >> (8 * (i % 2)));
    }
    data.write(d);
  }
};

template <unsigned Bytes>
struct LinkRegisters {
  hls::In<uint<32>> word;
  hls::Out<LinkData<Bytes>> data;
  HLS_PORTS(word, data)

  void step() {
    const uint<32> w = word.read();
    LinkData<Bytes> d;
    for (unsigned i = 0; i < 4; ++i) d.bytes[i] = uint<8>::from(w.raw() >> (8 * i));
    data.write(d);
  }
};

}  // namespace dynrt
