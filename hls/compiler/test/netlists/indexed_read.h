// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A read at a variable place of eight elements takes seven muxes on the index's bits, no compare.
// CHECK-NOT: = eq
// CHECK-COUNT-7: = mux
// CHECK-NOT: = mux
#include "hls/ports.h"
namespace netlists {
struct Pick {
  std::array<hls::uint<8>, 8> values;
  hls::uint<3> place;
  HLS_FIELDS(values, place)
};
struct Unit {
  hls::In<Pick> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const Pick p = in.read();
    out.write(p.values[p.place.to_u64()]);
  }
};
}  // namespace netlists
