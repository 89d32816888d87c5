// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Two branches that write one Out become one write; a value that no branch sets needs no mux.
// CHECK-NOT: = mux
// CHECK: write out if %[[ENABLE:[0-9]+]]: %[[DATA:[0-9]+]]
// CHECK-NOT: write out
#include "hls/ports.h"
namespace netlists {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const hls::uint<8> x = in.read();
    if (x.bit<0>()) {
      out.write(x);
    } else if (x.bit<1>()) {
      out.write(x);
    }
  }
};
}  // namespace netlists
