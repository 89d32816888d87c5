// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A switch over all values of its selector is a tree on the selector's bits: three levels of muxes.
// CHECK-NOT: = eq
// CHECK-NOT: = ult
// CHECK-COUNT-7: = mux
// CHECK-NOT: = mux
#include "hls/ports.h"
namespace netlists {
struct Choice {
  hls::uint<3> kind;
  hls::uint<8> a;
  hls::uint<8> b;
  HLS_FIELDS(kind, a, b)
};
struct Unit {
  hls::In<Choice> in;
  hls::Out<hls::uint<8>> out;
  static hls::uint<8> chosen(const Choice& c) {
    switch (c.kind.to_u64()) {
      case 0:
        return c.a;
      case 1:
        return c.b;
      case 2:
        return c.a ^ c.b;
      case 3:
        return c.a & c.b;
      case 4:
        return c.a | c.b;
      case 5:
        return ~c.a;
      case 6:
        return ~c.b;
      default:
        return (c.a + c.b).trunc<8>();
    }
  }
  void step() { out.write(chosen(in.read())); }
};
}  // namespace netlists
