// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// An `unsigned` sum of two 17-bit numbers is 18 bits wide, and its low half 9: nothing is 32.
// CHECK-NOT: :32
// CHECK: %[[SUM:[0-9]+]]:18 = add
// CHECK-NOT: :32
// CHECK: write sum
#include "hls/ports.h"
namespace netlists {
struct Pair {
  hls::uint<17> a;
  hls::uint<17> b;
  HLS_FIELDS(a, b)
};
struct Unit {
  hls::In<Pair> pair;
  hls::Out<hls::uint<24>> sum;
  void step() {
    const Pair p = pair.read();
    const unsigned x = static_cast<unsigned>(p.a.to_u64());
    const unsigned y = static_cast<unsigned>(p.b.to_u64());
    sum.write(hls::uint<24>::from(x + y));
  }
};
}  // namespace netlists
