// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A RAM that is never written has a read and no write.
// CHECK-NOT: write table
// CHECK: read table if
// CHECK-NOT: write table
#include "hls/ports.h"
namespace netlists {
struct Unit {
  hls::In<hls::uint<4>> in;
  hls::Out<hls::uint<8>> out;
  hls::Ram1R1W<hls::uint<8>, 16> table;
  void step() { out.write(table.read(in.read())); }
};
}  // namespace netlists
