// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: switches, dense and sparse, with and without default, and falling through.
#pragma once

#include "hls/ports.h"

namespace samples {

using hls::uint;

struct Choice {
  uint<3> dense;
  uint<8> sparse;
  uint<16> value;
  HLS_FIELDS(dense, sparse, value)
};
struct Chosen {
  uint<16> dense;
  uint<16> sparse;
  uint<16> through;
  uint<16> closed;
  HLS_FIELDS(dense, sparse, through, closed)
};

struct Switches {
  hls::In<Choice> choice;
  hls::Out<Chosen> chosen;
  HLS_PORTS(choice, chosen)

  static uint<16> dense(uint<3> kind, uint<16> value) {
    switch (kind.to_u64()) {
      case 0:
        return value;
      case 1:
        return ~value;
      case 2:
        return value << uint<2>(2);
      case 3:
        return value >> uint<2>(3);
      case 4:
        return (value + uint<16>(77)).trunc<16>();
      case 5:
        return (value * uint<4>(9)).trunc<16>();
      case 6:
        return value & uint<16>(0x0ff0);
      default:
        return 42;
    }
  }
  static uint<16> sparse(uint<8> kind, uint<16> value) {
    uint<16> result = value;
    switch (kind.to_u64()) {
      case 3:
        result = 1;
        break;
      case 17:
        result = value | uint<16>(0x8000);
        break;
      case 18:
      case 200:
        result = value ^ uint<16>(0x1234);
        break;
      case 255:
        result = hls::next(value);
        break;
    }
    return result;
  }
  static uint<16> through(uint<3> kind, uint<16> value) {
    switch (kind.to_u64()) {
      case 4:
        value = hls::next(value);
        [[fallthrough]];
      case 3:
        value = value << uint<1>(1);
        [[fallthrough]];
      case 1:
        value = ~value;
        break;
      default:
        break;
    }
    return value;
  }

  /// A switch whose default cannot be reached, and an assumption.
  static uint<16> closed(uint<2> kind, uint<16> value) {
    const unsigned long long which = kind.to_u64();
    switch (which) {
      case 0:
        __builtin_assume(which < 1);
        return value;
      case 1:
        return 1;
      case 2:
        return (value + value).trunc<16>();
      case 3:
        return ~value;
      default:
        __builtin_unreachable();
    }
  }
  static uint<16> trapped(uint<2> kind, uint<16> value) {
    if (kind.to_u64() > 3) __builtin_trap();
    return value;
  }

  void step() {
    const Choice c = choice.read();
    const uint<2> low = c.dense.trunc<2>();
    chosen.write({dense(c.dense, c.value), sparse(c.sparse, c.value), through(c.dense, c.value),
                  closed(low, trapped(low, c.value))});
  }
};

}  // namespace samples
