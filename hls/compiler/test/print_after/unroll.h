// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// No branch is left of a loop with four rounds; ports are still calls.
// CHECK: call {{.*}}leaf_get
// CHECK-NOT: br i1
// CHECK: call {{.*}}token_commit
#include "hls/ports.h"
namespace netlists {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    hls::uint<8> x = in.read();
    for (int i = 0; i < 4; ++i) x = (x + x).trunc<8>() ^ hls::uint<8>(3);
    out.write(x);
  }
};
}  // namespace netlists
