// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: registers of every kind, with reset values.
#pragma once

#include "hls/ports.h"

namespace samples {

using hls::sint;
using hls::uint;

enum class Mode : unsigned char { kAdd, kSubtract, kHold };

struct Command {
  uint<2> mode;
  uint<9> amount;
  uint<2> lane;
  HLS_FIELDS(mode, amount, lane)
};

struct Sums {
  uint<24> total;
  sint<12> balance;
  uint<32> calls;
  uint<9> lane;
  bool odd;
  HLS_FIELDS(total, balance, calls, lane, odd)
};

struct Accumulator {
  hls::In<Command> command;
  hls::Out<Sums> sums;
  HLS_PORTS(command, sums)

  struct State {
    sint<12> balance = -5;
    bool odd = true;
  };
  uint<24> total = 100;
  State state;
  Mode last = Mode::kHold;
  unsigned calls = 0;
  std::array<uint<9>, 4> lanes{};
  uint<96> wide = 1;

  void step() {
    const Command c = command.read();
    const Mode mode = c.mode == uint<2>(0)   ? Mode::kAdd
                      : c.mode == uint<2>(1) ? Mode::kSubtract
                                             : Mode::kHold;
    if (mode == Mode::kAdd) {
      total = (total + c.amount).trunc<24>();
      state.balance = (state.balance + c.amount.to_signed()).trunc<12>();
    } else if (mode == Mode::kSubtract && last != Mode::kSubtract) {
      state.balance = (state.balance - c.amount.to_signed()).trunc<12>();
    }
    state.odd = state.odd != c.amount.bit<0>();
    last = mode;
    lanes[c.lane.to_u64()] = (lanes[c.lane.to_u64()] + c.amount).trunc<9>();
    wide = (wide * uint<3>(5)).trunc<96>();
    Sums out;
    out.total = (total + wide.bits<95, 72>()).trunc<24>();
    out.balance = state.balance;
    out.calls = uint<32>::from(calls);
    out.lane = lanes[(c.lane.to_u64() + 1) % 4];
    out.odd = state.odd;
    sums.write(out);
    if (calls < 1000) ++calls;
  }
};

}  // namespace samples
