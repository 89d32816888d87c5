// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Takes bytes off the serial line: a start bit, eight data bits, the lowest first, a stop bit. A
// transaction is a sample of the line, one in each clock. State: place in the byte, its bits.
#pragma once

#include "hls/ports.h"
#include "units/link_tokens.h"

namespace dynrt {

/// Clocks of a bit on the line, at least 4.
using LineDivisor = uint<12>;

struct UartReceive {
  hls::In<uint<1>> sample;
  hls::Config<LineDivisor> divisor;
  hls::Out<LinkEvent> event;
  HLS_PORTS(sample, divisor, event)

  void step() {
    const bool high = bool(sample.read());
    const bool begins = !busy_ && was_high_ && !high;
    const bool due = busy_ && is_due_;
    const bool is_start = bit_ == uint<4>(0);
    const bool is_stop = bit_ == uint<4>(9);
    // A start bit that is over before its middle was a disturbance.
    const bool ends = due && (is_stop || (is_start && high));
    if (due && is_stop) {
      event.write({high ? LinkEventKind::kByte : LinkEventKind::kBadByte, byte_});
    }
    is_due_ = !begins && !due && wait_ == LineDivisor(1);
    if (begins) {
      wait_ = (divisor.get().shr<1>() + LineDivisor::ones()).trunc<12>();
    } else if (due) {
      wait_ = (divisor.get() + LineDivisor::ones()).trunc<12>();
    } else {
      wait_ = (wait_ + LineDivisor::ones()).trunc<12>();
    }
    if (due && !is_stop) byte_ = hls::concat(uint<1>(high), byte_.bits<7, 1>());
    if (begins) {
      bit_ = uint<4>(0);
    } else if (due) {
      bit_ = hls::next(bit_);
    }
    busy_ = begins || (busy_ && !ends);
    was_high_ = high;
  }

 private:
  bool busy_ = false;      ///< in a byte
  bool was_high_ = false;  ///< in the clock before; a line that is low from the start sends nothing
  LineDivisor wait_;       ///< clocks until the middle of the next bit, at least 1 at their begin
  bool is_due_ = false;    ///< they are over
  uint<4> bit_;            ///< 0: the start
  uint<8> byte_;
};

}  // namespace dynrt
