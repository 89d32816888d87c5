// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A sum or a difference that a bit selects becomes one adder; what it was made of is left unused.
// CHECK: ; after merge_add_sub
// CHECK-NOT: = add %
// CHECK: %[[SUM:[0-9]+]]:8 = addsub
// CHECK: write out if %{{[0-9]+}}: %[[SUM]]
#include "hls/ports.h"
namespace netlists {
struct Unit {
  hls::In<hls::uint<17>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const hls::uint<17> x = in.read();
    const hls::uint<8> a = x.bits<7, 0>();
    const hls::uint<8> b = x.bits<15, 8>();
    out.write(x.bit<16>() ? (a - b).as_unsigned().trunc<8>() : (a + b).trunc<8>());
  }
};
}  // namespace netlists
