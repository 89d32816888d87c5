// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: ports and registers in parts, one of which has a part of its own.
#pragma once

#include "hls/ports.h"

namespace samples {

using hls::uint;

struct Numbered {
  hls::Config<uint<3>> number;
  HLS_PORTS(number)
};
struct Sender : Numbered {
  hls::Out<uint<11>> sent;
  using PortsOfParts = hls::Parts<Numbered>;
  HLS_PORTS(sent)

  void send(uint<8> value) { sent.write(hls::concat(number.get(), value)); }
};
struct Summing {
  HLS_NO_PORTS
  uint<8> add(uint<8> value) {
    sum = (sum + value).trunc<8>();
    return sum;
  }
  uint<8> sum = 7;
};
struct Parts : Sender, Summing {
  hls::In<uint<8>> in;
  hls::Out<uint<8>> out;
  using PortsOfParts = hls::Parts<Sender, Summing>;
  HLS_PORTS(in, out)

  void step() {
    const uint<8> value = in.read();
    out.write(add(value));
    if (value.bit<0>()) send(value);
  }
};

}  // namespace samples
