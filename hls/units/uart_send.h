// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Bits of a byte for the serial line. A transaction is a bit; link_pins.v holds each for its time.
#pragma once

#include "hls/ports.h"
#include "units/link_tokens.h"

namespace dynrt {

struct UartSend {
  hls::In<NumberedLineByte> byte;
  hls::Out<uint<1>> bit;
  HLS_PORTS(byte, bit)

  void step() {
    const NumberedLineByte b = byte.read();
    // The stop bit, the data, the start bit.
    const uint<10> bits = hls::concat(hls::concat(uint<1>(1), b.job.data), uint<1>(0));
    bit.write(uint<1>((bits >> b.index).bit<0>()));
  }
};

}  // namespace dynrt
