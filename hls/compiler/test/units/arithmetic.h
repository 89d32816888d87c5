// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: arithmetic of odd widths, division, shifts, counting and the built-in integers.
#pragma once

#include "hls/ports.h"

namespace samples {

using hls::sint;
using hls::uint;

struct Operands {
  uint<17> a;
  uint<13> b;
  sint<11> c;
  sint<23> d;
  uint<6> by;
  uint<64> wide;
  HLS_FIELDS(a, b, c, d, by, wide)
};

struct Results {
  uint<18> sum;
  sint<18> difference;
  uint<30> product;
  sint<34> signed_product;
  uint<17> quotient;
  uint<13> remainder;
  sint<24> signed_sum;
  uint<17> left;
  uint<17> right;
  uint<5> zeros;
  uint<64> high;
  uint<64> low;
  uint<32> plain;
  uint<32> signed_plain;
  uint<8> flags;
  HLS_FIELDS(sum, difference, product, signed_product, quotient, remainder, signed_sum, left, right,
             zeros, high, low, plain, signed_plain, flags)
};

struct Arithmetic {
  hls::In<Operands> operands;
  hls::Out<Results> results;
  HLS_PORTS(operands, results)

  static uint<32> plain(const Operands& o) {
    const auto x = static_cast<unsigned>(o.a.to_u64());
    const auto y = static_cast<unsigned>(o.b.to_u64());
    const unsigned larger = x > y ? x : y;
    return uint<32>::from(larger * 3 + (x ^ y) + (y | 1) % 5 + x / 7);
  }
  static uint<32> signed_plain(const Operands& o) {
    const auto x = static_cast<int>(o.c.to_s64());
    const auto y = static_cast<int>(o.d.to_s64());
    const int size = x < 0 ? -x : x;
    const int divisor = y == 0 ? 3 : y;
    return uint<32>::from(static_cast<unsigned>(size + x / divisor + x % divisor + (y >> 3)));
  }

  void step() {
    const Operands o = operands.read();
    Results r;
    r.sum = o.a + o.b;
    r.difference = o.a - o.b;
    r.product = o.a * o.b;
    r.signed_product = o.c * o.d;
    const uint<13> divisor = o.b == 0 ? uint<13>(1) : o.b;
    r.quotient = o.a / divisor;
    r.remainder = (o.a - (r.quotient * divisor).trunc<17>()).as_unsigned().trunc<13>();
    r.signed_sum = o.c + o.d;
    r.left = o.a << o.by;
    r.right = o.a >> o.by;
    r.zeros = hls::count_leading_zeros(o.a);
    const auto square = o.wide * o.wide;
    r.high = square.bits<127, 64>();
    r.low = square.bits<63, 0>() >> o.by;
    r.plain = plain(o);
    r.signed_plain = signed_plain(o);
    const bool flags[8] = {
        o.a > o.b,     o.c < o.d,        o.c.negative(),      o.a == o.b,
        o.wide >= o.a, o.by.reaches(17), o.d <= sint<23>(-1), o.a.bits<16, 13>() != uint<4>(0)};
    uint<8> packed;
    for (unsigned i = 0; i < 8; ++i)
      packed = packed | (uint<8>::from(flags[i]) << uint<3>::from(i));
    r.flags = packed;
    results.write(r);
  }
};

}  // namespace samples
