// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Of a product of which only 8 bits are used only 8 bits are computed.
// CHECK: :8 = mul
// CHECK-NOT: :16 = mul
#include "hls/ports.h"
namespace netlists {
struct Unit {
  hls::In<hls::uint<32>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const hls::uint<32> x = in.read();
    out.write((x * (x + hls::uint<1>(1))).trunc<8>());
  }
};
}  // namespace netlists
