// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/port_not_constant.h:11: error: this access goes to a port that is not known at compile time; name the port, or index its array with a constant or with the counter of a loop with a constant bound
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<2>> in;
  hls::Out<hls::uint<2>> out[4];
  void step() {
    const hls::uint<2> i = in.read();
    out[i.to_u64()].write(i);
  }
};
}  // namespace errors
